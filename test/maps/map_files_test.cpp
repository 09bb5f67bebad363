// Map files, read back with GDAL as a geographic information system would.

#include "talus/maps/map_files.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>
#include <numeric>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/program.hpp"
#include "support/dice.hpp"
#include "support/file_size_limit.hpp"
#include "talus/core/problems.hpp"
#include "talus/maps/map_style.hpp"

#ifdef TALUS_HAS_GDAL
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include "talus/gdal/gdal_raster.hpp"
#endif

namespace talus {
namespace {

using test::Workplace;

#ifdef TALUS_HAS_GDAL

const MapSelection selection{.percentiles = {50, 99.5}};

/// Two rocks on cells of 2 m in national coordinates: one goes from (0, 0) to (2, 1), the other is in (2, 1) only.
Maps two_rocks() {
  Maps maps(MapGrid({2'600'000, 1'200'000}, 2, {}));
  const auto visit = [](MapCell cell, float value, std::uint32_t impacts, bool is_deposit) {
    return MapVisit{cell, {4 * value, 3 * value, 2 * value, value}, impacts, is_deposit};
  };
  const std::vector<MapVisit> visits[] = {
      {visit({0, 0}, 10, 0, false), visit({1, 0}, 20, 3, false), visit({2, 1}, 30, 1, true)},
      {visit({2, 1}, 50, 2, false)}};
  const std::span<const MapVisit> lists[] = {visits[0], visits[1]};
  maps.add(2, lists);
  return maps;
}

struct Read {
  int columns = 0, rows = 0, overviews = 0;
  std::array<double, 6> geotransform{};
  double nodata = 0;
  std::string layout, compression, description, unit, authority;
  GDALDataType type = GDT_Unknown;
  std::vector<double> values;  // from north to south
};

GDALDatasetUniquePtr opened(const std::filesystem::path& file) {
  const GdalMessages gdal{GdalFiles(file)};
  return GDALDatasetUniquePtr(GDALDataset::Open(file.c_str(), GDAL_OF_RASTER | GDAL_OF_VERBOSE_ERROR));
}

Read read_back(const std::filesystem::path& file) {
  Read read;
  const GDALDatasetUniquePtr raster = opened(file);
  if (!raster) return read;
  read.columns = raster->GetRasterXSize();
  read.rows = raster->GetRasterYSize();
  raster->GetGeoTransform(read.geotransform.data());
  const auto text = [](const char* found) { return std::string(found != nullptr ? found : ""); };
  read.layout = text(raster->GetMetadataItem("LAYOUT", "IMAGE_STRUCTURE"));
  read.compression = text(raster->GetMetadataItem("COMPRESSION", "IMAGE_STRUCTURE"));
  if (const auto* crs = raster->GetSpatialRef()) read.authority = text(crs->GetAuthorityCode(nullptr));
  GDALRasterBand& band = *raster->GetRasterBand(1);
  read.nodata = band.GetNoDataValue();
  read.overviews = band.GetOverviewCount();
  read.description = band.GetDescription();
  read.unit = band.GetUnitType();
  read.type = band.GetRasterDataType();
  read.values.resize(static_cast<std::size_t>(read.columns) * static_cast<std::size_t>(read.rows));
  EXPECT_EQ(band.RasterIO(GF_Read, 0, 0, read.columns, read.rows, read.values.data(), read.columns, read.rows,
                          GDT_Float64, 0, 0, nullptr),
            CE_None);
  return read;
}

std::set<std::string> files_in(const std::filesystem::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) names.insert(entry.path().filename());
  return names;
}

TEST(MapFiles, ReplaceThePartsOfAKilledRun) {
  const Workplace work;
  std::filesystem::create_directories(work / "maps");
  // The head of a TIFF whose first directory has no entries.
  work.write("maps/passages.tif.part", std::string("II*\0\x08\0\0\0\0\0", 10));
  (void)write_maps(two_rocks(), selection, "", work / "maps");
  EXPECT_EQ(read_back(work / "maps/passages.tif").values, (std::vector<double>{0, 0, 2, 1, 1, 0}));
  EXPECT_FALSE(std::filesystem::exists(work / "maps/passages.tif.part"));
}

TEST(MapFiles, AreReadBackAsWritten) {
  const Workplace work;
  OGRSpatialReference crs;
  crs.importFromEPSG(2056);
  char* wkt = nullptr;
  crs.exportToWkt(&wkt);
  (void)write_maps(two_rocks(), selection, wkt, work / "maps");
  CPLFree(wkt);

  const Read passages = read_back(work / "maps/passages.tif");
  EXPECT_EQ(passages.columns, 3);
  EXPECT_EQ(passages.rows, 2);
  EXPECT_EQ(passages.geotransform, (std::array<double, 6>{2'600'000, 2, 0, 1'200'004, 0, -2}));
  EXPECT_EQ(passages.authority, "2056");
  // Cloud-optimised: the list of blocks comes first.
  EXPECT_EQ(work.read("maps/passages.tif").substr(0, 8), std::string("II*\0\x08\0\0\0", 8));
  EXPECT_EQ(passages.compression, "ZSTD");
  EXPECT_EQ(passages.type, GDT_UInt32);
  EXPECT_EQ(passages.nodata, 0);
  EXPECT_EQ(passages.values, (std::vector<double>{0, 0, 2, 1, 1, 0}));
  EXPECT_EQ(read_back(work / "maps/deposits.tif").values, (std::vector<double>{0, 0, 1, 0, 0, 0}));
  EXPECT_EQ(read_back(work / "maps/impacts.tif").values, (std::vector<double>{0, 0, 3, 0, 3, 0}));
  EXPECT_EQ(read_back(work / "maps/reach_share.tif").values, (std::vector<double>{-9999, -9999, 1, 0.5, 0.5, -9999}));

  const Read energy = read_back(work / "maps/energy_total_max_kJ.tif");
  EXPECT_EQ(energy.type, GDT_Float32);
  EXPECT_EQ(energy.nodata, -9999);
  EXPECT_EQ(energy.unit, "kJ");
  EXPECT_EQ(energy.description, "total kinetic energy: maximum over all rocks");
  EXPECT_EQ(energy.values, (std::vector<double>{-9999, -9999, 0.2F, 0.04F, 0.08F, -9999}));
  EXPECT_EQ(read_back(work / "maps/energy_translational_mean_kJ.tif").values[2], 0.12F);
  EXPECT_NEAR(read_back(work / "maps/velocity_p50_m_s.tif").values[2], 80, 0.8);
  EXPECT_NEAR(read_back(work / "maps/bounce_height_p99.5_m.tif").values[2], 49.9, 0.5);
}

TEST(MapFiles, OfAMapInMemoryAreThoseOfARun) {
  const Workplace work;
  (void)write_maps(two_rocks(), selection, "", work / "maps");
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const std::vector<MapKind> kinds = map_kinds(selection);
  for (const auto& [name, values] : {std::pair("passages", std::vector<double>{none, none, 2, 1, 1, none}),
                                     std::pair("reach_share", std::vector<double>{none, none, 1, 0.5, 0.5, none})}) {
    const auto kind = std::ranges::find(kinds, name, &MapKind::name);
    ASSERT_NE(kind, kinds.end());
    const std::filesystem::path file = work / "one.tif";
    write_map(*kind, {3, 2, {2'600'000, 1'200'004}, {2, 2}, values}, "", file);
    const Read one = read_back(file), all = read_back(work / "maps" / (std::string(name) + ".tif"));
    EXPECT_EQ(one.values, all.values);
    EXPECT_EQ(one.geotransform, all.geotransform);
    EXPECT_EQ(one.type, all.type);
    EXPECT_EQ(one.description, all.description);
    EXPECT_EQ(work.read("one.qml"), work.read("maps/" + std::string(name) + ".qml"));
  }
}

TEST(MapFiles, AreThoseOfTheDocumentation) {
  const Workplace work;
  const auto names = write_maps(two_rocks(), selection, "", work / "maps");
  std::set<std::string> expected;
  for (const std::string& name : names) {
    expected.insert(name + ".tif");
    expected.insert(name + ".qml");
  }
  EXPECT_EQ(names.size(), 4U + 4U * 4U);
  EXPECT_EQ(files_in(work / "maps"), expected);  // and no parts
  EXPECT_EQ(read_back(work / "maps/passages.tif").authority, "");
}

TEST(MapFiles, HaveOverviewsInWhichATrackStaysVisible) {
  const Workplace work;
  Maps maps(MapGrid({0, 0}, 1, {}));
  std::vector<MapVisit> track;
  for (std::int32_t k = 0; k < 3000; ++k) track.push_back({{k, k / 2}, {1, 1, 1, 1}, 0, false});
  const std::span<const MapVisit> list(track);
  maps.add(1, std::span(&list, 1));
  (void)write_maps(maps, {}, "", work / "maps");
  const Read read = read_back(work / "maps/velocity_max_m_s.tif");
  EXPECT_EQ(read.columns, 3000);
  EXPECT_EQ(read.rows, 1500);
  ASSERT_GE(read.overviews, 2);
  EXPECT_EQ(read.layout, "COG");
  EXPECT_EQ(read.values[1499 * 3000], 1);  // south-west
  EXPECT_EQ(read.values[2999], 1);         // north-east
  EXPECT_EQ(read.values[0], -9999);
  const GDALDatasetUniquePtr raster = opened(work / "maps/velocity_max_m_s.tif");
  GDALRasterBand& coarse = *raster->GetRasterBand(1)->GetOverview(1);
  std::vector<double> values(static_cast<std::size_t>(coarse.GetXSize()) * static_cast<std::size_t>(coarse.GetYSize()));
  ASSERT_EQ(coarse.RasterIO(GF_Read, 0, 0, coarse.GetXSize(), coarse.GetYSize(), values.data(), coarse.GetXSize(),
                            coarse.GetYSize(), GDT_Float64, 0, 0, nullptr),
            CE_None);
  EXPECT_GE(std::count(values.begin(), values.end(), 1.0), coarse.GetXSize());
}

/// All cells of a band, from north to south.
std::vector<double> values_of(GDALRasterBand& band) {
  std::vector<double> values(static_cast<std::size_t>(band.GetXSize()) * static_cast<std::size_t>(band.GetYSize()));
  EXPECT_EQ(band.RasterIO(GF_Read, 0, 0, band.GetXSize(), band.GetYSize(), values.data(), band.GetXSize(),
                          band.GetYSize(), GDT_Float64, 0, 0, nullptr),
            CE_None);
  return values;
}

// 2,401 x 601 cells, odd on both sides at every level, with holes of every shape.
TEST(MapFiles, HaveOverviewsOfTheMaximumOfFourCells) {
  const Workplace work;
  testing_tools::Dice dice(7);
  Maps maps(MapGrid({0, 0}, 1, {}));
  std::vector<MapVisit> visits{{{0, 0}, {1, 1, 1, 1}, 1, true}, {{2400, 600}, {1, 1, 1, 1}, 1, true}};
  for (int k = 0; k < 400'000; ++k) {
    const auto value = static_cast<float>(dice.magnitude(1, 1e6));
    visits.push_back({{static_cast<std::int32_t>(dice.below(2401)), static_cast<std::int32_t>(dice.below(601))},
                      {value, value, value, value},
                      static_cast<std::uint32_t>(dice.below(3)),
                      dice.chance(0.3)});
  }
  const std::span<const MapVisit> list(visits);
  maps.add(visits.size(), std::span(&list, 1));
  (void)write_maps(maps, selection, "", work / "maps");
  for (const char* name : {"passages", "deposits", "impacts", "reach_share", "energy_total_max_kJ", "velocity_p50_m_s",
                           "bounce_height_mean_m"}) {
    const bool is_mean = std::string_view(name).find("mean") != std::string_view::npos;
    const GDALDatasetUniquePtr raster = opened((work / "maps" / name).replace_extension(".tif"));
    ASSERT_TRUE(raster) << name;
    GDALRasterBand* fine = raster->GetRasterBand(1);
    const double no_data = fine->GetNoDataValue();
    ASSERT_EQ(fine->GetOverviewCount(), 4) << name;
    std::vector<double> cells = values_of(*fine);
    for (int level = 0; level < 4; ++level) {
      GDALRasterBand& coarse = *raster->GetRasterBand(1)->GetOverview(level);
      EXPECT_EQ(coarse.GetXSize(), (fine->GetXSize() + 1) / 2);
      EXPECT_EQ(coarse.GetYSize(), (fine->GetYSize() + 1) / 2);
      EXPECT_EQ(coarse.GetNoDataValue(), no_data);
      const std::vector<double> found = values_of(coarse);
      std::size_t wrong = 0, empty = 0;
      for (int row = 0; row < coarse.GetYSize(); ++row) {
        for (int column = 0; column < coarse.GetXSize(); ++column) {
          std::vector<double> four;
          for (const int j : {2 * row, 2 * row + 1}) {
            for (const int i : {2 * column, 2 * column + 1}) {
              if (i >= fine->GetXSize() || j >= fine->GetYSize()) continue;
              const double value = cells[static_cast<std::size_t>(j * fine->GetXSize() + i)];
              if (value != no_data) four.push_back(value);
            }
          }
          double expected = no_data;
          if (!four.empty()) {
            expected = is_mean ? std::accumulate(four.begin(), four.end(), 0.0) / static_cast<double>(four.size())
                               : *std::max_element(four.begin(), four.end());
          }
          const double value = found[static_cast<std::size_t>(row * coarse.GetXSize() + column)];
          wrong += std::abs(value - expected) > 1e-6 * std::abs(expected);
          empty += four.empty();
        }
      }
      EXPECT_EQ(wrong, 0U) << name << ", overview " << level;
      EXPECT_TRUE(level > 0 || empty > 100) << name;  // so that holes are tested
      fine = &coarse;
      cells = found;
    }
  }
}

TEST(MapFiles, TakeNoSpaceForCellsWithoutRocks) {
  const Workplace work;
  Maps maps(MapGrid({0, 0}, 1, {}));
  const std::vector<MapVisit> far_apart{{{0, 0}, {1, 1, 1, 1}, 0, false}, {{6'000, 4'000}, {9, 9, 9, 9}, 0, false}};
  const std::span<const MapVisit> list(far_apart);
  maps.add(1, std::span(&list, 1));
  (void)write_maps(maps, {}, "", work / "maps");
  const auto file = work / "maps/energy_total_max_kJ.tif";
  EXPECT_LT(std::filesystem::file_size(file), 20'000U);  // of 24 million cells
  const GDALDatasetUniquePtr raster = opened(file);
  GDALRasterBand& smallest = *raster->GetRasterBand(1)->GetOverview(raster->GetRasterBand(1)->GetOverviewCount() - 1);
  const std::vector<double> values = values_of(smallest);
  EXPECT_EQ(std::count(values.begin(), values.end(), -9999), static_cast<std::ptrdiff_t>(values.size()) - 2);
  EXPECT_EQ(values[static_cast<std::size_t>(smallest.GetXSize()) - 1], 0.009F);
}

TEST(MapFiles, AreOnTheCellsOfARasterThatAreNotSquare) {
  const Workplace work;
  Maps maps(MapGrid::around_nodes({100.5, 201}, {1, 2}, {{2'600'000, 1'200'000, 0}}));
  const std::vector<MapVisit> visits{{{0, 0}, {1, 1, 1, 1}, 0, false}, {{3, 1}, {2, 2, 2, 2}, 0, false}};
  const std::span<const MapVisit> list(visits);
  maps.add(1, std::span(&list, 1));
  (void)write_maps(maps, {}, "", work / "maps");
  const Read read = read_back(work / "maps/velocity_max_m_s.tif");
  EXPECT_EQ(read.geotransform, (std::array<double, 6>{2'600'100, 1, 0, 1'200'204, 0, -2}));
  EXPECT_EQ(read.values, (std::vector<double>{-9999, -9999, -9999, 2, 1, -9999, -9999, -9999}));
}

TEST(MapFiles, RefuseAFullDiskAndLeaveNoParts) {
  const Workplace work;
  Maps maps(MapGrid({0, 0}, 1, {}));
  testing_tools::Dice dice(8);
  std::vector<MapVisit> visits;
  for (std::int32_t k = 0; k < 250'000; ++k) {
    const auto value = static_cast<float>(dice.magnitude(1, 1e6));
    visits.push_back({{k % 500, k / 500}, {value, value, value, value}, 0, false});
  }
  const std::span<const MapVisit> list(visits);
  maps.add(1, std::span(&list, 1));
  try {
    const testing_tools::FileSizeLimit limit(65536);
    (void)write_maps(maps, {}, "", work / "maps");
    ADD_FAILURE() << "was written";
  } catch (const BadInput& bad) {
    const std::string text = bad.what();
    EXPECT_NE(text.find(": cannot write this map (GDAL: "), std::string::npos) << text;
    EXPECT_NE(text.find("). Free some space, or choose another folder with -o"), std::string::npos) << text;
  }
  for (const std::string& file : files_in(work / "maps")) EXPECT_EQ(file.find(".part"), std::string::npos) << file;
  EXPECT_FALSE(files_in(work / "maps").contains("energy_total_max_kJ.tif"));
}

// Whatever the values: maps of two runs must be comparable.
TEST(MapFiles, OfOneKindHaveTheSameClasses) {
  const auto style_of = [](const std::string& name, float value) {
    Maps maps(MapGrid({0, 0}, 1, {}));
    const std::vector<MapVisit> visits{{{0, 0}, {value, value, value, value}, 0, false}};
    const std::span<const MapVisit> list(visits);
    maps.add(1, std::span(&list, 1));
    const Workplace work;
    (void)write_maps(maps, selection, "", work / "maps");
    const std::string style = work.read("maps/" + name + ".qml");
    EXPECT_NE(style.find("greatestValue=\""), std::string::npos);
    return style.substr(style.find("<rastershader>"));
  };
  for (const std::string name : {"energy_total_max_kJ", "velocity_mean_m_s", "bounce_height_p50_m", "passages"})
    EXPECT_EQ(style_of(name, 4000), style_of(name, 4e6F)) << name;
  EXPECT_EQ(style_of("energy_total_max_kJ", 1), style_of("energy_translational_p50_kJ", 1));
  EXPECT_NE(style_of("energy_total_max_kJ", 1), style_of("velocity_max_m_s", 1));
}

TEST(MapFiles, AreNotWrittenWithoutARock) {
  const Workplace work;
  EXPECT_TRUE(write_maps(Maps(MapGrid({0, 0}, 1, {})), selection, "", work / "maps").empty());
  EXPECT_FALSE(std::filesystem::exists(work / "maps"));
}

TEST(MapFiles, RefuseAFolderThatCannotBeCreated) {
  const Workplace work;
  work.write("maps", "a file in the way");
  EXPECT_THROW((void)write_maps(two_rocks(), selection, "", work / "maps"), BadInput);
}

#else

TEST(MapFiles, AreRefusedWithoutGdal) {
  EXPECT_FALSE(can_write_maps());
  EXPECT_THROW((void)write_maps(Maps(MapGrid({0, 0}, 1, {})), {}, "", "maps"), BadInput);
}

#endif

TEST(MapStyle, HasFixedClassesAndTheRangeOfTheValues) {
  const std::string style = qgis_style({30, 100, 300, 1000, 3000}, {"kJ"}, {0.5, 794});
  EXPECT_NE(style.find("leastValue=\"0.5\" greatestValue=\"794\""), std::string::npos);
  EXPECT_NE(style.find("colorRampType=\"DISCRETE\""), std::string::npos);
  EXPECT_NE(style.find("<item value=\"30\" label=\"0 to 30 kJ\" color=\"#ffffb2\""), std::string::npos);
  EXPECT_NE(style.find("<item value=\"300\" label=\"100 to 300 kJ\" color=\"#fda63f\""), std::string::npos);
  EXPECT_NE(style.find("<item value=\"inf\" label=\"3000 kJ and more\" color=\"#800026\""), std::string::npos);
}

// The smallest limit of a share is a hundred-thousandth, 1e-05 as a plain number.
TEST(MapStyle, ShowsSharesInPercent) {
  const std::string style = qgis_style({1e-5, 1e-4, 1e-3, 1e-2, 1e-1}, {"%", 0.01}, {1e-6, 0.5});
  EXPECT_NE(style.find("<item value=\"1e-05\" label=\"0 to 0.001 %\""), std::string::npos);
  EXPECT_NE(style.find("<item value=\"0.1\" label=\"1 to 10 %\""), std::string::npos);
  EXPECT_NE(style.find("<item value=\"inf\" label=\"10 % and more\""), std::string::npos);
}

}  // namespace
}  // namespace talus
