#include "talus/layers/layer_picture.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#ifdef TALUS_HAS_GDAL

#include <sys/stat.h>

#include <array>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "support/pictures.hpp"
#include "support/rasters.hpp"

namespace talus {
namespace {

using namespace testing_tools;
using ::testing::HasSubstr;

/// A terrain of 400 m by 300 m in Austria.
TerrainOnPlan austria() { return {{{400000, 300000}, {400400, 300300}}, wkt("EPSG:31287")}; }
TerrainOnPlan unknown() { return {austria().area, ""}; }

class LayerPictureTest : public RasterFolder {
 protected:
  [[nodiscard]] LayerPicture picture(const std::string& name, const TerrainOnPlan& terrain = austria(),
                                     std::uint32_t most = most_pixels) {
    warnings_ = Problems{};
    return picture_of_raster(path(name), terrain, warnings_, most);
  }
  [[nodiscard]] std::string refusal(const std::string& name, const TerrainOnPlan& terrain = austria()) {
    return refusal_of([&] { static_cast<void>(picture(name, terrain)); });
  }
  /// The values of a pixel in all bands.
  [[nodiscard]] std::vector<int> pixel(const LayerPicture& of, int column, int row) const {
    write("picture", of.bytes);
    const GDALDatasetUniquePtr file(GDALDataset::Open(path("picture").c_str(), GDAL_OF_RASTER));
    EXPECT_TRUE(file);
    if (!file) return {};
    EXPECT_EQ(file->GetRasterXSize(), static_cast<int>(of.columns));
    EXPECT_EQ(file->GetRasterYSize(), static_cast<int>(of.rows));
    std::vector<int> values;
    for (int band = 1; band <= file->GetRasterCount(); ++band) {
      std::uint8_t value = 0;
      EXPECT_EQ(file->GetRasterBand(band)->RasterIO(GF_Read, column, row, 1, 1, &value, 1, 1, GDT_Byte, 0, 0, nullptr),
                CE_None);
      values.push_back(value);
    }
    return values;
  }

  /// 40 x 30 cells of 10 m over the whole terrain, whose value is a function of column and row.
  template <class Value>
  static RasterSpec over_terrain(GDALDataType type, Value&& value) {
    RasterSpec spec;
    spec.columns = 40;
    spec.rows = 30;
    spec.type = type;
    spec.geotransform = {400000, 10, 0, 300300, 0, -10};
    spec.cells.clear();
    for (int row = 0; row < spec.rows; ++row)
      for (int column = 0; column < spec.columns; ++column) spec.cells.push_back(value(column, row));
    return spec;
  }
};

TEST_F(LayerPictureTest, OfOneBandOf8BitsIsGrey) {
  make("photo.tif", over_terrain(GDT_Byte, [](int column, int row) { return 4 * column + 2 * row; }));
  const LayerPicture drawn = picture("photo.tif");
  EXPECT_EQ(drawn.type, "image/jpeg");
  EXPECT_EQ(drawn.columns, 40U);
  EXPECT_EQ(drawn.rows, 30U);
  EXPECT_LT((drawn.area.low - Vec2(400000, 300000)).norm(), 1e-6);
  EXPECT_LT((drawn.area.high - Vec2(400400, 300300)).norm(), 1e-6);
  EXPECT_TRUE(drawn.ramp.empty());
  for (const int value : pixel(drawn, 20, 10)) EXPECT_NEAR(value, 100, 4);
  EXPECT_EQ(warnings(), "");
}

TEST_F(LayerPictureTest, OfMeasuredValuesHasARamp) {
  RasterSpec spec =
      over_terrain(GDT_Float32, [](int column, int) { return column == 5 ? -9999.0 : 200 + 10 * column; });
  spec.no_data = -9999;
  make("snow.tif", spec);
  const LayerPicture drawn = picture("snow.tif");
  EXPECT_EQ(drawn.type, "image/png");
  EXPECT_EQ(drawn.least, 200);
  EXPECT_EQ(drawn.most, 590);
  ASSERT_EQ(drawn.ramp.size(), 9U);
  EXPECT_EQ(drawn.ramp.front(), "#440154");
  EXPECT_EQ(pixel(drawn, 0, 3), (std::vector<int>{0x44, 0x01, 0x54, 255}));
  EXPECT_EQ(pixel(drawn, 39, 3), (std::vector<int>{0xfd, 0xe7, 0x25, 255}));
  EXPECT_EQ(pixel(drawn, 5, 3).at(3), 0);
}

TEST_F(LayerPictureTest, OfThreeBandsIsRedGreenAndBlue) {
  const std::array<int, 4> values{10, 100, 200, 60};
  for (std::size_t k = 0; k < values.size(); ++k)
    make(fmt::format("{}.tif", k), over_terrain(GDT_Byte, [&](int, int) { return values[k]; }));
  const auto whole = [] {
    return Vrt{.columns = 40,
               .rows = 30,
               .place = "<SRS>EPSG:31287</SRS><GeoTransform>400000,10,0,300300,0,-10</GeoTransform>"};
  };
  const auto expect = [&](const std::string& name, const std::array<int, 3>& wanted) {
    const std::vector<int> found = pixel(picture(name), 20, 10);
    ASSERT_EQ(found.size(), 3U);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(found[k], wanted[k], 6) << name;
  };
  const auto band = [](int file, const std::string& colour) {
    return (colour.empty() ? "" : "<ColorInterp>" + colour + "</ColorInterp>") +
           vrt_source(fmt::format("{}.tif", file));
  };
  Vrt plain = whole();
  for (int k = 0; k < 3; ++k) plain.band(band(k, ""), "Byte");
  write("plain.vrt", plain.text());
  expect("plain.vrt", {10, 100, 200});
  // Bands are chosen by their names, also of many.
  Vrt named = whole();
  named.band(band(3, "Undefined"), "Byte")
      .band(band(2, "Blue"), "Byte")
      .band(band(1, "Green"), "Byte")
      .band(band(0, "Red"), "Byte");
  write("named.vrt", named.text());
  expect("named.vrt", {10, 100, 200});
  named.band(band(3, "Undefined"), "Byte").band(band(3, "Undefined"), "Byte");
  write("many.vrt", named.text());
  expect("many.vrt", {10, 100, 200});
}

TEST_F(LayerPictureTest, IsWarpedToTheTerrain) {
  // In degrees, and larger than the terrain: a value rises by 1 every 0.0002 degrees to the east.
  OGRSpatialReference from, to;
  from.SetFromUserInput("EPSG:31287");
  to.SetFromUserInput("EPSG:4326");
  from.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  to.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  const std::unique_ptr<OGRCoordinateTransformation> change(OGRCreateCoordinateTransformation(&from, &to));
  double west = 400200, north = 300150;
  ASSERT_TRUE(change->Transform(1, &west, &north));
  west -= 0.01;
  north += 0.01;
  RasterSpec spec;
  spec.columns = spec.rows = 200;
  spec.type = GDT_Byte;
  spec.crs = "EPSG:4326";
  spec.geotransform = {west, 0.0001, 0, north, 0, -0.0001};
  spec.cells.clear();
  for (int k = 0; k < 200 * 200; ++k) spec.cells.push_back(k % 200);
  make("degrees.tif", spec);
  const LayerPicture drawn = picture("degrees.tif");
  EXPECT_LT((drawn.area.low - austria().area.low).norm(), 1e-6);
  EXPECT_LT((drawn.area.high - austria().area.high).norm(), 1e-6);
  using Pixels = std::vector<std::pair<int, int>>;
  for (const auto& [column, row] : Pixels{{3, 2}, {20, 12}, {static_cast<int>(drawn.columns) - 2, 5}}) {
    double x = 400000 + (column + 0.5) * 400 / drawn.columns, y = 300300 - (row + 0.5) * 300 / drawn.rows;
    ASSERT_TRUE(change->Transform(1, &x, &y));
    EXPECT_NEAR(pixel(drawn, column, row).at(0), (x - west) / 0.0001 - 0.5, 4);
  }
}

TEST_F(LayerPictureTest, IsCutToTheTerrain) {
  RasterSpec spec;  // 4 x 3 cells of 10 m, of which half lie over this terrain
  const LayerPicture drawn =
      (make("dem.tif", spec), picture("dem.tif", {{{400020, 299000}, {401000, 301000}}, wkt(spec.crs)}));
  EXPECT_EQ(drawn.columns, 2U);
  EXPECT_LT((drawn.area.low - Vec2(400020, 300000)).norm(), 1e-6);
  EXPECT_LT((drawn.area.high - Vec2(400040, 300030)).norm(), 1e-6);
  EXPECT_EQ(drawn.least, 3);
}

TEST_F(LayerPictureTest, IsLimitedInSizeAndReadFromOverviews) {
  make("photo.tif", over_terrain(GDT_Byte, [](int, int) { return 10; }));
  {
    const GDALDatasetUniquePtr file(GDALDataset::Open(path("photo.tif").c_str(), GDAL_OF_RASTER | GDAL_OF_UPDATE));
    ASSERT_TRUE(file);
    const int factor = 4;
    ASSERT_EQ(file->BuildOverviews("NEAREST", 1, &factor, 0, nullptr, nullptr, nullptr), CE_None);
    GDALRasterBand& overview = *file->GetRasterBand(1)->GetOverview(0);
    std::vector<std::uint8_t> other(static_cast<std::size_t>(overview.GetXSize() * overview.GetYSize()), 200);
    ASSERT_EQ(overview.RasterIO(GF_Write, 0, 0, overview.GetXSize(), overview.GetYSize(), other.data(),
                                overview.GetXSize(), overview.GetYSize(), GDT_Byte, 0, 0, nullptr),
              CE_None);
  }
  const LayerPicture small = picture("photo.tif", austria(), 8);
  EXPECT_EQ(small.columns, 8U);
  EXPECT_EQ(small.rows, 6U);
  EXPECT_NEAR(pixel(small, 3, 3).at(0), 200, 3);
  EXPECT_NEAR(pixel(picture("photo.tif"), 3, 3).at(0), 10, 3);
}

TEST_F(LayerPictureTest, MayBeAPngWithAWorldFile) {
  write("plan.png", small_png(4, 3));
  EXPECT_THAT(refusal("plan.png"), HasSubstr("plan.png: is not georeferenced"));
  write("plan.pgw", "100\n0\n0\n-100\n400050\n300250\n");
  const LayerPicture drawn = picture("plan.png");
  EXPECT_EQ(drawn.columns, 4U);
  EXPECT_NEAR(pixel(drawn, 1, 1).at(0), 0x60, 3);
  EXPECT_EQ(warnings(),
            "plan.png: warning: has no coordinate system (that of the terrain is assumed). Assign it: gdal_translate "
            "-a_srs EPSG:XXXX plan.png plan_placed.tif");
}

TEST_F(LayerPictureTest, ElsewhereIsRefused) {
  RasterSpec spec;
  spec.geotransform = {500000, 10, 0, 300030, 0, -10};
  make("far.tif", spec);
  EXPECT_EQ(
      refusal("far.tif"),
      "far.tif: does not lie over the terrain (it covers x 500000 to 500040, y 300000 to 300030; the terrain x "
      "400000 to 400400, y 300000 to 300300). Assign the right coordinate system: gdal_translate -a_srs EPSG:XXXX "
      "far.tif far_placed.tif");
}

TEST_F(LayerPictureTest, InDegreesNeedsTheCoordinateSystemOfTheTerrain) {
  RasterSpec spec;
  spec.crs = "EPSG:4326";
  spec.geotransform = {13, 0.001, 0, 47, 0, -0.001};
  make("degrees.tif", spec);
  EXPECT_EQ(
      refusal("degrees.tif", unknown()),
      "degrees.tif: is in degrees (its coordinate system is EPSG:4326, and that of the terrain is not known). Set "
      "terrain.crs, or project the file: gdalwarp -t_srs EPSG:XXXX degrees.tif degrees_metres.tif");
}

TEST_F(LayerPictureTest, HostileFilesAreRefused) {
  make("real.tif");
  write("outside.vrt", Vrt{}.band(vrt_source("/etc/passwd", false)).text());
  EXPECT_THAT(refusal("outside.vrt"),
              HasSubstr("refers to \"/etc/passwd\" (a VRT may refer only to rasters in its own folder or below it)"));
  write("address.vrt", Vrt{}.band(vrt_source("/vsicurl/http://127.0.0.1/a.tif", false)).text());
  EXPECT_THAT(refusal("address.vrt"), HasSubstr("a VRT may refer only to rasters in its own folder or below it"));
  write("wms.xml", "<GDAL_WMS><Service name=\"WMS\"/></GDAL_WMS>");
  EXPECT_THAT(refusal("wms.xml"), HasSubstr("is not a raster that Talus reads (it begins with <GDAL_WMS>)"));
  ASSERT_EQ(::mkfifo(path("pipe.tif").c_str(), 0600), 0);
  EXPECT_EQ(refusal("pipe.tif"), "pipe.tif: cannot be read (it is a pipe). Name a file");
  write("good.vrt", Vrt{}.band(vrt_source("real.tif")).text());
  EXPECT_EQ(picture("good.vrt").columns, 4U);
}

TEST_F(LayerPictureTest, OfAFileThatIsCutShortIsRefused) {
  make("photo.tif", over_terrain(GDT_Byte, [](int column, int row) { return column + row; }));
  std::filesystem::resize_file(path("photo.tif"), std::filesystem::file_size(path("photo.tif")) - 600);
  EXPECT_NE(refusal("photo.tif"), "was read");
}

}  // namespace
}  // namespace talus

#endif
