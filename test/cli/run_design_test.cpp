// `talus run` with [design]: the tables agree with the hits that they summarise.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "cli/program.hpp"
#include "cli/run_files.hpp"
#include "support/browser.hpp"

namespace talus::test {
namespace {

namespace fs = std::filesystem;

/// The tutorial with collectors so high that every crossing rock is a row of barriers.csv.
std::string with_collectors(const Workplace& work, const char* dimensions, const std::string& more) {
  std::ifstream in(tutorial(dimensions));
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  return work.write("slope.toml", text + more);
}

const double radius_m = std::cbrt(3000 / (4 * std::numbers::pi * 2700));  // of the blocks of the tutorial, 1 t

struct Hit {
  double y_m, height_m, ke_translational_J, ke_total_J, velocity_m_s;
};

/// The first hit of each rock on a collector, by rock.
std::map<std::string, Hit> first_hits(const Workplace& work, const std::string& barrier) {
  std::map<std::string, Hit> by_rock;
  std::ifstream in(work / "out/barriers.csv");
  std::string line;
  std::getline(in, line);
  while (std::getline(in, line)) {
    std::vector<std::string> cells;
    std::istringstream row(line);
    for (std::string cell; std::getline(row, cell, ',');) cells.push_back(cell);
    if (cells[0] != barrier) continue;
    const auto number = [&](std::size_t k) { return std::stod(cells[k]); };
    by_rock.try_emplace(cells[1],
                        Hit{number(4), number(6), number(11), number(13), std::hypot(number(7), number(8), number(9))});
  }
  return by_rock;
}

std::vector<Hit> all_of(const std::map<std::string, Hit>& by_rock) {
  std::vector<Hit> hits;
  for (const auto& [rock, hit] : by_rock) hits.push_back(hit);
  return hits;
}

/// Cells of design.csv by line, section and column.
std::map<std::string, std::string> cells_of(const std::string& csv) {
  std::map<std::string, std::string> cells;
  std::istringstream in(csv);
  std::vector<std::string> names;
  for (std::string line; std::getline(in, line);) {
    std::vector<std::string> row;
    std::istringstream text(line);
    for (std::string cell; std::getline(text, cell, ',');) row.push_back(cell);
    if (names.empty()) {
      names = row;
      continue;
    }
    for (std::size_t k = 0; k < row.size(); ++k) cells[row[0] + '/' + row[1] + '/' + names[k]] = row[k];
  }
  return cells;
}

double quantile(std::vector<double> values, double p) {
  std::ranges::sort(values);
  const double place = p * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t next = std::min(below + 1, values.size() - 1);
  return values[below] + (place - static_cast<double>(below)) * (values[next] - values[below]);
}

template <class Of>
std::vector<double> values(const std::vector<Hit>& hits, Of of) {
  std::vector<double> list;
  for (const Hit& hit : hits) list.push_back(of(hit));
  return list;
}

TEST(RunDesign, AgreesWithTheHitsAlongALine) {
  const Workplace work;
  const std::string project = with_collectors(work, "3d", R"(
[[collector]]
name = "Tall"
line = [[8, 0], [8, 50]]
height_m = 500
[design]
lines = ["Tall"]
section_m = 20
)");
  const Said said = talus_says("run -q " + project + " --rocks 800 -o " + (work / "out").string());
  ASSERT_EQ(said.exit_code, 0) << said.text;
  const auto cells = cells_of(work.read("out/design.csv"));
  const std::vector<Hit> all = all_of(first_hits(work, "Tall"));
  ASSERT_GT(all.size(), 500u);
  const auto expect_section = [&](const std::string& section, double from, double to) {
    std::vector<Hit> hits;
    for (const Hit& hit : all) {
      if (hit.y_m >= from && hit.y_m < to) hits.push_back(hit);
    }
    const auto cell = [&](const char* name) { return cells.at("Tall/" + section + '/' + name); };
    EXPECT_EQ(cell("rocks"), std::to_string(hits.size()));
    if (hits.empty()) return;
    EXPECT_NEAR(std::stod(cell("share")), static_cast<double>(hits.size()) / 800, 1e-12);
    const auto near = [&](const char* name, double expected) {
      EXPECT_NEAR(std::stod(cell(name)), expected, 1e-9 * expected) << name << " of section " << section;
    };
    near("ke_translational_p95_J", quantile(values(hits, [](const Hit& h) { return h.ke_translational_J; }), 0.95));
    near("ke_total_p99_J", quantile(values(hits, [](const Hit& h) { return h.ke_total_J; }), 0.99));
    near("velocity_p50_m_s", quantile(values(hits, [](const Hit& h) { return h.velocity_m_s; }), 0.5));
    near("height_p95_m", quantile(values(hits, [](const Hit& h) { return h.height_m + 2 * radius_m; }), 0.95));
  };
  expect_section("all", 0, 50);
  expect_section("1", 0, 20);
  expect_section("2", 20, 40);
  expect_section("3", 40, 50);
}

/// The first row of design_ranking.csv by column.
std::map<std::string, std::string> best_kit(const std::string& csv) {
  std::istringstream in(csv);
  std::string names, values;
  std::getline(in, names);
  std::getline(in, values);
  std::istringstream name_cells(names), value_cells(values);
  std::map<std::string, std::string> kit;
  for (std::string name, value; std::getline(name_cells, name, ',') && std::getline(value_cells, value, ',');) {
    kit[name] = value;
  }
  return kit;
}

// Recomputes the ranking from the hits: of the rocks that reach the lower line, those that the best kit catches at the
// upper one.
TEST(RunDesign, RanksKitsAsTheHitsDemand) {
  const Workplace work;
  const std::string project = with_collectors(work, "3d", R"(
[[collector]]
name = "Upper"
line = [[8, 5], [8, 45]]
height_m = 500
[[collector]]
name = "Lower"
line = [[14, -5], [14, 55]]
height_m = 500
[design]
lines = ["Upper"]
protect = "Lower"
catch_share = 0.5
energies_kJ = [60, 120, 150, 180, 250, 500]
heights_m = [1, 2, 3, 4, 6, 8]
)");
  const Said said = talus_says("run -q " + project + " --rocks 600 -o " + (work / "out").string());
  ASSERT_EQ(said.exit_code, 0) << said.text;
  const auto upper = first_hits(work, "Upper"), lower = first_hits(work, "Lower");
  auto kit = best_kit(work.read("out/design_ranking.csv"));
  ASSERT_EQ(kit.at("suffices"), "yes");
  const double height_m = std::stod(kit.at("height_m")), mel_kJ = std::stod(kit.at("mel_kJ"));
  std::size_t caught = 0, beside = 0, above = 0;
  for (const auto& [rock, reached] : lower) {
    const auto found = upper.find(rock);
    if (found == upper.end()) {
      ++beside;
      continue;
    }
    const Hit& hit = found->second;
    const bool is_below_top = (hit.height_m + radius_m) * 1.1 * 1.1 + 0.5 <= height_m;
    const bool is_within_mel = hit.ke_translational_J * 1.1 * 1.1 * 1.1 * 1.1 * 1.1 * 1.2 <= mel_kJ * 1000;
    caught += is_below_top && is_within_mel ? 1 : 0;
    above += is_below_top ? 0 : 1;
  }
  EXPECT_EQ(kit.at("rocks"), std::to_string(lower.size()));
  EXPECT_EQ(kit.at("caught"), std::to_string(caught));
  EXPECT_EQ(kit.at("beside"), std::to_string(beside));
  EXPECT_EQ(kit.at("above"), std::to_string(above));
  EXPECT_GT(beside, 0u);
  EXPECT_GT(caught, lower.size() / 2);
  EXPECT_LT(caught, lower.size() - beside) << "otherwise the comparison proves nothing";
}

TEST(RunDesign, ShowsTheCostOfKitsThatCatchTooFewRocks) {
  if (!testing_tools::has_browser()) GTEST_SKIP() << "there is no chromium";
  const Workplace work;
  const std::string project = with_collectors(work, "3d", R"(
[[collector]]
name = "Tall"
line = [[8, 0], [8, 50]]
height_m = 500
[design]
lines = ["Tall"]
energies_kJ = [100, 5000]
heights_m = [1, 500]
)");
  const Said said = talus_says("run -q " + project + " --rocks 300 -o " + (work / "out").string());
  ASSERT_EQ(said.exit_code, 0) << said.text;
  const std::string rows = testing_tools::said_in_page(work / "out/report.html", R"(
    const table = [...document.querySelectorAll('table')].find((t) => t.textContent.includes('Kits'));
    return [...table.querySelectorAll('tr')].map((tr) => [...tr.children].slice(-2).map((c) => c.textContent)
      .map((text, k) => k === 1 && Number(text.replace(/,/g, '')) > 0 ? 'number' : text).join(' ')).join('; ');
  )");
  EXPECT_EQ(rows, "Suffices Cost index; yes number; no: height number");
}

// The confidence interval of 30 caught of 30 rocks is 88.4 to 100 %: too wide to be sure of 95 %.
TEST(RunDesign, ReportsThatTooFewRocksWereRunToBeSure) {
  const Workplace work;
  const std::string project = with_collectors(work, "3d", R"(
[[collector]]
name = "Tall"
line = [[8, 0], [8, 50]]
height_m = 500
[design]
lines = ["Tall"]
energies_kJ = [5000]
heights_m = [1, 500]
)");
  const Said said = talus_says("run -q " + project + " --rocks 30 -o " + (work / "out").string());
  ASSERT_EQ(said.exit_code, 0) << said.text;
  const auto kit = best_kit(work.read("out/design_ranking.csv"));
  EXPECT_EQ(kit.at("suffices"), "yes");
  EXPECT_EQ(kit.at("sure"), "no");
  if (!testing_tools::has_browser()) GTEST_SKIP() << "there is no chromium";
  const std::string shown = testing_tools::said_in_page(work / "out/report.html", R"(
    const table = [...document.querySelectorAll('table')].find((t) => t.textContent.includes('Kits'));
    const words = [...document.querySelectorAll('p')].map((p) => p.textContent).find((text) => text.startsWith('Uncertain'));
    return [...table.querySelectorAll('tr')].map((tr) => [...tr.children].at(-2).textContent).join('; ') + '; ' + words;
  )");
  EXPECT_EQ(shown,
            "Suffices; yes, uncertain; no: height; Uncertain: the required 95 % is within the 95 % confidence interval "
            "of the "
            "share. Run more rocks, or choose a kit that is certain.");
}

TEST(RunDesign, MeasuresALineThatLeavesTheTerrainFromItsFirstPoint) {
  const Workplace work;
  const std::string project = with_collectors(work, "3d", R"(
[[collector]]
name = "Whole"
line = [[8, 0], [8, 35]]
height_m = 500
[[collector]]
name = "Cut"
line = [[8, -20], [8, 35]]
height_m = 500
[design]
section_m = 5
standard = "none"
)");
  const Said said = talus_says("run -q " + project + " --rocks 200 -o " + (work / "out").string());
  ASSERT_EQ(said.exit_code, 0) << said.text;
  EXPECT_NE(said.text.find("collector \"Cut\": 20 of 55 m of its line are off the terrain"), std::string::npos)
      << said.text;
  const auto cells = cells_of(work.read("out/design.csv"));
  for (const std::string section : {"all", "1", "2", "3", "4", "5", "6", "7"}) {
    const std::string whole = "Whole/" + section, cut = "Cut/" + section;
    EXPECT_EQ(cells.at(cut + "/rocks"), cells.at(whole + "/rocks")) << section;
    EXPECT_NEAR(std::stod(cells.at(cut + "/from_m")), std::stod(cells.at(whole + "/from_m")) + 20, 1e-9) << section;
    EXPECT_NEAR(std::stod(cells.at(cut + "/to_m")), std::stod(cells.at(whole + "/to_m")) + 20, 1e-9) << section;
  }
  EXPECT_FALSE(cells.contains("Cut/8/rocks"));
  EXPECT_NE(cells.at("Cut/all/rocks"), "0");
  const auto summary = nlohmann::json::parse(work.read("out/summary.json"));
  const auto& barriers = summary["barriers"];
  for (const auto& barrier : barriers) EXPECT_EQ(barrier.contains("stations_m"), barrier["name"] == "Cut");
  EXPECT_EQ(barriers.back()["name"], "Cut");
  EXPECT_EQ(barriers.back()["stations_m"].size(), barriers.back()["line_xyz"].size());
  EXPECT_EQ(barriers.back()["stations_m"][0], 20);
}

TEST(RunDesign, WorksInSection) {
  const Workplace work;
  const std::string project = with_collectors(work, "2d", R"(
[[collector]]
name = "Tall"
line = 8
height_m = 500
[design]
standard = "none"
lines = ["Tall"]
)");
  const Said said = talus_says("run -q " + project + " --rocks 300 -o " + (work / "out").string());
  ASSERT_EQ(said.exit_code, 0) << said.text;
  const auto cells = cells_of(work.read("out/design.csv"));
  const std::vector<Hit> hits = all_of(first_hits(work, "Tall"));
  const double energy = quantile(values(hits, [](const Hit& h) { return h.ke_translational_J; }), 0.95);
  EXPECT_EQ(cells.at("Tall/1/rocks"), std::to_string(hits.size()));
  EXPECT_NEAR(std::stod(cells.at("Tall/all/needs_mel_kJ")), energy / 1000, 1e-9 * energy);
  EXPECT_FALSE(cells.contains("Tall/2/rocks"));
  const auto summary = nlohmann::json::parse(work.read("out/summary.json"));
  EXPECT_EQ(summary["design"]["lines"][0]["rocks"], hits.size());
  EXPECT_EQ(summary["design"]["standard"], nullptr);
}

TEST(RunDesign, RemovesTablesOfAnEarlierRun) {
  const Workplace work;
  const std::string run = "run -q " + write_slope_with_barrier(work) + " --rocks 40 -o " + (work / "out").string();
  ASSERT_EQ(talus_says(run).exit_code, 0);
  EXPECT_TRUE(fs::exists(work / "out/design.csv"));
  EXPECT_TRUE(fs::exists(work / "out/design_ranking.csv"));
  const std::string without = with_collectors(work, "3d", "");
  ASSERT_EQ(talus_says("run -q " + without + " --rocks 40 -o " + (work / "out").string()).exit_code, 0);
  EXPECT_FALSE(fs::exists(work / "out/design.csv"));
  EXPECT_FALSE(fs::exists(work / "out/design_ranking.csv"));
  EXPECT_FALSE(nlohmann::json::parse(work.read("out/summary.json")).contains("design"));
}

}  // namespace
}  // namespace talus::test
