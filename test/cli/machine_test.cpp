// Faults of the machine: no database of coordinate systems, too few files, a closed terminal, too little memory.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "cli/child.hpp"
#include "cli/program.hpp"
#include "cli/run_files.hpp"
#include "support/places.hpp"

namespace talus::test {
namespace {

namespace fs = std::filesystem;
using ::testing::AnyOf;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string gis = talus::places::in_source("/examples/first-gis-run/first-gis-run.toml");
const std::string crater = talus::places::in_source("/examples/maungawhau/");

#ifdef TALUS_HAS_GDAL

TEST(Machine, WithoutPROJsDatabaseIsReported) {
  const Said said = talus_says("check " + gis, "PROJ_DATA=/nowhere PROJ_LIB=/nowhere ");
  EXPECT_EQ(said.exit_code, 2);
  EXPECT_THAT(said.text, HasSubstr("valley.tif: coordinate systems cannot be looked up (GDAL: PROJ: "));
  EXPECT_THAT(said.text, HasSubstr("PROJ_DATA is /nowhere: unset it, or set it to the folder of proj.db"));
  EXPECT_THAT(said.text, Not(HasSubstr("has no coordinate system")));
}

TEST(Machine, WithTooFewOpenFilesIsReported) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers open files of their own, and report errors where they cannot";
#endif
  int refused = 0;
  for (int files = 4; files < 40; ++files) {
    const Said said = talus_says("check " + gis, "prlimit --nofile=" + std::to_string(files) + " ");
    if (said.exit_code == 127) continue;  // the program itself could not start
    if (said.exit_code == 0) break;
    EXPECT_EQ(said.exit_code, 2) << said.text;
    EXPECT_THAT(said.text, Not(HasSubstr("no coordinate system"))) << files;
    EXPECT_THAT(said.text, AnyOf(HasSubstr("Too many open files"), HasSubstr("cannot be looked up"))) << files;
    ++refused;
  }
  EXPECT_GT(refused, 0);
}

TEST(Machine, ResultsDoNotContainThePathToTheProject) {
  const Workplace work;
  fs::create_directories(work / "site");
  fs::copy_file(crater + "maungawhau.asc", work / "site/maungawhau.asc");
  std::ifstream in(crater + "maungawhau.toml");
  std::string text{std::istreambuf_iterator<char>(in), {}};
  text.erase(text.find("crs = \"local\"\n"), std::string("crs = \"local\"\n").size());
  (void)work.write("site/a.toml", text);
  const std::string more = " --rocks 50 --set output.report=false -o ";
  const std::string folder = work / "site";
  const std::vector<std::string> runs{"run " + (work / "site/a.toml").string() + more + (work / "whole").string(),
                                      "run a.toml" + more + (work / "here").string(),
                                      "run ./a.toml" + more + (work / "dot").string(),
                                      "run ../site/a.toml" + more + (work / "up").string()};
  for (const std::string& run : runs) {
    const Said said = talus_says(run, "cd " + folder + " && ");
    ASSERT_EQ(said.exit_code, 0) << said.text;
  }
  const auto whole = files_of(work / "whole");
  EXPECT_THAT(whole.at("summary.json"), HasSubstr("raster maungawhau.asc: has no coordinate system"));
  for (const char* other : {"here", "dot", "up"}) EXPECT_EQ(differences(whole, files_of(work / other)), "") << other;
}

#endif

TEST(Machine, ARunDoesNotOverwriteItsInput) {
  const Workplace work;
  const std::string points = "x,y,z\n0,0,9\n50,0,8\n50,50,0\n0,50,1\n25,25,4\n";
  (void)work.write("endpoints.csv", points);
  const std::string project = work.write("a.toml", R"(
[analysis]
model = "lumped_mass"
[terrain]
points = "endpoints.csv"
crs = "local"
[[material]]
name = "Rock"
normal_restitution = 0.4
tangential_restitution = 0.8
friction_angle_deg = 30
[ground]
default = "Rock"
[[seeder]]
type = "point"
position = [20, 20, 12]
rocks = 3
mass_kg = 100
)");
  const Said said = talus_says("run a.toml -o .", "cd " + (work / "").string() + " && ");
  EXPECT_EQ(said.exit_code, 2);
  EXPECT_THAT(said.text, HasSubstr("a.toml:5: [terrain]: points endpoints.csv is in . (a run writes its results there "
                                   "and would replace it). Give the file another name, or write elsewhere with -o"));
  EXPECT_EQ(work.read("endpoints.csv"), points);
  fs::create_symlink(work / "endpoints.csv", work / "link.csv");
  EXPECT_EQ(
      talus_says("run a.toml -o . --set terrain.points=link.csv", "cd " + (work / "").string() + " && ").exit_code, 2);
  EXPECT_EQ(work.read("endpoints.csv"), points);
  EXPECT_EQ(talus_says("run " + project + " -o " + (work / "out").string()).exit_code, 0);
}

std::vector<std::string> long_run(const Workplace& work, const char* folder) {
  return {"run",
          tutorial("2d"),
          "--rocks",
          "200000000",
          "--set",
          "output.paths=none",
          "-o",
          (work / folder).string(),
          "--checkpoint-every",
          "0.01"};
}

TEST(Machine, AClosedTerminalStopsARunWithItsResults) {
  const Workplace work;
  std::signal(SIGHUP, SIG_DFL);  // it may be ignored by the process that started the tests
  Child child(long_run(work, "out"), work / "said");
  ASSERT_TRUE(appears(work / "out/run.state"));
  child.signal(SIGHUP);
  EXPECT_EQ(child.wait(), 3) << work.read("said");
  EXPECT_TRUE(fs::exists(work / "out/summary.json"));

  Child other(long_run(work, "more"), work / "said", {"nohup"});
  ASSERT_TRUE(appears(work / "more/run.state"));
  other.signal(SIGHUP);
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  other.signal(SIGTERM);
  EXPECT_EQ(other.wait(), 3);
  EXPECT_THAT(work.read("said"), HasSubstr("stopped after"));
}

#if defined(TALUS_HAS_GDAL) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

// Wherever memory runs out - in a checkpoint, a table, a destructor - the program reports it and keeps its results.
TEST(Machine, WithoutEnoughMemoryARunKeepsItsResults) {
  const Workplace work;
  const auto arguments = [&](const std::string& folder) {
    return "run " + crater +
           "maungawhau.toml --rocks 20000 --threads 1 --checkpoint-every 0.01 --quiet "
           "--set output.raster_cell_m=0.5 --set output.paths=none --set output.report=false "
           "--set 'output.geopackage=\"none\"' -o " +
           (work / folder).string();
  };
  const Said whole = talus_says(arguments("whole"));
  ASSERT_EQ(whole.exit_code, 0) << whole.text;
  int kept = 0;
  for (int megabytes = 190; megabytes <= 300; megabytes += 10) {
    fs::remove_all(work / "out");
    const Said said = talus_says(arguments("out"), "ulimit -c 0; ulimit -v " + std::to_string(megabytes * 1000) + "; ");
    if (said.exit_code == 127) continue;  // the program itself could not start
    EXPECT_THAT(said.exit_code, AnyOf(0, 2, 4)) << megabytes << " MB: " << said.text;
    if (said.exit_code != 4) continue;
    EXPECT_THAT(said.text, HasSubstr("not enough memory")) << megabytes;
    if (!fs::exists(work / "out/run.state")) continue;
    EXPECT_THAT(said.text, HasSubstr("of 20000 rocks are kept: with --resume it continues from there"));
    if (++kept > 1) continue;
    const Said rest = talus_says(arguments("out") + " --resume");
    EXPECT_EQ(rest.exit_code, 0) << rest.text;
    EXPECT_EQ(differences(files_of(work / "whole"), files_of(work / "out")), "");
  }
  EXPECT_GT(kept, 0);
}

#endif

}  // namespace
}  // namespace talus::test
