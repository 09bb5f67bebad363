// Maps as files: read back with GDAL, as a geographic information system would.

#include "talus/io/map_files.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "cli/program.hpp"
#include "talus/core/problems.hpp"
#include "talus/io/map_style.hpp"

#ifdef TALUS_HAS_GDAL
#include <gdal_priv.h>
#include <ogr_spatialref.h>
#endif

namespace talus::io {
namespace {

using test::Workplace;

#ifdef TALUS_HAS_GDAL

constexpr double percentiles[] = {50, 99.5};

/// Two rocks on cells of 2 m: one goes from (0, 0) to (2, 1), the other is in (2, 1) only, on coordinates of a country.
Maps two_rocks() {
  Maps maps(MapGrid({2'600'000, 1'200'000}, 2, {}));
  const auto visit = [](MapCell cell, float value, std::uint32_t impacts, bool is_deposit) {
    return MapVisit{cell, {4 * value, 3 * value, 2 * value, value}, impacts, is_deposit};
  };
  const std::vector<MapVisit> visits[] = {
      {visit({0, 0}, 10, 0, false), visit({1, 0}, 20, 3, false), visit({2, 1}, 30, 1, true)},
      {visit({2, 1}, 50, 2, false)}};
  maps.add(2, visits);
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

Read read_back(const std::filesystem::path& file) {
  GDALAllRegister();
  Read read;
  const GDALDatasetUniquePtr raster(GDALDataset::Open(file.c_str(), GDAL_OF_RASTER | GDAL_OF_VERBOSE_ERROR));
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

TEST(MapFiles, AreReadBackAsTheyWereMeant) {
  const Workplace work;
  OGRSpatialReference crs;
  crs.importFromEPSG(2056);
  char* wkt = nullptr;
  crs.exportToWkt(&wkt);
  (void)write_maps(two_rocks(), percentiles, wkt, work / "maps");
  CPLFree(wkt);

  const Read passages = read_back(work / "maps/passages.tif");
  EXPECT_EQ(passages.columns, 3);
  EXPECT_EQ(passages.rows, 2);
  EXPECT_EQ(passages.geotransform, (std::array<double, 6>{2'600'000, 2, 0, 1'200'004, 0, -2}));
  EXPECT_EQ(passages.authority, "2056");
  EXPECT_EQ(passages.layout, "COG");
  EXPECT_EQ(passages.compression, "DEFLATE");
  EXPECT_EQ(passages.type, GDT_UInt32);
  EXPECT_EQ(passages.nodata, 0);
  EXPECT_EQ(passages.values, (std::vector<double>{0, 0, 2, 1, 1, 0}));
  EXPECT_EQ(read_back(work / "maps/deposits.tif").values, (std::vector<double>{0, 0, 1, 0, 0, 0}));
  EXPECT_EQ(read_back(work / "maps/impacts.tif").values, (std::vector<double>{0, 0, 3, 0, 3, 0}));
  EXPECT_EQ(read_back(work / "maps/reach_share.tif").values, (std::vector<double>{-9999, -9999, 1, 0.5, 0.5, -9999}));

  const Read energy = read_back(work / "maps/energy_total_max_J.tif");
  EXPECT_EQ(energy.type, GDT_Float32);
  EXPECT_EQ(energy.nodata, -9999);
  EXPECT_EQ(energy.unit, "J");
  EXPECT_EQ(energy.description, "kinetic energy, translational and rotational: greatest of all rocks");
  EXPECT_EQ(energy.values, (std::vector<double>{-9999, -9999, 200, 40, 80, -9999}));
  EXPECT_EQ(read_back(work / "maps/energy_translational_mean_J.tif").values[2], 120);
  EXPECT_NEAR(read_back(work / "maps/velocity_p50_m_s.tif").values[2], 80, 0.8);
  EXPECT_NEAR(read_back(work / "maps/bounce_height_p99.5_m.tif").values[2], 49.9, 0.5);
}

TEST(MapFiles, AreTheListThatIsDocumented) {
  const Workplace work;
  const auto names = write_maps(two_rocks(), percentiles, "", work / "maps");
  std::set<std::string> expected;
  for (const std::string& name : names) {
    expected.insert(name + ".tif");
    expected.insert(name + ".qml");
  }
  EXPECT_EQ(names.size(), 4U + 4U * 4U);
  EXPECT_EQ(files_in(work / "maps"), expected);  // and nothing half written
  EXPECT_EQ(read_back(work / "maps/passages.tif").authority, "");
}

TEST(MapFiles, LargeOnesHaveOverviewsInWhichATrackStaysVisible) {
  const Workplace work;
  Maps maps(MapGrid({0, 0}, 1, {}));
  std::vector<MapVisit> track;
  for (std::int32_t k = 0; k < 1500; ++k) track.push_back({{k, k / 2}, {1, 1, 1, 1}, 0, false});
  maps.add(1, std::span(&track, 1));
  (void)write_maps(maps, {}, "", work / "maps");
  const Read read = read_back(work / "maps/velocity_max_m_s.tif");
  EXPECT_EQ(read.columns, 1500);
  EXPECT_EQ(read.rows, 750);
  ASSERT_GE(read.overviews, 2);
  EXPECT_EQ(read.values[749 * 1500], 1);  // south-west
  EXPECT_EQ(read.values[1499], 1);        // north-east
  EXPECT_EQ(read.values[0], -9999);
  const GDALDatasetUniquePtr raster(GDALDataset::Open((work / "maps/velocity_max_m_s.tif").c_str()));
  GDALRasterBand& coarse = *raster->GetRasterBand(1)->GetOverview(1);
  std::vector<double> values(static_cast<std::size_t>(coarse.GetXSize()) * static_cast<std::size_t>(coarse.GetYSize()));
  ASSERT_EQ(coarse.RasterIO(GF_Read, 0, 0, coarse.GetXSize(), coarse.GetYSize(), values.data(), coarse.GetXSize(),
                            coarse.GetYSize(), GDT_Float64, 0, 0, nullptr),
            CE_None);
  EXPECT_GE(std::count(values.begin(), values.end(), 1.0), coarse.GetXSize());
}

TEST(MapFiles, WithoutARockThereAreNone) {
  const Workplace work;
  EXPECT_TRUE(write_maps(Maps(MapGrid({0, 0}, 1, {})), percentiles, "", work / "maps").empty());
  EXPECT_FALSE(std::filesystem::exists(work / "maps"));
}

TEST(MapFiles, AFolderThatCannotBeMadeIsRefused) {
  const Workplace work;
  work.write("maps", "a file in the way");
  EXPECT_THROW((void)write_maps(two_rocks(), percentiles, "", work / "maps"), BadInput);
}

#else

TEST(MapFiles, WithoutGdalTheyAreRefused) {
  EXPECT_FALSE(can_write_maps());
  EXPECT_THROW((void)write_maps(Maps(MapGrid({0, 0}, 1, {})), {}, "", "maps"), BadInput);
}

#endif

TEST(MapStyle, ColoursFromTheLeastToTheGreatestValue) {
  const std::string logarithmic = qgis_style(ColourScale::logarithmic, 1, 1e6);
  EXPECT_NE(logarithmic.find("classificationMin=\"1\" classificationMax=\"1000000\""), std::string::npos);
  EXPECT_NE(logarithmic.find("<item value=\"1000\" label=\"1e+03\" color=\"#fd8d3c\""), std::string::npos);
  const std::string linear = qgis_style(ColourScale::linear, 3, 6);
  EXPECT_NE(linear.find("<item value=\"0\" label=\"0\" color=\"#ffffb2\""), std::string::npos);
  EXPECT_NE(linear.find("<item value=\"6\" label=\"6\" color=\"#b10026\""), std::string::npos);
}

}  // namespace
}  // namespace talus::io
