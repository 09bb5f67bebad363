// Paths, end points and single rocks over the API agree with the tables of the run.

#include "server/served_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "talus/archive/path_reader.hpp"

namespace talus {
namespace {

using testing_tools::ArraysOf;
using testing_tools::Json;
using testing_tools::Texts;

using RockResults = testing_tools::ServedResults;

TEST_F(RockResults, OfPathsArePointsThatIncludeTheRows) {
  const ArraysOf paths(of("/paths"));
  const auto rocks = paths.get<std::uint32_t>("rocks", "u32"), starts = paths.get<std::uint32_t>("starts", "u32");
  const auto times = paths.get<float>("times", "f32"), positions = paths.get<float>("positions", "f32");
  const auto speeds = paths.get<float>("speeds", "f32"), energies = paths.get<float>("energies", "f32");
  const auto heights = paths.get<float>("heights", "f32"), max_heights = paths.get<float>("max_heights", "f32");
  const auto states = paths.get<std::uint8_t>("states", "u8");
  ASSERT_EQ(rocks.size(), 75U);
  ASSERT_EQ(starts.size(), 76U);
  EXPECT_EQ(starts.front(), 0U);
  EXPECT_EQ(starts.back(), times.size());
  EXPECT_EQ(positions.size(), 3 * times.size());
  for (const std::size_t size : {speeds.size(), energies.size(), heights.size(), states.size()})
    EXPECT_EQ(size, times.size());
  EXPECT_EQ(paths.header["total"], 75);
  EXPECT_EQ(paths.header["states"][4], "barrier");

  PathReader reader(folder_ / "paths.csv");
  std::size_t rock = 0, rows = 0;
  float max_difference = 0;
  for (; reader.next([](std::uint64_t) { return true; }); ++rock) {
    ASSERT_EQ(reader.path().rock, rocks[rock]);
    std::size_t k = starts[rock];
    float highest = 0;
    for (const PathEventRow& row : reader.path().rows) {
      while (k < starts[rock + 1] &&
             (times[k] != static_cast<float>(row.time_s) || states[k] != static_cast<std::uint8_t>(row.state)))
        highest = std::max(highest, heights[k++]);
      ASSERT_LT(k, starts[rock + 1]) << "a row of rock " << rock << " at " << row.time_s << " s is missing";
      for (std::size_t axis = 0; axis < 3; ++axis)
        EXPECT_NEAR(positions[3 * k + axis] + paths.header["origin"][axis].get<double>(), row.position_m[axis], 1e-4);
      EXPECT_EQ(energies[k], static_cast<float>((row.ke_translational_J + row.ke_rotational_J) / 1000));
      if (row.state == PathState::impact) {
        EXPECT_LT(heights[k], 1e-3F) << "an impact is on the ground";
      }
      highest = std::max(highest, heights[k++]);
      ++rows;
    }
    EXPECT_EQ(k, starts[rock + 1]);
    EXPECT_LE(highest, max_heights[rock] + 1e-3F);
    max_difference = std::max(max_difference, max_heights[rock] - highest);
  }
  EXPECT_EQ(rock, 75U);
  // Between two points of an arc the height may be larger: here the ground is as steep as 4 : 1.
  EXPECT_LT(max_difference, 1.5F);
  EXPECT_GT(times.size(), 2 * rows) << "flights have no intermediate points";
}

TEST_F(RockResults, OfEveryRockAgreeWithTheTables) {
  for (const char* what : {"/paths", "/endpoints"}) {
    const ArraysOf arrays(of(what));
    const Json& header = arrays.header;
    const auto sources = arrays.get<std::uint16_t>("sources", "u16"),
               seeders = arrays.get<std::uint16_t>("seeders", "u16");
    const auto reasons = arrays.get<std::uint8_t>("reasons", "u8");
    const auto masses = arrays.get<float>("masses", "f32"), energies = arrays.get<float>("max_energies", "f32");
    const auto radii = arrays.get<float>("radii", "f32");
    const auto barriers = arrays.get<std::uint32_t>("barriers", "u32");
    const std::vector<Texts> rows = endpoints(), all_hits = hits();
    ASSERT_EQ(rows.size(), masses.size());
    EXPECT_EQ(header["barriers"][0], "Fence");
    std::uint32_t seen = 0;
    for (std::size_t k = 0; k < rows.size(); ++k) {
      EXPECT_EQ(header["seeders"][seeders[k]], rows[k][1]);
      EXPECT_EQ(header["sources"][sources[k]], rows[k][1]) << "a seeder without a source is its own source";
      EXPECT_EQ(header["reasons"][reasons[k]], rows[k][11]);
      EXPECT_EQ(masses[k], static_cast<float>(std::stod(rows[k][13])));
      EXPECT_EQ(radii[k], static_cast<float>(std::stod(rows[k][14])));
      EXPECT_EQ(energies[k], static_cast<float>(std::stod(rows[k][15]) / 1000));
      std::uint32_t expected = 0;
      for (const Texts& hit : all_hits)
        if (hit[1] == rows[k][0]) expected |= hit[0] == header["barriers"][0] ? 1U : 2U;
      EXPECT_EQ(barriers[k], expected) << k;
      seen |= expected;
    }
    EXPECT_EQ(seen, 3U) << "each barrier must be hit by some rock";
  }
}

TEST_F(RockResults, IncludeHitsOnManyBarriers) {
  std::string text = section();
  for (int k = 1; k < 70; ++k)
    text += fmt::format("\n[[collector]]\nname = \"C{}\"\nline = {}\nheight_m = 9\n", k, 10 + 0.1 * k);
  id_ = begin(text);
  ASSERT_EQ(wait_for(id_, "done")["state"], "done");
  folder_ = folder_of(id_);
  const ArraysOf arrays(of("/endpoints"));
  const auto rocks = arrays.get<std::uint32_t>("rocks", "u32"), barriers = arrays.get<std::uint32_t>("barriers", "u32");
  constexpr std::size_t words = 3;
  ASSERT_EQ(barriers.size(), words * rocks.size());
  const auto names = arrays.header["barriers"].get<Texts>();
  std::vector<std::uint32_t> expected(barriers.size());
  for (const Texts& hit : hits()) {
    const auto number = static_cast<std::size_t>(std::ranges::find(names, hit[0]) - names.begin());
    expected[words * std::stoull(hit[1]) + number / 32] |= 1U << number % 32;
  }
  EXPECT_EQ(barriers, expected);
  std::uint32_t seen = 0;
  for (std::size_t k = words - 1; k < barriers.size(); k += words) seen |= barriers[k];
  EXPECT_NE(seen, 0U) << "no rock hits a barrier beyond the 64th";
}

TEST_F(RockResults, OfEndPointsHaveTheirPositions) {
  const ArraysOf ends(of("/endpoints"));
  const auto positions = ends.get<float>("positions", "f32");
  const std::vector<Texts> rows = endpoints();
  ASSERT_EQ(positions.size(), 3 * rows.size());
  for (std::size_t k = 0; k < positions.size(); ++k)
    EXPECT_NEAR(positions[k] + ends.header["origin"][k % 3].get<double>(), std::stod(rows[k / 3][2 + k % 3]), 1e-4);
  const ArraysOf ten(of("/endpoints?rocks=10"));
  EXPECT_EQ(ten.get<std::uint32_t>("rocks", "u32").size(), 10U);
  EXPECT_EQ(ten.header["total"], 75);
  EXPECT_EQ(ArraysOf(of("/paths?rocks=7")).get<std::uint32_t>("starts", "u32").size(), 8U);
  EXPECT_EQ(ArraysOf(of("/paths?rocks=0")).get<std::uint32_t>("starts", "u32").size(), 1U);
  EXPECT_EQ(of("/paths?rocks=-1").status, 400);
}

TEST_F(RockResults, OfOneRockAreItsRowsVerbatim) {
  const std::vector<Texts> ends = endpoints(), all_hits = hits();
  std::map<std::string, std::vector<Texts>> paths;
  for (const Texts& row : rows_of("paths.csv", path_columns)) paths[row[0]].push_back(row);
  for (const Texts& end : ends) {
    const Json rock = of("/rocks/" + end[0]).json();
    EXPECT_EQ(rock["in_table"], true);
    EXPECT_EQ(rock["columns"], Json(path_columns));
    EXPECT_EQ(rock["rows"], Json(paths[end[0]]));
    ASSERT_EQ(rock["endpoint"].size(), end.size());
    for (std::size_t k = 0; k < end.size(); ++k) EXPECT_EQ(rock["endpoint"][std::string(endpoint_columns[k])], end[k]);
    std::size_t count = 0;
    for (const Texts& hit : all_hits) count += hit[1] == end[0] ? 1 : 0;
    EXPECT_EQ(rock["hits"].size(), count);
    EXPECT_EQ(rock["energy"].front()[1], std::stod(paths[end[0]].front()[13]));
    EXPECT_EQ(rock["energy"].back()[3], std::stod(paths[end[0]].back()[15]));
  }
  EXPECT_EQ(of("/rocks/75").status, 404);
  EXPECT_EQ(of("/rocks/9999999999999999999").status, 404);
  EXPECT_EQ(of("/rocks/-1").status, 404);
}

TEST_F(RockResults, OfARockWithoutAPathInTheTableAreSimulatedAgain) {
  const std::string few = begin(text_ + "\n[output]\npaths = 5\n");
  ASSERT_EQ(wait_for(few, "done")["state"], "done");
  int again = 0;
  for (int rock = 0; rock < 75; ++rock) {
    const Json here = of("/rocks/" + std::to_string(rock)).json();
    const Json there = get("/api/runs/" + few + "/rocks/" + std::to_string(rock)).json();
    again += there["in_table"] == false ? 1 : 0;
    EXPECT_EQ(there["rows"], here["rows"]) << rock;
    EXPECT_EQ(there["energy"], here["energy"]) << rock;
    EXPECT_EQ(there["endpoint"], here["endpoint"]) << rock;
  }
  EXPECT_EQ(again, 70);
}

TEST_F(RockResults, OfASampleOfEndPointsReportItsSize) {
  const std::string few = begin(text_ + "\n[output]\nendpoints = 30\npaths = 5\n");
  ASSERT_EQ(wait_for(few, "done")["state"], "done");
  const auto of_few = [&](const std::string& what) { return get("/api/runs/" + few + what); };
  const ArraysOf ends(of_few("/endpoints"));
  EXPECT_EQ(ends.header["total"], 30);
  const auto rocks = ends.get<std::uint32_t>("rocks", "u32");
  EXPECT_EQ(rocks.size(), 30U);
  for (const std::uint32_t rock : ArraysOf(of_few("/paths")).get<std::uint32_t>("rocks", "u32"))
    EXPECT_TRUE(std::ranges::binary_search(rocks, rock)) << rock;
  for (int rock = 0; rock < 75; ++rock) {
    const std::string which = "/rocks/" + std::to_string(rock);
    EXPECT_EQ(of_few(which).json()["endpoint"], of(which).json()["endpoint"]) << rock;
  }
  EXPECT_EQ(of_few("/rocks/75").status, 404);

  const Json found = of_few("/statistics?of=x_m").json();
  EXPECT_EQ(found["count"], 30);
  EXPECT_EQ(found["sample"], (Json{{"rocks", 30}, {"of", 75}}));
  EXPECT_EQ(of("/statistics?of=x_m").json()["sample"], Json());
  // All hits are in the table; but a filter only finds rocks whose end points are.
  const std::string on_fence = "/barriers/0/statistics?of=time_s";
  EXPECT_EQ(of_few(on_fence).json()["sample"], Json());
  EXPECT_EQ(of_few(on_fence).json()["count"], of(on_fence).json()["count"]);
  EXPECT_EQ(of_few(on_fence + "&min_energy_kJ=0").json()["sample"], (Json{{"rocks", 30}, {"of", 75}}));
}

// A changed project has other paths: then no path is better than a wrong one.
TEST_F(RockResults, OfAChangedProjectAreNotSimulatedAgain) {
  const std::string few = begin(text_ + "\n[output]\npaths = 5\n");
  ASSERT_EQ(wait_for(few, "done")["state"], "done");
  const std::string file = run(few)["folder"].get<std::string>() + "/project.toml";
  const std::string text = read(file);
  write(file, std::string(text).replace(text.find("position = [5, 20"), 17, "position = [5, 21"));
  int refused = 0;
  for (int rock = 0; rock < 75; ++rock)
    refused += get("/api/runs/" + few + "/rocks/" + std::to_string(rock)).status == 404 ? 1 : 0;
  EXPECT_EQ(refused, 70);
  for (const float height : ArraysOf(get("/api/runs/" + few + "/paths")).get<float>("heights", "f32"))
    EXPECT_TRUE(std::isnan(height));
  write(file, text);
  EXPECT_EQ(get("/api/runs/" + few + "/rocks/1").status, 200);
}

}  // namespace
}  // namespace talus
