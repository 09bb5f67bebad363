// impacts.csv, the ground at the end point, and runout from a point or along a line.

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "cli/program.hpp"
#include "cli/run_files.hpp"
#include "talus/archive/table_columns.hpp"
#include "talus/core/vec.hpp"

namespace talus::test {
namespace {

template <TableRow Row>
std::vector<Row> rows_in(const std::filesystem::path& folder) {
  std::vector<Row> rows;
  for (TableReader<Row> row(folder / Row::file_name); row.next();) rows.push_back(row.whole());
  return rows;
}

std::filesystem::path run_in(const Workplace& work, const std::string& project, const std::string& options,
                             const std::string& name = "out") {
  const Said said = talus_says("run " + project + " -q " + options + " -o " + (work / name).string());
  EXPECT_EQ(said.exit_code, 0) << said.text;
  return work / name;
}

/// Every impact is an arrival in paths.csv, at the same time with the same velocity and spin; the reverse need not be
/// true, because a rock also arrives where the ground falls away.
void expect_impacts_of_paths(const std::filesystem::path& folder, std::size_t least) {
  std::map<std::pair<std::uint64_t, double>, PathEventRow> arrivals;
  for (const PathEventRow& row : rows_in<PathEventRow>(folder)) {
    if (row.state == PathState::impact) arrivals[{row.rock, row.time_s}] = row;
  }
  const std::vector<ImpactRow> impacts = rows_in<ImpactRow>(folder);
  EXPECT_GE(impacts.size(), least);
  std::uint64_t rock = 0, number = 0;
  for (const ImpactRow& impact : impacts) {
    number = impact.rock == rock ? number + 1 : 1;
    rock = impact.rock;
    EXPECT_EQ(impact.impact, number);
    const auto arrival = arrivals.find({impact.rock, impact.time_s});
    ASSERT_NE(arrival, arrivals.end()) << impact.rock << ' ' << impact.time_s;
    const PathEventRow& row = arrival->second;
    EXPECT_EQ(impact.position_m, row.position_m);
    EXPECT_EQ(impact.velocity_in_m_s, row.velocity_m_s);
    EXPECT_EQ(impact.spin_in_rad_s, row.spin_rad_s);
    EXPECT_DOUBLE_EQ(impact.ke_in_J, row.ke_translational_J + row.ke_rotational_J);
    const Vec3 n = vector(impact.normal), struck = vector(impact.struck_normal);
    EXPECT_NEAR(n.norm(), 1, 1e-12);
    EXPECT_NEAR(struck.norm(), 1, 1e-12);
    EXPECT_LE(vector(impact.velocity_in_m_s).dot(struck), 0) << "it approaches";
    EXPECT_GE(vector(impact.velocity_out_m_s).dot(n), -1e-9) << "it leaves, or stays on the ground";
    EXPECT_LE(impact.ke_out_J, impact.ke_in_J * (1 + 1e-12)) << "no impact adds energy";
    EXPECT_FALSE(impact.ground.empty());
  }
}

TEST(ImpactsTable, AgreesWithPathsOfTheLumpedMassInSectionAndSpace) {
  const Workplace work;
  for (const char* dimension : {"2d", "3d"}) {
    const auto folder = run_in(work, tutorial(dimension), "--rocks 60 --set output.impacts=all", dimension);
    expect_impacts_of_paths(folder, 200);
    std::set<std::uint64_t> facets;
    for (const ImpactRow& impact : rows_in<ImpactRow>(folder)) facets.insert(impact.facet);
    EXPECT_GT(facets.size(), 2U);
    EXPECT_LT(*facets.rbegin(), 20U) << "segments as the project numbers them";
  }
}

TEST(ImpactsTable, AgreesWithPathsOfTheSphere) {
  const Workplace work;
  expect_impacts_of_paths(
      run_in(work, tutorial("3d"), "--rocks 40 --set output.impacts=all --set analysis.model=rigid_sphere"), 100);
}

TEST(ImpactsTable, IsWrittenOnRequestOnlyAndChangesNothingElse) {
  const Workplace work;
  const std::string project = write_slope_with_barrier(work);
  const auto without = run_in(work, project, "--rocks 200 --set output.geopackage=none", "without");
  EXPECT_FALSE(std::filesystem::exists(without / "impacts.csv"));
  const auto with = run_in(work, project, "--rocks 200 --set output.geopackage=none --set output.impacts=20", "with");
  std::set<std::uint64_t> rocks;
  for (const ImpactRow& impact : rows_in<ImpactRow>(with)) rocks.insert(impact.rock);
  EXPECT_GT(rocks.size(), 15U);
  EXPECT_LE(rocks.size(), 20U);
  for (const char* name : {"endpoints.csv", "paths.csv", "barriers.csv", "maps/impacts.tif"}) {
    EXPECT_EQ(bytes_of(without / name), bytes_of(with / name)) << name;
  }
  // A later run without them removes the table of the earlier one.
  run_in(work, project, "--rocks 20", "with");
  EXPECT_FALSE(std::filesystem::exists(with / "impacts.csv"));
}

TEST(ImpactsTable, HasTheSameBytesFromShardsAndThreads) {
  const Workplace work;
  const std::string project = write_slope_with_barrier(work);
  const std::string options = "--rocks 500 --set output.impacts=100 ";
  const auto whole = run_in(work, project, options + "--threads 1", "whole");
  run_in(work, project, options + "--shard 1/2 --threads 2", "one");
  run_in(work, project, options + "--shard 2/2 --threads 8", "two");
  const Said said = talus_says("merge -q " + (work / "one").string() + " " + (work / "two").string() + " -o " +
                               (work / "merged").string());
  ASSERT_EQ(said.exit_code, 0) << said.text;
  EXPECT_EQ(differences(files_of(whole), files_of(work / "merged")), "");
}

TEST(GroundAtTheEnd, IsTheMaterialBelowOrEmptyWhereARockLeft) {
  const Workplace work;
  for (const char* dimension : {"2d", "3d"}) {
    const auto folder = run_in(work, tutorial(dimension), "--rocks 100 --set output.impacts=all", dimension);
    std::map<std::uint64_t, std::string> last_ground;
    for (const ImpactRow& impact : rows_in<ImpactRow>(folder)) last_ground[impact.rock] = impact.ground;
    int at_rest = 0, as_struck = 0;
    for (const EndpointRow& end : rows_in<EndpointRow>(folder)) {
      EXPECT_EQ(end.ground.empty(), end.end_reason == EndReason::left_model) << end.rock;
      if (end.end_reason != EndReason::at_rest) continue;
      ++at_rest;
      as_struck += end.ground == last_ground[end.rock] ? 1 : 0;
    }
    EXPECT_GT(at_rest, 50);
    EXPECT_GT(as_struck, at_rest / 2) << "most rocks rest on the ground that they struck last";
  }
}

TEST(ChosenRunout, IsCountedFromThePointOrAlongTheLine) {
  const Workplace work;
  const auto from = run_in(work, tutorial("3d"), "--rocks 30 --set 'output.runout_from=[3, 4]'", "from");
  for (const EndpointRow& end : rows_in<EndpointRow>(from)) {
    EXPECT_NEAR(end.runout_xy_m, std::hypot(end.position_m[0] - 3, end.position_m[1] - 4), 1e-9);
    EXPECT_FALSE(end.lateral_m);
  }
  const auto along =
      run_in(work, tutorial("3d"), "--rocks 30 --set 'output.runout_along=[[0, 10], [40, 10]]'", "along");
  double sum = 0;
  for (const EndpointRow& end : rows_in<EndpointRow>(along)) {
    EXPECT_NEAR(end.runout_xy_m, end.position_m[0], 1e-9);
    ASSERT_TRUE(end.lateral_m);
    EXPECT_NEAR(*end.lateral_m, end.position_m[1] - 10, 1e-9);
    sum += end.runout_xy_m;
  }
  const auto summary = nlohmann::json::parse(bytes_of(along / "summary.json"));
  EXPECT_NEAR(summary["statistics"]["runout_xy_m"]["mean"], sum / 30, 1e-9);
  const auto section = run_in(work, tutorial("2d"), "--rocks 30 --set 'output.runout_from=[5]'", "section");
  for (const EndpointRow& end : rows_in<EndpointRow>(section))
    EXPECT_NEAR(end.runout_xy_m, std::abs(end.position_m[0] - 5), 1e-9);
}

TEST(ChosenRunout, RefusesTwoFramesAndWrongShapes) {
  const Workplace work;
  const auto text = [&](const char* dimension, const std::string& options) {
    const Said said = talus_says("check " + tutorial(dimension) + " " + options);
    EXPECT_EQ(said.exit_code, 2) << said.text;
    return said.text;
  };
  EXPECT_NE(text("3d", "--set 'output.runout_from=[3, 4]' --set 'output.runout_along=[[0, 10], [40, 10]]'")
                .find("runout_from and runout_along are given (runout is counted in one way). Leave one of them out"),
            std::string::npos);
  EXPECT_NE(text("3d", "--set 'output.runout_from=[3]'").find("expected a point on plan, [x, y], in a 3D analysis"),
            std::string::npos);
  EXPECT_NE(text("2d", "--set 'output.runout_from=[3, 4]'").find("expected [x] in a 2D analysis"), std::string::npos);
  EXPECT_NE(text("2d", "--set 'output.runout_along=[[0, 10], [40, 10]]'").find("expected x in a 2D analysis"),
            std::string::npos);
  EXPECT_NE(text("3d", "--set 'output.runout_along=[[0, 10]]'").find("two or more points on plan"), std::string::npos);
  EXPECT_NE(text("3d", "--set 'output.runout_along=[[0, 10], [0, 10]]'").find("repeats the previous point"),
            std::string::npos);
}

}  // namespace
}  // namespace talus::test
