#include "talus/archive/envelope_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "talus/campaign/campaign.hpp"
#include "talus/model/model.hpp"
#include "talus/project/read.hpp"
#include "talus/run/run_results.hpp"

namespace talus {
namespace {

using Row = std::map<std::string, std::string>;

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells(1);
  for (const char c : line) c == ',' ? cells.emplace_back() : cells.back() += c;
  return cells;
}

std::vector<Row> envelopes_of(const std::string& toml, bool has_heights = true) {
  Problems warnings;
  const project::Project project = project::read_project_text(toml, "slope.toml").project;
  const Model model = project::build_model(project, warnings);
  const auto observer = project::map_observer(project, model);
  Observer* const observers[] = {observer.get()};
  (void)run_campaign(model, observers, {1, nullptr, {}});
  std::istringstream text(envelope_table(observer->maps(), project::map_selection(project, model), has_heights));
  std::string line;
  std::getline(text, line);
  const std::vector<std::string> names = cells_of(line);
  std::vector<Row> rows;
  while (std::getline(text, line)) {
    const std::vector<std::string> cells = cells_of(line);
    EXPECT_EQ(cells.size(), names.size());
    Row& row = rows.emplace_back();
    for (std::size_t k = 0; k < cells.size(); ++k) row[names[k]] = cells[k];
  }
  return rows;
}

double number(const Row& row, const std::string& name) { return std::stod(row.at(name)); }

// Launched far from the origin over a plain 80 m below, at 10 m/s; an impact stops it.
const std::string launch_off_a_cliff = R"(
[terrain]
section = [[500000, 100], [500001.5, 100], [500001.5, 20], [500100, 20]]
[[material]]
name = "Moor"
normal_restitution = 0
tangential_restitution = 0
[[seeder]]
position = [500001, 110]
horizontal_velocity_m_s = 10
rocks = 7
mass_kg = 2000
[output]
raster_cell_m = 2
percentiles = [50, 99]
)";

TEST(EnvelopeTable, IsRefusedForMapsOfSeveralRows) {
  Maps maps(MapGrid({0, 0}, 2, {}));
  const std::vector<MapVisit> visits{{.cell = {0, 0}}, {.cell = {40, 33}}};
  const std::span<const MapVisit> rock = visits;
  maps.add(1, {&rock, 1});
  EXPECT_THROW((void)envelope_table(maps, {}, true), std::logic_error);
}

TEST(EnvelopeTable, OfAFlightAgreesWithItsParabola) {
  const std::vector<Row> rows = envelopes_of(launch_off_a_cliff);
  const double g = 9.80665, start = 500001, lands = start + 10 * std::sqrt(2 * 90 / g);
  ASSERT_EQ(rows.size(), static_cast<std::size_t>((lands - 500000) / 2) + 1);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const double from = std::max(start, 500000 + 2.0 * static_cast<double>(k));
    const double to = std::min(lands, 500002 + 2.0 * static_cast<double>(k));
    const double fall = g * (to - start) * (to - start) / 200, speed = std::sqrt(100 + 2 * g * fall);
    const double fallen_before = g * (from - start) * (from - start) / 200;
    EXPECT_EQ(number(rows[k], "x_m"), 500001 + 2.0 * static_cast<double>(k));
    EXPECT_EQ(rows[k].at("passages"), "7");
    EXPECT_EQ(rows[k].at("reach_share"), "1");
    EXPECT_NEAR(number(rows[k], "velocity_max_m_s"), speed, 1e-5 * speed);
    EXPECT_NEAR(number(rows[k], "velocity_p99_m_s"), speed, 0.01 * speed);
    EXPECT_NEAR(number(rows[k], "energy_translational_mean_kJ"), speed * speed, 1e-4 * speed * speed);
    // In the first cell it flies over the ledge and beyond its edge.
    if (k > 0) {
      EXPECT_NEAR(number(rows[k], "bounce_height_max_m"), 90 - fallen_before, 1e-4) << k;
    }
    const bool is_last = k + 1 == rows.size();
    EXPECT_EQ(rows[k].at("deposits"), is_last ? "7" : "0");
    EXPECT_EQ(rows[k].at("impacts"), is_last ? "7" : "0");
  }
}

TEST(EnvelopeTable, OmitsUnknownHeights) {
  const Row row = envelopes_of(launch_off_a_cliff, false).front();
  EXPECT_TRUE(row.contains("velocity_p50_m_s"));
  EXPECT_TRUE(std::ranges::none_of(row, [](const auto& cell) { return cell.first.starts_with("bounce"); }));
}

TEST(EnvelopeTable, HasAllCellsBetweenTheFirstAndTheLast) {
  std::string two = launch_off_a_cliff;
  two.replace(two.find("horizontal_velocity_m_s = 10"), 28, "speed_m_s = 0");
  two += "[[seeder]]\nposition = [500090, 30]\nmass_kg = 1\n";
  const std::vector<Row> rows = envelopes_of(two);
  ASSERT_EQ(rows.size(), 46U);
  EXPECT_EQ(rows.front().at("reach_share"), "0.875");
  EXPECT_EQ(rows.back().at("passages"), "1");
  for (std::size_t k = 1; k + 1 < rows.size(); ++k) {
    EXPECT_EQ(rows[k].at("passages"), "0");
    EXPECT_EQ(rows[k].at("deposits"), "0");
    EXPECT_EQ(rows[k].at("velocity_max_m_s"), "");
  }
}

}  // namespace
}  // namespace talus
