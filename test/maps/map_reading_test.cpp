// Reads maps that were written.

#include "talus/maps/map_reading.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "support/sample_run.hpp"
#include "talus/core/problems.hpp"
#include "talus/maps/map_files.hpp"
#include "talus/maps/source_maps.hpp"

namespace talus {
namespace {

using sample_run::Folder;

#ifdef TALUS_HAS_GDAL

const MapSelection three_percentiles{.percentiles = {50, 9, 99.5}};

/// Rocks on cells of 2 x 2 m in national coordinates: each in one of `cells`, with its number plus one as its velocity.
Maps rocks_in(const std::vector<MapCell>& cells) {
  Maps maps(MapGrid({2'600'000, 1'200'000}, 2, {}));
  std::vector<std::vector<MapVisit>> visits;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const auto value = static_cast<float>(k + 1);
    visits.push_back({MapVisit{cells[k], {4 * value, 3 * value, value, 0.5F * value}, 0, false}});
  }
  std::vector<std::span<const MapVisit>> lists(visits.begin(), visits.end());
  maps.add(cells.size(), lists);
  return maps;
}

MapFile named(const std::vector<MapFile>& maps, const std::string& name) {
  const auto found = std::ranges::find(maps, name, &MapFile::name);
  EXPECT_NE(found, maps.end()) << name;
  return found == maps.end() ? MapFile{} : *found;
}

TEST(MapsOfARun, AreListedWithTheirMeaning) {
  const Folder work("map-reading");
  const Maps maps = rocks_in({{0, 0}, {1, 0}, {1, 0}, {2, 1}});
  const auto names = write_maps(maps, three_percentiles, "", work.path / "maps");
  const auto found = maps_of_run(work.path);
  ASSERT_EQ(found.size(), names.size());
  EXPECT_EQ(found.front().name, "passages");
  EXPECT_EQ(found.front().meaning, "rocks that were in the cell");
  const MapFile velocity = named(found, "velocity_max_m_s");
  EXPECT_EQ(velocity.unit, "m/s");
  EXPECT_EQ(velocity.range.greatest, 4);
  EXPECT_EQ(velocity.source, "");
  const MapFile energy = named(found, "energy_total_max_kJ");
  EXPECT_EQ(energy.unit, "kJ");
  EXPECT_EQ(energy.limits, (ClassLimits{30, 100, 300, 1000, 3000}));
  EXPECT_EQ(energy.range.least, 0.004);
  EXPECT_EQ(energy.range.greatest, 0.016);
  // Percentiles are ascending, in whatever order they were asked for.
  std::vector<std::string> of_velocity;
  for (const MapFile& map : found)
    if (map.name.starts_with("velocity_p")) of_velocity.push_back(map.name);
  EXPECT_EQ(of_velocity, (std::vector<std::string>{"velocity_p9_m_s", "velocity_p50_m_s", "velocity_p99.5_m_s"}));
}

TEST(MapsOfARun, AreListedWithoutARangeIfTheStyleIsAPipe) {
  const Folder work("map-reading");
  (void)write_maps(rocks_in({{0, 0}}), three_percentiles, "", work.path / "maps");
  const auto style = work.path / "maps/velocity_max_m_s.qml";
  ASSERT_TRUE(std::filesystem::remove(style));
  ASSERT_EQ(::mkfifo(style.c_str(), 0600), 0);  // without a writer
  EXPECT_EQ(named(maps_of_run(work.path), "velocity_max_m_s").range.greatest, 0);
  EXPECT_EQ(named(maps_of_run(work.path), "velocity_mean_m_s").range.greatest, 1);
}

TEST(MapsOfARun, ListThoseOfEachSourceAfterThoseOfAll) {
  const Folder work("map-reading");
  std::vector<Maps> by_source;
  by_source.push_back(rocks_in({{0, 0}}));
  by_source.push_back(rocks_in({{0, 0}, {3, 3}}));
  const std::vector<std::string> sources{"Crest", "a/b, c"};
  (void)write_maps(by_source[1], three_percentiles, "", work.path / "maps");
  write_source_maps(by_source, sources, three_percentiles, "", work.path / "maps" / "by_source");
  const auto found = maps_of_run(work.path);
  EXPECT_EQ(found.front().source, "");
  EXPECT_EQ(named(found, "by_source/Crest/passages").source, "Crest");
  const MapFile other = named(found, "by_source/a_b, c/velocity_max_m_s");
  EXPECT_EQ(other.source, "a/b, c");
  EXPECT_EQ(read_map(work.path, other, 1024).columns, 4);
}

TEST(AMap, IsReadFromTheSouth) {
  const Folder work("map-reading");
  (void)write_maps(rocks_in({{0, 0}, {1, 0}, {2, 1}}), three_percentiles, "", work.path / "maps");
  const auto found = maps_of_run(work.path);
  const MapValues map = read_map(work.path, named(found, "velocity_max_m_s"), least_pixels);
  EXPECT_EQ(map.origin, (std::array<double, 2>{2'600'000, 1'200'000}));
  EXPECT_EQ(map.cell, (std::array<double, 2>{2, 2}));
  ASSERT_EQ(map.columns, 3);
  ASSERT_EQ(map.rows, 2);
  EXPECT_EQ(map.values[0], 1);
  EXPECT_EQ(map.values[1], 2);
  EXPECT_EQ(map.values[5], 3);
  EXPECT_TRUE(std::isnan(map.values[2]) && std::isnan(map.values[3]) && std::isnan(map.values[4]));
  const MapValues passages = read_map(work.path, named(found, "passages"), least_pixels);
  EXPECT_EQ(passages.values[0], 1);
  EXPECT_TRUE(std::isnan(passages.values[2])) << "where no rock was there is nothing to count";
}

// 700 x 300 cells, with overviews of 350 x 150 and 175 x 75.
TEST(AMap, IsReadAtTheRequestedResolution) {
  const Folder work("map-reading");
  const std::vector<MapCell> cells{{0, 0}, {699, 299}, {351, 10}, {350, 11}};
  (void)write_maps(rocks_in(cells), three_percentiles, "", work.path / "maps");
  const MapFile velocity = named(maps_of_run(work.path), "velocity_max_m_s");
  EXPECT_EQ(read_map(work.path, velocity, 700).columns, 700);
  const MapValues half = read_map(work.path, velocity, 699);
  EXPECT_EQ(half.columns, 350);
  EXPECT_EQ(half.cell, (std::array<double, 2>{4, 4}));
  EXPECT_EQ(half.origin, (std::array<double, 2>{2'600'000, 1'200'000}));
  EXPECT_EQ(half.values[0], 1);
  EXPECT_EQ(half.values[149 * 350 + 349], 2);
  EXPECT_EQ(half.values[5 * 350 + 175], 4) << "the greater of two rocks";
  const MapValues quarter = read_map(work.path, velocity, 349);
  EXPECT_EQ(quarter.columns, 175);
  EXPECT_EQ(quarter.rows, 75);
}

// With an odd number of rows the coarser map reaches further south, where it has no cells; its northern edge stays.
TEST(AMap, KeepsItsPlaceAtACoarserResolution) {
  const Folder work("map-reading");
  (void)write_maps(rocks_in({{0, 0}, {600, 300}}), three_percentiles, "", work.path / "maps");
  const MapFile velocity = named(maps_of_run(work.path), "velocity_max_m_s");
  const MapValues half = read_map(work.path, velocity, 600);
  EXPECT_EQ(half.columns, 301);
  EXPECT_EQ(half.rows, 151);
  EXPECT_EQ(half.origin[1] + half.rows * half.cell[1], 1'200'000 + 301 * 2);
  EXPECT_EQ(half.values.back(), 2);
}

TEST(AMap, IsRefusedIfDamaged) {
  const Folder work("map-reading");
  (void)write_maps(rocks_in({{0, 0}}), three_percentiles, "", work.path / "maps");
  work.write("maps/passages.tif", "no picture");
  EXPECT_THROW((void)maps_of_run(work.path), BadInput);
}

#endif

TEST(MapsOfARun, AreEmptyForARunWithoutMaps) {
  const Folder work("map-reading");
  EXPECT_TRUE(maps_of_run(work.path).empty());
}

TEST(MapClasses, CoverAllValuesFromZero) {
  const auto classes = map_classes({30, 100, 300, 1000, 3000});
  EXPECT_EQ(classes.front().from, 0);
  EXPECT_EQ(classes.front().to, 30);
  for (std::size_t k = 1; k < classes.size(); ++k) EXPECT_EQ(classes[k].from, classes[k - 1].to);
  EXPECT_EQ(classes.back().from, 3000);
  EXPECT_TRUE(std::isinf(classes.back().to));
  EXPECT_EQ(classes.front().colour, (std::array<std::uint8_t, 3>{255, 255, 178}));
}

}  // namespace
}  // namespace talus
