// Hostile input to the program itself: it exits with a message and code 2 within a short time.

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "program.hpp"

namespace talus::test {
namespace {

const std::string good = R"([terrain]
section = [[0, 0], [10, -10]]
[[material]]
name = "Rock"
[[seeder]]
position = [1, "surface"]
mass_kg = 10
)";

std::string without(std::string text, const std::string& folder) {
  for (auto at = text.find(folder); at != std::string::npos; at = text.find(folder)) text.erase(at, folder.size());
  return text;
}

/// The exit code and the output, without the folder's name.
std::string said(const Workplace& place, const std::string& arguments, const std::string& before = "") {
  const Said answer = talus_says(arguments, before);
  return std::to_string(answer.exit_code) + ' ' + without(answer.text, (place / "").string());
}

TEST(RefusedByTheProgram, AnEmptyFileName) {
  const Workplace place;
  EXPECT_EQ(said(place, "check ''"), "2 \"\": the file name is empty (expected the name of a project file)\n");
}

TEST(RefusedByTheProgram, NegativeNumbers) {
  const Workplace place;
  const std::string file = place.write("slope.toml", good);
  EXPECT_EQ(said(place, "run " + file + " --seed -1"), "2 --seed: expected 0 or more\nSee `talus run --help`.\n");
  EXPECT_EQ(said(place, "replay " + file + " --rock -1"), "2 --rock: expected 0 or more\nSee `talus replay --help`.\n");
}

TEST(RefusedByTheProgram, NumbersBeyond64Bits) {
  const Workplace place;
  const std::string file = place.write("slope.toml", good), most = "expected at most 9223372036854775807\n";
  EXPECT_EQ(said(place, "check " + file + " --seed 99999999999999999999"),
            "2 --seed: 99999999999999999999 is too large; " + most + "See `talus check --help`.\n");
  EXPECT_EQ(said(place, "replay " + file + " --rock 18446744073709551616"),
            "2 --rock: 18446744073709551616 is too large; " + most + "See `talus replay --help`.\n");
  EXPECT_EQ(said(place, "check " + file + " --seed 9223372036854775808"),
            "2 --seed: 9223372036854775808 is too large; " + most + "See `talus check --help`.\n");
  EXPECT_EQ(talus_says("check " + file + " --seed 9223372036854775807").exit_code, 0);
  EXPECT_EQ(
      said(place, "check " + file + " --rocks 99999999999999999999"),
      "2 --rocks: 99999999999999999999 is not a number of rocks; expected 1 to 1e12\nSee `talus check --help`.\n");
}

TEST(RefusedByTheProgram, TextsThatAreNotWholeNumbers) {
  const Workplace place;
  const std::string file = place.write("slope.toml", good), help = " --help`.\n";
  EXPECT_EQ(said(place, "run " + file + " --rocks ''"), "2 --rocks: \"\" is not a whole number\nSee `talus run" + help);
  EXPECT_EQ(said(place, "run " + file + " --seed ''"), "2 --seed: \"\" is not a whole number\nSee `talus run" + help);
  EXPECT_EQ(said(place, "replay " + file + " --rock ''"),
            "2 --rock: \"\" is not a whole number\nSee `talus replay" + help);
  EXPECT_EQ(said(place, "run " + file + " --rocks 1e3"),
            "2 --rocks: \"1e3\" is not a whole number\nSee `talus run" + help);
  EXPECT_NE(said(place, "check " + file + " --rocks 010").find("no errors; 10 rocks"), std::string::npos);
}

TEST(TheProgram, AcceptsSettingsBeforeAndAfterTheProject) {
  const Workplace place;
  const std::string file = place.write("slope.toml", good),
                    set = " --set analysis.gravity_m_s2=9 --set material.Rock.friction_angle_deg=60 ";
  const std::string out = " -q -o " + (place / "out").string();
  EXPECT_EQ(said(place, "run" + set + file + out), "0 ");
  EXPECT_EQ(said(place, "run" + set + set + file + out + set), "0 ");
  EXPECT_EQ(said(place, "run " + file + set + out), "0 ");
  EXPECT_EQ(said(place, "replay" + set + file + " --rock 0"), said(place, "replay " + file + " --rock 0" + set));
}

// The limit of processes, which counts threads, does not apply to the superuser.
TEST(RefusedByTheProgram, MoreThreadsThanTheSystemAllows) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "a sanitizer has a thread of its own";
#endif
  if (geteuid() != 0 || std::system("setpriv --version > /dev/null && prlimit --version > /dev/null") != 0)
    GTEST_SKIP() << "cannot run as another user";
  const Workplace place;
  std::filesystem::permissions(place / "", std::filesystem::perms::all);
  const std::string run = "run " + place.write("slope.toml", good) +
                          " --set material.Rock.friction_angle_deg=60 -q -o " + (place / "out").string();
  const std::string alone = "setpriv --reuid=54321 --clear-groups prlimit --nproc=1 ";
  EXPECT_EQ(said(place, run + " --threads 8", alone),
            "2 --threads: 8 threads are not available (Resource temporarily unavailable). Try --threads 1\n");
  EXPECT_EQ(said(place, run + " --threads 1", alone), "0 ");
  EXPECT_EQ(said(place, "replay " + (place / "slope.toml").string() + " --rock 0 > /dev/null", alone), "0 ");
}

TEST(RefusedByTheProgram, ToReplaceFilesThatItHasNotWritten) {
  const Workplace place;
  const std::string run = (place / "run").string(), file = place.write("slope.toml", good);
  ASSERT_EQ(talus_says("run " + file + " -q -o " + run).exit_code, 0);
  const auto refused = [](const std::string& name, const std::string& kind) {
    return "2 " + name + ": this file already exists (it is not a " + kind +
           " written by this command, and only those are replaced). Choose another name\n";
  };
  for (const std::string name : {"run/endpoints.csv", "run/summary.json", "slope.toml"}) {
    const std::string before = place.read(name), at = (place / name).string();
    EXPECT_EQ(said(place, "report " + run + " -o " + at), refused(name, "page"));
    EXPECT_EQ(said(place, "verify --json " + at), refused(name, "comparison"));
    EXPECT_EQ(said(place, "verify --page " + at), refused(name, "page"));
    EXPECT_EQ(place.read(name), before);
  }
  EXPECT_EQ(said(place, "report " + run), "0 run/report.html\n");
  for (int twice = 0; twice < 2; ++twice) {
    EXPECT_EQ(said(place, "report " + run + " -o " + (place / "page.html").string()), "0 page.html\n");
    EXPECT_EQ(
        talus_says("verify 3-sliding --json " + (place / "v.json").string() + " --page " + (place / "v.md").string())
            .exit_code,
        0);
  }
}

TEST(RefusedByTheProgram, ToServeADevice) {
  const Workplace place;
  const std::string answer = said(place, "serve /dev/null --port 0", "timeout 20 ");
  if (answer.find("without the workbench") != std::string::npos) GTEST_SKIP() << answer;
  EXPECT_EQ(answer, "2 /dev/null: this is not a regular file (expected a project file, for example slope.toml)\n");
}

TEST(RefusedByTheProgram, EmptyValuesOfOptions) {
  const Workplace place;
  const std::string file = place.write("slope.toml", good), run_help = "See `talus run --help`.\n";
  EXPECT_EQ(said(place, "run " + file + " --shard ''"),
            "2 --shard: \"\" is not a shard; expected i/n with i from 1 to n, for example 2/7\n" + run_help);
  EXPECT_EQ(said(place, "run " + file + " -o ''"), "2 --output: \"\" is not a folder name\n" + run_help);
  EXPECT_EQ(said(place, "merge a -o ''"), "2 --output: \"\" is not a folder name\nSee `talus merge --help`.\n");
  EXPECT_EQ(said(place, "report a -o ''"), "2 --output: \"\" is not a file name\nSee `talus report --help`.\n");
  EXPECT_EQ(said(place, "verify --json ''"), "2 --json: \"\" is not a file name\nSee `talus verify --help`.\n");
  EXPECT_EQ(said(place, "run " + file + " --output= --quiet"), "2 --output= has no value\nSee `talus --help`.\n");
  EXPECT_EQ(said(place, "new ''"), "2 file: \"\" is not a file name\nSee `talus new --help`.\n");
}

TEST(RefusedByTheProgram, ToWriteToPipesFoldersAndDevices) {
  const Workplace place;
  ASSERT_EQ(::mkfifo((place / "pipe").c_str(), 0600), 0);
  std::filesystem::create_directories(place / "folder");
  std::filesystem::create_symlink("/dev/null", place / "link");
  const std::string hint = "). Name an ordinary file, or one that does not exist yet\n";
  EXPECT_EQ(said(place, "new --force " + (place / "pipe").string(), "timeout 20 "),
            "2 pipe: cannot write this file (it is a pipe" + hint);
  EXPECT_EQ(said(place, "verify --json " + (place / "folder").string()),
            "2 folder: cannot write this file (it is a folder" + hint);
  EXPECT_EQ(said(place, "verify --page " + (place / "link").string()),
            "2 link: cannot write this file (it is a device" + hint);
  EXPECT_TRUE(std::filesystem::is_fifo(place / "pipe"));
  EXPECT_TRUE(std::filesystem::is_symlink(place / "link"));
}

TEST(TheProgram, WritesThroughLinks) {
  const Workplace place;
  place.write("real.toml", "old");
  std::filesystem::create_symlink("real.toml", place / "link.toml");
  const Said answer = talus_says("new --force " + (place / "link.toml").string());
  EXPECT_EQ(answer.exit_code, 0) << answer.text;
  EXPECT_TRUE(std::filesystem::is_symlink(place / "link.toml"));
  EXPECT_NE(place.read("real.toml"), "old");
}

TEST(TheProgram, ReportsThatStandardOutputIsFull) {
  if (!std::filesystem::is_character_file("/dev/full")) GTEST_SKIP() << "there is no /dev/full";
  const Workplace place;
  const std::string file = place.write("slope.toml", good);
  const std::string expected =
      "2 standard output: the output is incomplete (No space left on device). Free some space, or redirect it "
      "elsewhere\n";
  for (const std::string command : {"schema", "materials", "--version", "--help"}) {
    SCOPED_TRACE(command);
    EXPECT_EQ(said(place, command + " 2>&1 > /dev/full )", "( "), expected);
  }
  for (const std::string command : {"check ", "replay --rock 0 --csv ", "replay --rock 0 "}) {
    SCOPED_TRACE(command);
    EXPECT_EQ(said(place, command + file + " 2>&1 > /dev/full )", "( "), expected);
  }
}

TEST(RefusedByTheProgram, AnUnknownCommand) {
  const Workplace place;
  const std::string known =
                        "(known commands: run, serve, merge, calibrate, check, replay, line, section, what-if, compare, report, "
                        "export, sensitivity, verify, validate, materials, schema, new, manual, completion)",
                    help = "\nSee `talus --help`.\n";
  EXPECT_EQ(said(place, "rnu slope.toml"), "2 there is no command \"rnu\". Did you mean \"run\"?" + help);
  EXPECT_EQ(said(place, "slope.toml"),
            "2 there is no command \"slope.toml\". Did you mean `talus run slope.toml`?" + help);
  EXPECT_EQ(said(place, "throw slope.toml"), "2 there is no command \"throw\" " + known + help);
  EXPECT_EQ(said(place, ""), "2 the command is missing " + known + help);
  EXPECT_EQ(said(place, "--verison"), "2 the command is missing " + known + ". Did you mean --version?" + help);
}

TEST(RefusedByTheProgram, AnUnknownOption) {
  const Workplace place;
  EXPECT_EQ(said(place, "run slope.toml --thread=2"),
            "2 The following argument was not expected: --thread=2. Did you mean --threads?\n"
            "See `talus run --help`.\n");
  EXPECT_EQ(said(place, "check slope.toml --gravity"),
            "2 The following argument was not expected: --gravity\nSee `talus check --help`.\n");
}

TEST(RefusedByTheProgram, AKeyOfVeryManyParts) {
  const Workplace place;
  std::string parts;
  for (int k = 0; k < 300'000; ++k) parts += "a.";
  const std::string file = place.write("slope.toml", parts + "a = 1\n");
  EXPECT_EQ(said(place, "check " + file),
            "2 slope.toml:1: a key has more than 16 parts (the longest keys of a project have three, such as "
            "[material.normal_restitution] mean)\n");
}

TEST(RefusedByTheProgram, NanAsTimeBetweenCheckpoints) {
  const Workplace place;
  const std::string file = place.write("slope.toml", good);
  EXPECT_EQ(said(place, "run " + file + " --checkpoint-every nan -o " + (place / "out").string()),
            "2 --checkpoint-every: nan is not a time (expected seconds, 0 or more)\n");
}

TEST(RefusedByTheProgram, ASummaryThatIsAPipe) {
  const Workplace place;
  std::filesystem::create_directories(place / "run");
  ASSERT_EQ(::mkfifo((place / "run/summary.json").c_str(), 0600), 0);
  EXPECT_EQ(said(place, "report " + (place / "run").string(), "timeout 20 "),
            "2 run/summary.json: cannot be opened (it is a pipe). Name a folder that `talus run` has written\n");
}

TEST(TheProgram, RunsAProjectWhoseNameIsNotUtf8) {
  const Workplace place;
  const std::string file = place.write("sl\xFFope.toml", good);
  const Said answer = talus_says("run " + file + " -q -o " + (place / "out").string());
  EXPECT_EQ(answer.exit_code, 0) << answer.text;
  EXPECT_NE(place.read("out/summary.json").find("\"name\": \"sl\xEF\xBF\xBDope\""), std::string::npos);
}

#ifdef TALUS_HAS_GDAL

const std::string on_raster = R"([terrain]
raster = "dem.vrt"
[[material]]
name = "Rock"
[[seeder]]
position = [400010, 299990, "surface"]
mass_kg = 10
)";

std::string vrt(const std::string& columns, const std::string& rows) {
  return "<VRTDataset rasterXSize=\"" + columns + "\" rasterYSize=\"" + rows +
         "\"><SRS>EPSG:31287</SRS><GeoTransform>400000,1,0,300000,0,-1</GeoTransform><VRTRasterBand "
         "dataType=\"Float32\" band=\"1\"/></VRTDataset>";
}

TEST(RefusedByTheProgram, ARasterOfTooManyCells) {
  const Workplace place;
  const std::string file = place.write("slope.toml", on_raster);
  place.write("dem.vrt", vrt("1000000", "1000000"));
  EXPECT_EQ(said(place, "check " + file),
            "2 slope.toml:2: [terrain]: raster dem.vrt: has 1000000 x 1000000 cells (Talus reads fewer than "
            "2147483648). Cut it to the slope: "
            "gdal_translate -projwin WEST NORTH EAST SOUTH dem.vrt dem_slope.tif\n");
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // sanitizers reserve terabytes of addresses

TEST(RefusedByTheProgram, ARasterThatNeedsTooMuchMemory) {
  const Workplace place;
  const std::string file = place.write("slope.toml", on_raster);
  place.write("dem.vrt", vrt("40000", "30000"));
  EXPECT_EQ(said(place, "check " + file, "ulimit -v 4000000; "),
            "2 slope.toml:2: [terrain]: raster dem.vrt: has 40000 x 30000 cells (they need 4.8 GB of memory; a terrain "
            "may take half of the 4.1 GB available). Cut it to the slope: "
            "gdal_translate -projwin WEST NORTH EAST SOUTH dem.vrt dem_slope.tif\n");
}

// The warning is printed before the raster is read.
TEST(TheProgram, WarnsOfALargeRasterThatFits) {
  const Workplace place;
  const std::string file = place.write("slope.toml", on_raster);
  place.write("dem.vrt", vrt("8800", "8800"));
  const std::string text = said(place, "check " + file, "ulimit -v 3000000; ");
  EXPECT_NE(text.find("slope.toml:2: warning: [terrain]: raster dem.vrt: has 8800 x 8800 cells (they take 0.3 GB of "
                      "memory). Cut it to the slope: "
                      "gdal_translate -projwin WEST NORTH EAST SOUTH dem.vrt dem_slope.tif"),
            std::string::npos)
      << text;
}

#endif

TEST(RefusedByTheProgram, ATerrainThatIsAPipe) {
  const Workplace place;
  const std::string file = place.write("slope.toml", on_raster);
  ASSERT_EQ(::mkfifo((place / "dem.vrt").c_str(), 0600), 0);
  EXPECT_EQ(said(place, "check " + file, "timeout 20 "),
            "2 slope.toml:2: [terrain]: raster dem.vrt: cannot be read (it is a pipe). Name a file\n");
}

#endif

}  // namespace
}  // namespace talus::test
