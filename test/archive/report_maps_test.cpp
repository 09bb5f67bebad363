// The maps of the report.

#include "talus/archive/report_maps.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <fstream>
#include <span>
#include <string>
#include <vector>

#include "support/sample_run.hpp"
#include "talus/core/problems.hpp"
#include "talus/maps/map_files.hpp"

namespace talus {
namespace {

using sample_run::Folder;

/// A rock that crosses cells from west to east, with this total energy [J] and height [m] in each.
void write_maps_of(const Folder& folder, const std::vector<float>& values, const MapSelection& selection = {}) {
  std::vector<MapVisit> path;
  for (std::size_t k = 0; k < values.size(); ++k) {
    path.push_back({{static_cast<std::int32_t>(k), 0}, {values[k], values[k] / 2, 1, values[k]}, 0, false});
  }
  const std::vector<std::span<const MapVisit>> paths{path};
  Maps maps(MapGrid({2'600'000, 1'200'000}, 5, {}));
  maps.add(values.size(), paths);
  (void)write_maps(maps, selection, "", folder.path / "maps");
}

const ReportMap& named(const std::vector<ReportMap>& maps, const std::string& name) {
  for (const ReportMap& map : maps) {
    if (map.name == name) return map;
  }
  throw std::out_of_range(name);
}

TEST(ReportMaps, AreHeightEnergyVelocityAndReach) {
  if (!can_write_maps()) GTEST_SKIP() << "no maps without GDAL";
  const Folder folder("report-maps");
  write_maps_of(folder, {1, 10, 100});
  const auto maps = read_report_maps(folder.path);
  ASSERT_EQ(maps.size(), 4u);
  EXPECT_EQ(maps[0].name, "bounce_height_max_m");
  EXPECT_EQ(maps[1].name, "energy_total_max_kJ");
  EXPECT_EQ(maps[2].name, "velocity_max_m_s");
  EXPECT_EQ(maps[3].name, "reach_share");
  EXPECT_EQ(maps[1].origin, (std::array<double, 2>{2'600'000, 1'200'000}));
  EXPECT_EQ(maps[1].cell, (std::array<double, 2>{5, 5}));
  EXPECT_EQ(maps[1].columns, 3);
  EXPECT_EQ(maps[1].rows, 1);
}

/// The maximum in a cell is mostly that of one rock: the 95th percentile takes its place where the run has it.
TEST(ReportMaps, ShowPercentilesIfTheRunHasThem) {
  if (!can_write_maps()) GTEST_SKIP() << "no maps without GDAL";
  const Folder folder("report-maps");
  write_maps_of(folder, {1, 10, 100}, {.percentiles = {95}});
  const auto maps = read_report_maps(folder.path);
  ASSERT_EQ(maps.size(), 4u);
  EXPECT_EQ(maps[0].name, "bounce_height_p95_m");
  EXPECT_EQ(maps[1].name, "energy_total_p95_kJ");
  EXPECT_EQ(maps[2].name, "velocity_p95_m_s");
}

TEST(ReportMaps, HaveLevelsFromTheMinimumToTheMaximum) {
  if (!can_write_maps()) GTEST_SKIP() << "no maps without GDAL";
  const Folder folder("report-maps");
  write_maps_of(folder, {1, 10, 100});
  const auto maps = read_report_maps(folder.path);
  const ReportMap& energy = named(maps, "energy_total_max_kJ");
  EXPECT_EQ(energy.range.least, 0.001F);
  EXPECT_EQ(energy.range.greatest, 0.1F);
  EXPECT_EQ(energy.limits, (ClassLimits{30, 100, 300, 1000, 3000}));
  EXPECT_EQ(energy.levels, (std::vector<std::uint8_t>{1, 128, 255}));  // 10 is in the middle of the logarithms
  EXPECT_EQ(named(maps, "bounce_height_max_m").levels, (std::vector<std::uint8_t>{4, 26, 255}));
  EXPECT_EQ(named(maps, "velocity_max_m_s").levels, (std::vector<std::uint8_t>{255, 255, 255}));
}

// A value on the page is within half a level of the original.
TEST(ReportMaps, KeepValuesToHalfALevel) {
  if (!can_write_maps()) GTEST_SKIP() << "no maps without GDAL";
  const Folder folder("report-maps");
  std::vector<float> values;
  for (int k = 0; k < 200; ++k) values.push_back(static_cast<float>(0.5 * std::pow(1.07, k)));
  write_maps_of(folder, values);
  const auto maps = read_report_maps(folder.path);
  const auto& [name, is_logarithmic, range, limits, origin, cell, columns, rows, levels] =
      named(maps, "energy_total_max_kJ");
  const double step = std::log(range.greatest / range.least) / 254;
  for (std::size_t k = 0; k < values.size(); ++k) {
    const double shown = 1000 * range.least * std::exp(step * (levels[k] - 1));
    EXPECT_LE(std::abs(std::log(shown / values[k])), step / 2 + 1e-6) << values[k];
  }
}

TEST(ReportMaps, AreLimitedToWhatAPageCanShow) {
  if (!can_write_maps()) GTEST_SKIP() << "no maps without GDAL";
  const Folder folder("report-maps");
  std::vector<float> values(1500, 1);
  values[777] = 50;
  write_maps_of(folder, values);
  const auto maps = read_report_maps(folder.path);
  const ReportMap& energy = named(maps, "energy_total_max_kJ");
  EXPECT_EQ(energy.columns, 375);
  EXPECT_EQ(energy.cell[0], 20);
  EXPECT_EQ(energy.range.greatest, 0.05F) << "the maximum is kept";
}

TEST(ReportMaps, AreEmptyForARunWithoutMaps) {
  const Folder folder("report-maps");
  EXPECT_TRUE(read_report_maps(folder.path).empty());
}

TEST(ReportMaps, RefusesADamagedMap) {
  if (!can_write_maps()) GTEST_SKIP() << "no maps without GDAL";
  const Folder folder("report-maps");
  write_maps_of(folder, {1, 10, 100});
  folder.write("maps/reach_share.tif", "no map");
  EXPECT_THROW((void)read_report_maps(folder.path), BadInput);
}

}  // namespace
}  // namespace talus
