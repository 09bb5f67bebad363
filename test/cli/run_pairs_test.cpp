// Two lines one behind the other, ranked in one run with collectors, are what a run with the first one built shows. A
// point passes above a fence that is built if its lowest point does, and a kit must cover its top: a kit catches what a
// fence stops that is the block's diameter lower.

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "cli/program.hpp"

namespace talus::test {
namespace {

using Row = std::map<std::string, std::string>;

std::vector<Row> rows_of(const std::string& csv) {
  std::vector<Row> rows;
  std::vector<std::string> names;
  std::istringstream in(csv);
  for (std::string line; std::getline(in, line);) {
    std::vector<std::string> cells;
    std::istringstream text(line);
    for (std::string cell; std::getline(text, cell, ',');) cells.push_back(cell);
    if (names.empty()) {
      names = cells;
      continue;
    }
    cells.resize(names.size());
    Row& row = rows.emplace_back();
    for (std::size_t k = 0; k < names.size(); ++k) row[names[k]] = cells[k];
  }
  return rows;
}

/// The first hit of each rock on a line, without the time: a rock that hits it again is not counted again.
std::map<std::string, Row> first_hits(const std::string& csv, const std::string& barrier) {
  std::map<std::string, Row> hits;
  for (const Row& row : rows_of(csv)) {
    if (row.at("barrier") == barrier) hits.try_emplace(row.at("rock"), row);
  }
  return hits;
}

std::string slope_with(const Workplace& work, const std::string& name, const std::string& more) {
  std::ifstream in(tutorial("3d"));
  return work.write(name, std::string(std::istreambuf_iterator<char>(in), {}) + more);
}

constexpr const char* lower = R"(
[[collector]]
name = "Lower"
line = [[18, 2], [18, 48]]
height_m = 500
)";

std::string upper(const std::string& kind, double height_m, const std::string& more) {
  return "\n[[" + kind + "]]\nname = \"Upper\"\nline = [[16, 10], [16, 40]]\nheight_m = " + std::to_string(height_m) +
         "\n" + more;
}

constexpr double height_m = 1.5;
/// Of the tutorial's blocks of 1 t.
const double diameter_m = 2 * std::cbrt(3 * 1000 / (4 * std::numbers::pi * 2700));

/// The pair's only row, with kits on both lines that are a diameter higher than the fence, and of this energy.
Row pair_with(const Workplace& work, const std::string& energy_kJ) {
  const std::string design =
      "[design]\nlines = [\"Upper\", \"Lower\"]\npairs = true\nstandard = \"none\"\nenergy = \"total\"\nheights_m = [" +
      fmt::format("{}", height_m + diameter_m) + "]\nenergies_kJ = [" + energy_kJ + "]\n";
  const std::string project = slope_with(work, "collectors.toml", upper("collector", 500, "") + lower + design);
  const Said said = talus_says("run -q " + project + " --rocks 600 -o " + (work / "collectors").string());
  EXPECT_EQ(said.exit_code, 0) << said.text;
  const auto rows = rows_of(work.read("collectors/design_pairs.csv"));
  EXPECT_EQ(rows.size(), 1u);
  return rows.empty() ? Row() : rows.front();
}

/// The same slope with the first line built.
void run_with_fence(const Workplace& work, const std::string& energy_kJ) {
  const std::string project =
      slope_with(work, "built.toml", upper("barrier", height_m, "capacity_kJ = " + energy_kJ + "\n") + lower);
  const Said said = talus_says("run -q " + project + " --rocks 600 -o " + (work / "built").string());
  ASSERT_EQ(said.exit_code, 0) << said.text;
}

// A fence that holds all rocks below its top: the second line sees the same rocks, at the same place with the same
// velocity, and of them catches as many.
TEST(RunPairs, EqualARunInWhichTheFirstLineIsBuilt) {
  const Workplace work;
  Row pair = pair_with(work, "100000");
  ASSERT_NO_FATAL_FAILURE(run_with_fence(work, "100000"));
  const std::string before = work.read("collectors/barriers.csv"), after = work.read("built/barriers.csv");
  const auto stopped = first_hits(after, "Upper"), sees = first_hits(after, "Lower");
  const auto at_upper = first_hits(before, "Upper"), at_lower = first_hits(before, "Lower");
  EXPECT_EQ(pair.at("first"), "Upper");
  EXPECT_EQ(pair.at("caught_by_first"), std::to_string(stopped.size()));
  EXPECT_EQ(pair.at("at_second"), std::to_string(sees.size()));
  std::size_t caught = 0;
  for (const auto& [rock, hit] : sees) {
    caught += std::stod(hit.at("impact_height_m")) <= height_m ? 1 : 0;
    ASSERT_TRUE(at_lower.contains(rock));
    for (const char* column : {"x_m", "y_m", "z_m", "impact_height_m", "vx_m_s", "vy_m_s", "vz_m_s", "ke_total_J"}) {
      EXPECT_EQ(hit.at(column), at_lower.at(rock).at(column)) << rock << " " << column;
    }
  }
  EXPECT_EQ(pair.at("caught_by_second"), std::to_string(caught));
  EXPECT_EQ(std::stoul(pair.at("caught")), stopped.size() + caught);
  for (const auto& [rock, hit] : at_lower) EXPECT_NE(stopped.contains(rock), sees.contains(rock)) << rock;
  EXPECT_GT(stopped.size(), 50u);
  EXPECT_GT(sees.size(), caught);
  EXPECT_GT(caught, 10u) << "otherwise the comparison proves nothing";
  EXPECT_LT(stopped.size(), at_upper.size()) << "some rocks pass above";
}

// A fence that some rocks break through stops the rocks that the design says it catches. (Those that break through are
// slower in the run: the design leaves them as they are.)
TEST(RunPairs, CountTheRocksThatAWeakFenceStops) {
  const Workplace work;
  Row pair = pair_with(work, "5");
  ASSERT_NO_FATAL_FAILURE(run_with_fence(work, "5"));
  std::size_t stopped = 0, through = 0;
  for (const auto& [rock, hit] : first_hits(work.read("built/barriers.csv"), "Upper")) {
    stopped += hit.at("outcome") == "stopped" ? 1 : 0;
    through += hit.at("outcome") == "broke through" ? 1 : 0;
  }
  EXPECT_EQ(pair.at("caught_by_first"), std::to_string(stopped));
  EXPECT_GT(stopped, 20u);
  EXPECT_GT(through, 20u);
}

TEST(RunPairs, AreTheSameInShards) {
  const Workplace work;
  const std::string project = slope_with(
      work, "collectors.toml", upper("collector", 500, "") + lower + "[design]\npairs = true\nfree_end_m = 2\n");
  const std::string run = "run -q " + project + " --rocks 300";
  ASSERT_EQ(talus_says(run + " -o " + (work / "whole").string()).exit_code, 0);
  for (const char* shard : {"1/2", "2/2"}) {
    ASSERT_EQ(talus_says(run + " --shard " + shard + " -o " + (work / std::string(1, shard[0])).string()).exit_code, 0);
  }
  const Said merged =
      talus_says("merge " + (work / "1").string() + " " + (work / "2").string() + " -o " + (work / "merged").string());
  ASSERT_EQ(merged.exit_code, 0) << merged.text;
  EXPECT_EQ(work.read("merged/design_pairs.csv"), work.read("whole/design_pairs.csv"));
  EXPECT_EQ(work.read("merged/design_ranking.csv"), work.read("whole/design_ranking.csv"));
  EXPECT_NE(work.read("whole/design_pairs.csv").find("Upper"), std::string::npos);
}

}  // namespace
}  // namespace talus::test
