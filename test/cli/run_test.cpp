// `talus run` on the command line: outputs, exit codes, threads, interruption, and folders that cannot be written.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>

#include <nlohmann/json.hpp>

#include "cli/program.hpp"

namespace talus {
namespace {

using test::talus_says;
using test::tutorial;
using test::Workplace;

TEST(TalusRun, WritesEveryDocumentedFile) {
  const Workplace place;
  const auto said = talus_says("run " + tutorial("2d") + " -o " + (place / "out").string());
  ASSERT_EQ(said.exit_code, 0) << said.text;
  EXPECT_EQ(place.read("out/endpoints.csv").substr(0, 160),
            "rock,seeder,x_m,y_m,z_m,runout_xy_m,runout_z_m,runout_total_m,lateral_m,time_s,events,end_reason,ground,"
            "mass_kg,radius_m,max_ke_J,max_bounce_m,ensemble\n0,Crest,");
  EXPECT_EQ(place.read("out/paths.csv").substr(0, 133),
            "rock,event,state,time_s,x_m,y_m,z_m,vx_m_s,vy_m_s,vz_m_s,wx_rad_s,wy_rad_s,wz_rad_s,ke_translational_J,"
            "ke_rotational_J,pe_J\n0,0,proje");
  EXPECT_EQ(place.read("out/barriers.csv").substr(0, 155),
            "barrier,rock,time_s,x_m,y_m,z_m,impact_height_m,vx_m_s,vy_m_s,vz_m_s,angle_deg,ke_translational_J,"
            "ke_rotational_J,ke_total_J,outcome,ensemble,top_height_m\n");
  EXPECT_NE(place.read("out/report.html").find("Tutorial 1, section"), std::string::npos);
  const auto summary = nlohmann::json::parse(place.read("out/summary.json"));
  EXPECT_EQ(summary["rocks"]["done"], 50);
  EXPECT_EQ(summary["end_reasons"]["at rest"], 50);
  EXPECT_EQ(summary["project"]["seeder"][0]["rocks"], 50);
  EXPECT_EQ(summary["statistics"]["runout_xy_m"]["count"], 50);
  for (const auto& entry : std::filesystem::directory_iterator(place / "out")) {
    EXPECT_NE(entry.path().extension(), ".part") << "left behind";
  }
}

TEST(TalusRun, RemovesTheReportOfAnEarlierRun) {
  const Workplace place;
  const std::string run = "run " + tutorial("2d") + " -q --rocks 5 -o " + (place / "out").string();
  ASSERT_EQ(talus_says(run).exit_code, 0);
  EXPECT_TRUE(std::filesystem::exists(place / "out/report.html"));
  ASSERT_EQ(talus_says(run + " --set output.report=false").exit_code, 0);
  EXPECT_FALSE(std::filesystem::exists(place / "out/report.html"));
}

TEST(TalusRun, WritesPathsOnlyInTheDocumentedOrderOfStates) {
  const Workplace place;
  ASSERT_EQ(talus_says("run " + tutorial("3d") + " -q --rocks 300 -o " + (place / "out").string()).exit_code, 0);
  std::istringstream rows(place.read("out/paths.csv"));
  std::string line, previous = "ended";
  std::getline(rows, line);
  int releases = 0;
  while (std::getline(rows, line)) {
    std::istringstream fields(line);
    std::string rock, event, state;
    std::getline(fields, rock, ',');
    std::getline(fields, event, ',');
    std::getline(fields, state, ',');
    if (event == "0") {
      EXPECT_EQ(previous, "ended");
      EXPECT_EQ(state, "projectile");
      ++releases;
    } else if (previous == "impact") {
      EXPECT_TRUE(state == "projectile" || state == "sliding" || state == "rolling") << state;
    } else {
      EXPECT_TRUE(state == "impact" || state == "ended") << state << " after " << previous;
    }
    previous = state;
  }
  EXPECT_EQ(releases, 300);
}

TEST(TalusRun, GivesTheSameBytesOnOneTwoAndEightThreads) {
  for (const std::string model : {"lumped_mass", "rigid_sphere"}) {
    const Workplace place;
    for (const std::string threads : {"1", "2", "8"}) {
      ASSERT_EQ(talus_says("run " + tutorial("3d") + " -q --rocks 5000 --set analysis.model=" + model + " --threads " +
                           threads + " -o " + (place / threads).string())
                    .exit_code,
                0);
    }
    for (const std::string file : {"endpoints.csv", "paths.csv", "barriers.csv"}) {
      EXPECT_EQ(place.read("1/" + file), place.read("2/" + file)) << file;
      EXPECT_EQ(place.read("1/" + file), place.read("8/" + file)) << file;
    }
    auto one = nlohmann::json::parse(place.read("1/summary.json"));
    auto eight = nlohmann::json::parse(place.read("8/summary.json"));
    one.erase("timings");
    eight.erase("timings");
    EXPECT_EQ(one, eight);
  }
}

TEST(TalusRun, AnnouncesResultsOfMoreThanAGigabyte) {
  const Workplace place;
  const std::string project = tutorial("3d") + " --rocks 2000000 ";
  const auto said = [&](const std::string& settings) {
    // Only the output before the run is needed.
    return talus_says("run " + project + settings + " -o " + (place / "out").string(), "timeout -s INT 3 ").text;
  };
  // 20,000 of these rocks fill 59.8 MB of paths, and 4.2 MB of ends.
  const char* expected =
      "The results will take about 6\\.. GB \\(paths.csv 6\\.. GB, endpoints.csv 4.. MB, "
      "barriers.csv 3.. MB\\), the run about [0-9]+ (s|min) on [0-9]+ threads? if the disk keeps up; "
      "less with output.paths = 300 or output.endpoints = \"none\"";
  EXPECT_THAT(said("--set output.paths=all"), ::testing::ContainsRegex(expected));
  EXPECT_THAT(talus_says("check " + project + "--set output.paths=all").text, ::testing::ContainsRegex(expected));
  EXPECT_THAT(said(""), ::testing::Not(::testing::HasSubstr("The results")));
  EXPECT_THAT(talus_says("check " + project).text, ::testing::Not(::testing::HasSubstr("will take about")));
}

TEST(TalusRun, KeepsThePathsOfSomeRocksAndTheEndsOfAll) {
  const Workplace place;
  const auto rows_of = [&](const char* table, const std::string& settings) {
    EXPECT_EQ(
        talus_says("run " + tutorial("2d") + " -q --rocks 5000 -o " + (place / "out").string() + settings).exit_code,
        0);
    std::set<std::string> rocks;
    std::istringstream text(place.read(std::string("out/") + table));
    std::string line;
    std::getline(text, line);
    while (std::getline(text, line)) rocks.insert(line.substr(0, line.find(',')));
    return rocks;
  };
  const auto paths = rows_of("paths.csv", "");
  EXPECT_EQ(paths.size(), 300U);
  EXPECT_EQ(rows_of("endpoints.csv", "").size(), 5000U);
  const std::string off = " --set output.endpoints=none";
  EXPECT_EQ(rows_of("endpoints.csv", off), paths) << "a rock with a path has its end there";
  EXPECT_EQ(rows_of("endpoints.csv", off + " --set output.paths=none").size(), 0U);
  const auto summary = nlohmann::json::parse(place.read("out/summary.json"));
  EXPECT_EQ(summary["rocks"]["done"], 5000);
  EXPECT_EQ(summary["rocks"]["with_endpoint"], 0);
  EXPECT_EQ(summary["rocks"]["with_path"], 0);
}

TEST(TalusRun, WritesToAFolderNamedAfterTheProjectByDefault) {
  const Workplace place;
  ASSERT_EQ(talus_says("new " + (place / "slope.toml").string()).exit_code, 0);
  const auto said = talus_says("run " + (place / "slope.toml").string() + " --set name=Cliff -q");
  ASSERT_EQ(said.exit_code, 0) << said.text;
  EXPECT_TRUE(std::filesystem::exists(place / "Cliff/summary.json"));
}

TEST(TalusRun, KeepsItsResultsWhenItIsStopped) {
  const Workplace place;
  // The signal comes after the first results, and long before two hundred million rocks are finished.
  const auto said = talus_says(
      "run " + tutorial("2d") + " --rocks 200000000 -q --set output.paths=none -o " + (place / "out").string(),
      "timeout --preserve-status -s INT 2 ");
  EXPECT_EQ(said.exit_code, 3) << said.text;
  EXPECT_NE(said.text.find("stopped after "), std::string::npos);
  const auto summary = nlohmann::json::parse(place.read("out/summary.json"));
  EXPECT_EQ(summary["interrupted"], true);
  const std::uint64_t done = summary["rocks"]["done"];
  EXPECT_GT(done, 0U);
  const std::string endpoints = place.read("out/endpoints.csv");
  EXPECT_EQ(static_cast<std::uint64_t>(std::count(endpoints.begin(), endpoints.end(), '\n')), done + 1);
}

TEST(TalusRun, ReportsAFolderThatItCannotCreate) {
  const Workplace place;
  place.write("taken", "a file");
  const auto said = talus_says("run " + tutorial("2d") + " -q -o " + (place / "taken").string());
  EXPECT_EQ(said.exit_code, 2);
  EXPECT_EQ(said.text, (place / "taken").string() +
                           ": cannot create this folder (Not a directory). Choose another folder with -o\n");
}

TEST(TalusRun, ReportsTheFileSizeLimit) {
  const Workplace place;
  // Without paths only the table of end points grows.
  const auto said = talus_says("run " + tutorial("2d") + " -q --set output.paths=none -o " + (place / "out").string(),
                               "ulimit -f 1; ");
  EXPECT_EQ(said.exit_code, 2);
  EXPECT_EQ(said.text,
            (place / "out/endpoints.csv").string() +
                ": cannot write to this file (File too large). Allow larger files (ulimit -f), or write elsewhere with "
                "-o\n");
  EXPECT_FALSE(std::filesystem::exists(place / "out/endpoints.csv"));
}

TEST(TalusRun, ReportsBeforehandWhatBlocksItsResults) {
  const Workplace place;
  for (const char* folder : {"out/endpoints.csv", "out/summary.json", "out/report.html.part", "out/run.state"})
    std::filesystem::create_directories(place / folder);
  const auto said = talus_says("run " + tutorial("2d") + " --rocks 200000000 -q -o " + (place / "out").string());
  EXPECT_EQ(said.exit_code, 2);
  std::string expected;
  for (const char* folder : {"out/endpoints.csv", "out/report.html.part", "out/summary.json", "out/run.state"})
    expected += (place / folder).string() +
                ": cannot write this result (it is a folder). Remove it, or write elsewhere with -o\n";
  EXPECT_EQ(said.text, expected);
}

TEST(TalusRun, SpreadsTheRequestedPathsOverTheRocks) {
  const Workplace place;
  ASSERT_EQ(talus_says("run " + tutorial("2d") + " -q --rocks 100 --set output.paths=4 -o " + (place / "out").string())
                .exit_code,
            0);
  std::istringstream rows(place.read("out/paths.csv"));
  std::string line;
  std::set<int> rocks, quarters;
  std::getline(rows, line);
  while (std::getline(rows, line)) rocks.insert(std::stoi(line.substr(0, line.find(','))));
  for (const int rock : rocks) quarters.insert(rock / 25);
  EXPECT_EQ(rocks.size(), 4U);
  EXPECT_EQ(quarters, (std::set<int>{0, 1, 2, 3}));
}

TEST(TalusReplay, RepeatsARockExactly) {
  const Workplace place;
  ASSERT_EQ(talus_says("run " + tutorial("3d") + " -q -o " + (place / "out").string()).exit_code, 0);
  std::istringstream all(place.read("out/paths.csv"));
  std::string line, rock_17;
  std::getline(all, line);
  rock_17 = line + "\n";
  while (std::getline(all, line)) {
    if (line.rfind("17,", 0) == 0) rock_17 += line + "\n";
  }
  const auto said = talus_says("replay " + tutorial("3d") + " --rock 17 --csv");
  EXPECT_EQ(said.exit_code, 0);
  EXPECT_EQ(said.text, rock_17);
}

TEST(TalusReplay, RefusesARockBeyondTheLast) {
  const auto said = talus_says("replay " + tutorial("2d") + " --rock 50");
  EXPECT_EQ(said.exit_code, 2);
  EXPECT_EQ(said.text, tutorial("2d") + ": --rock: there is no rock 50 (the project has rocks 0 to 49)\n");
}

TEST(TalusCommandLine, PrintsItsVersionAndRefusesUnknownCommands) {
  EXPECT_EQ(talus_says("--version").text, "talus 0.1.0\n");
  EXPECT_EQ(talus_says("").exit_code, 2);
  EXPECT_EQ(talus_says("rnu").exit_code, 2);
  EXPECT_EQ(talus_says("run").exit_code, 2);
  EXPECT_EQ(talus_says("run --help").exit_code, 0);
  EXPECT_EQ(talus_says("run /nowhere/slope.toml").exit_code, 2);
}

TEST(TalusReport, ComparesTwoRuns) {
  const Workplace place;
  for (const std::string d : {"2d", "3d"}) {
    ASSERT_EQ(talus_says("run " + tutorial(d.c_str()) + " -q -o " + (place / d).string()).exit_code, 0);
  }
  const auto said = talus_says("report " + (place / "2d").string() + " " + (place / "3d").string());
  EXPECT_EQ(said.exit_code, 0) << said.text;
  const std::string page = place.read("2d/compare.html");
  EXPECT_NE(page.find("Tutorial 1, section"), std::string::npos);
  EXPECT_NE(page.find("Tutorial 1, extruded"), std::string::npos);
}

}  // namespace
}  // namespace talus
