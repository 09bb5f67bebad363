// Observed stops: reading, refusing and comparing them.

#include "talus/report/observed_stops.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "cli/program.hpp"
#include "cli/run_files.hpp"
#include "support/sample_run.hpp"
#include "talus/archive/table_columns.hpp"
#include "talus/report/observed_comparison.hpp"
#include "talus/report/report.hpp"

namespace talus {
namespace {

using test::talus_says;
using test::Workplace;
using ::testing::HasSubstr;

RunSummary section_run() {
  RunSummary run;
  run.terrain.kind = "section";
  run.terrain.section = {{0, 0}, {3.1, -12.2}, {6.7, -12.2}};
  return run;
}

RunSummary map_run() {
  RunSummary run;
  run.terrain.kind = "raster";
  run.terrain.bounds = {{2'600'000, 1'200'000, 400}, {2'600'020, 1'200'010, 410}};
  run.terrain.relief = Relief{.x0 = 2'600'000, .y0 = 1'200'000, .cell_m = 10, .columns = 3, .rows = 2};
  run.terrain.relief->z_m = {400, 402, 404, 400, 402, 404};
  return run;
}

/// The messages about a file, without the path of its folder.
std::string message(const sample_run::Folder& folder, const std::string& name, const RunSummary& run) {
  Problems warnings;
  std::string text = "read";
  try {
    (void)read_observed_stops(folder.path / name, run, warnings);
    if (!warnings.list().empty()) text = warnings.text();
  } catch (const BadInput& bad) {
    text = bad.what();
  }
  const std::string place = folder.path.string() + "/";
  for (std::size_t at; (at = text.find(place)) != std::string::npos;) text.erase(at, place.size());
  return text;
}

TEST(ObservedStopsReader, ReadsTheUsualTables) {
  const sample_run::Folder folder("observed");
  folder.write("stops.csv",
               "Name,X (m),Y [m],Z_m,mass_kg,note\nA,2600001,1200002,400,1500,big\nB,2600011,1200003,,,\n");
  Problems warnings;
  const ObservedStops read = read_observed_stops(folder.path / "stops.csv", map_run(), warnings);
  ASSERT_EQ(read.stops.size(), 2U);
  EXPECT_EQ(read.stops[0].x_m, 2600001);
  EXPECT_EQ(read.stops[0].y_m, 1200002);
  EXPECT_EQ(read.stops[0].z_m, 400);
  EXPECT_EQ(read.stops[0].name, "A");
  EXPECT_EQ(read.stops[0].mass_kg, 1500);
  EXPECT_FALSE(read.stops[1].z_m);
  EXPECT_FALSE(read.stops[1].mass_kg);
  EXPECT_TRUE(warnings.list().empty());

  folder.write("semicolons.txt", "x;z\n1,5;-4\n");
  const ObservedStops decimal = read_observed_stops(folder.path / "semicolons.txt", section_run(), warnings);
  EXPECT_EQ(decimal.stops.at(0).x_m, 1.5);
  EXPECT_EQ(decimal.stops.at(0).z_m, -4);
}

TEST(ObservedStopsReader, RefusesWhatCannotBeCompared) {
  const sample_run::Folder folder("observed");
  const auto of = [&](const std::string& text, const RunSummary& run) {
    folder.write("stops.csv", text);
    return message(folder, "stops.csv", run);
  };
  EXPECT_EQ(of("a,b\n1,2\n", map_run()),
            "stops.csv: has no column x (its columns are a, b). Name the columns in the first line: x, y");
  EXPECT_EQ(of("x,z\n1,2\n", map_run()),
            "stops.csv: has no column y (its columns are x, z). Name the columns in the first line: x, y");
  EXPECT_EQ(of("y\n1\n", section_run()),
            "stops.csv: has no column x (its columns are y). Name the columns in the first line: x, or x and z");
  EXPECT_EQ(of("x,y\n", map_run()), "stops.csv: has no stops (it has no rows). Write one row for each stop");
  EXPECT_EQ(of("x,y\nnan,1200002\n2600001,here\n", map_run()),
            "stops.csv:2: x is \"nan\" (expected a number)\nstops.csv:3: y is \"here\" (expected a number)");
  EXPECT_EQ(
      of("x,y\n2600001,1200002\n2600001,1200020\n", map_run()),
      "stops.csv:3: a stop at (2600001, 1200020) is outside the terrain (which reaches from (2600000, 1200000) to "
      "(2600020, 1200010)). Check the coordinate system, and the order of x and y");
  EXPECT_THAT(of("x,y\n7.43,46.95\n", map_run()), HasSubstr("These look like degrees"));
  EXPECT_EQ(
      of("x\n7\n", section_run()),
      "stops.csv:2: a stop at x = 7 is outside the terrain (which reaches from x = 0 to 6.7). Check the coordinate "
      "system, and the order of x and y");
  EXPECT_THAT(message(folder, "missing.csv", map_run()), HasSubstr("cannot be read"));
  folder.write("stops.gpkg", "");
  EXPECT_THAT(message(folder, "stops.gpkg", section_run()), HasSubstr("a section has x, but no coordinates on plan"));
}

TEST(ObservedStopsReader, WarnsOfHeightsOffTheTerrain) {
  const sample_run::Folder folder("observed");
  const std::string after =
      "(another datum, or another state of the terrain). Only their places on plan are compared; check these if x and "
      "y "
      "come from the same source";
  folder.write("map.csv", "x,y,z\n2600005,1200005,401\n2600005,1200005,403.5\n2600015,1200005,398\n2600015,1200005,\n");
  EXPECT_EQ(message(folder, "map.csv", map_run()),
            "map.csv: warning: 2 of 3 stops with a height are more than 1 m off the terrain, up to 4.0 m " + after);
  folder.write("section.csv", "x,z\n5,-12.2\n5,-11.3\n5,-9\n");
  EXPECT_EQ(message(folder, "section.csv", section_run()),
            "section.csv: warning: 1 of 3 stops with a height are more than 1 m off the terrain, up to 3.2 m " + after);
}

TEST(ObservedStopsReader, TransformsPointsOfAGisFile) {
#ifdef TALUS_HAS_GDAL
  const sample_run::Folder folder("observed");
  folder.write("stops.geojson", R"({"type":"FeatureCollection","crs":{"type":"name","properties":{"name":"EPSG:2056"}},
"features":[{"type":"Feature","properties":{},"geometry":{"type":"Point","coordinates":[2600001,1200002]}}]})");
  Problems warnings;
  const ObservedStops read = read_observed_stops(folder.path / "stops.geojson", map_run(), warnings);
  ASSERT_EQ(read.stops.size(), 1U);
  EXPECT_NEAR(read.stops[0].x_m, 2600001, 1e-6);
  EXPECT_NEAR(read.stops[0].y_m, 1200002, 1e-6);
#else
  GTEST_SKIP() << "built without GDAL";
#endif
}

nlohmann::ordered_json observed_in(const std::filesystem::path& page) {
  const std::string text = test::bytes_of(page), open = "<script type=\"application/json\" id=\"data\">";
  const std::size_t from = text.find(open) + open.size();
  const auto data = nlohmann::ordered_json::parse(text.substr(from, text.find("</script>", from) - from));
  return data["runs"][0].value("observed", nlohmann::ordered_json());
}

/// A table of every tenth end point of a run, moved.
std::string stops_of(const std::filesystem::path& folder, double dx) {
  std::string text = "x,y,z\n";
  for (TableReader<EndpointRow> row(folder / EndpointRow::file_name); row.next();) {
    const EndpointRow end = row.whole();
    if (end.rock % 10 != 0) continue;
    text += std::to_string(end.position_m[0] + dx) + "," + std::to_string(end.position_m[1]) + "," +
            std::to_string(end.position_m[2]) + "\n";
  }
  return text;
}

TEST(ObservedReport, TellsASampleOfTheRunFromAnotherDistribution) {
  const Workplace work;
  const std::string out = (work / "out").string();
  ASSERT_EQ(talus_says("run " + test::tutorial("3d") + " -q --rocks 400 -o " + out +
                       " --set 'output.runout_along=[[0, 10], [40, 10]]'")
                .exit_code,
            0);
  double unmoved = 0;
  for (const double dx : {0.0, -4.0}) {
    const std::string stops = work.write("stops.csv", stops_of(work / "out", dx));
    const test::Said said = talus_says("report " + out + " --observed " + stops);
    ASSERT_EQ(said.exit_code, 0) << said.text;
    const auto observed = observed_in(work / "out/report.html");
    EXPECT_EQ(observed["file"], "stops.csv");
    EXPECT_EQ(observed["stops"]["rows"].size(), 40U);
    EXPECT_EQ(observed["rocks"], 400);
    std::vector<std::string> keys;
    for (const auto& quantity : observed["quantities"]) {
      keys.push_back(quantity["key"]);
      const auto& distance = quantity["energy_distance"];
      const bool is_moved = dx != 0 && quantity["key"] != "lateral";
      EXPECT_GT(distance["p95"], distance["median"]);
      if (is_moved) {
        EXPECT_LT(distance["p_value"], 0.01) << quantity["key"];
        EXPECT_GT(distance["value"], distance["p95"]);
      } else {
        EXPECT_GT(distance["p_value"], 0.02) << quantity["key"];
      }
    }
    EXPECT_EQ(keys, (std::vector<std::string>{"position", "runout", "lateral"}));
    // In one dimension the mean of the observed values follows the move.
    const auto& runout = observed["quantities"][1];
    const double mean = runout["observed"]["mean"];
    if (dx == 0) unmoved = mean;
    EXPECT_NEAR(mean - unmoved, dx, 1e-5);
    EXPECT_NE(said.text.find("runout along the line: energy distance "), std::string::npos) << said.text;
  }
  // The same files give the same page; without the option it has no observed stops.
  const std::string stops = (work / "stops.csv").string();
  ASSERT_EQ(talus_says("report " + out + " --observed " + stops + " -o " + (work / "a.html").string()).exit_code, 0);
  ASSERT_EQ(talus_says("report " + out + " --observed " + stops + " -o " + (work / "b.html").string()).exit_code, 0);
  EXPECT_EQ(test::bytes_of(work / "a.html"), test::bytes_of(work / "b.html"));
  ASSERT_EQ(talus_says("report " + out).exit_code, 0);
  EXPECT_TRUE(observed_in(work / "out/report.html").is_null());
}

TEST(ObservedReport, ComparesAlongASection) {
  const Workplace work;
  const std::string out = (work / "out").string();
  ASSERT_EQ(talus_says("run " + test::tutorial("2d") + " -q --rocks 200 -o " + out).exit_code, 0);
  const std::string stops = work.write("stops.csv", stops_of(work / "out", 0));
  const test::Said said = talus_says("report " + out + " --observed " + stops);
  ASSERT_EQ(said.exit_code, 0) << said.text;
  const auto observed = observed_in(work / "out/report.html");
  ASSERT_EQ(observed["quantities"].size(), 1U);
  EXPECT_EQ(observed["quantities"][0]["key"], "x");
  EXPECT_GT(observed["quantities"][0]["kolmogorov_smirnov"]["p_value"], 0.02);
  const test::Said missing = talus_says("report " + out + " --observed " + (work / "none.csv").string());
  EXPECT_EQ(missing.exit_code, 2) << missing.text;
}

}  // namespace
}  // namespace talus
