// The cells of rasters: no data, scales, types, and values that are not elevations.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#ifdef TALUS_HAS_GDAL

#include <cmath>
#include <limits>

#include "support/raster_reading.hpp"

namespace talus {
namespace {

using namespace testing_tools;
using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
class RasterBand : public RasterReading {};

TEST_F(RasterBand, CellsWithoutDataBecomeNan) {
  RasterSpec spec;
  spec.cells = {1, 2, -9999, nan, 5, 6, std::numeric_limits<double>::infinity(), 8, 9, 10, 11, 12};
  spec.no_data = -9999;
  const RasterFile file = read(spec);
  EXPECT_EQ(file.without_data, 3U);
  EXPECT_TRUE(std::isnan(file.grid.z[file.grid.index(2, 2)]));
  EXPECT_TRUE(std::isnan(file.grid.z[file.grid.index(3, 2)]));
  EXPECT_TRUE(std::isnan(file.grid.z[file.grid.index(2, 1)]));
  EXPECT_EQ(file.grid.z[file.grid.index(3, 1)], 8);
}

TEST_F(RasterBand, NumbersTooLargeForAFloatCountAsNoData) {
  RasterSpec spec;
  spec.type = GDT_Float64;
  spec.cells[3] = -std::numeric_limits<double>::max();
  EXPECT_EQ(read(spec).without_data, 1U);
}

TEST_F(RasterBand, AMaskHidesCells) {
  make("dem.tif");
  {
    GDALDatasetUniquePtr file(GDALDataset::Open(path("dem.tif").c_str(), GDAL_OF_UPDATE));
    ASSERT_EQ(file->CreateMaskBand(GMF_PER_DATASET), CE_None);
    std::array<unsigned char, 12> mask{255, 255, 255, 0, 255, 255, 255, 255, 255, 255, 255, 255};
    ASSERT_EQ(file->GetRasterBand(1)->GetMaskBand()->RasterIO(GF_Write, 0, 0, 4, 3, mask.data(), 4, 3, GDT_Byte, 0, 0,
                                                              nullptr),
              CE_None);
  }
  const RasterFile file = read("dem.tif");
  EXPECT_EQ(file.without_data, 1U);
  EXPECT_TRUE(std::isnan(file.grid.z[file.grid.index(3, 2)]));
}

TEST_F(RasterBand, ScaleAndOffsetAreAppliedAfterNoData) {
  RasterSpec spec;
  spec.type = GDT_Int16;
  spec.cells = {1, 2, 3, -1, 5, 6, 7, 8, 9, 10, 11, 12};
  spec.no_data = -1;
  spec.scale = 0.1;
  spec.offset = 1000;
  const RasterFile file = read(spec);
  EXPECT_EQ(file.grid.z[0], static_cast<float>(9 * 0.1 + 1000));
  EXPECT_TRUE(std::isnan(file.grid.z[file.grid.index(3, 2)]));
}

TEST_F(RasterBand, DoublesAreRoundedToTheNearestFloat) {
  RasterSpec spec;
  spec.type = GDT_Float64;
  spec.cells[8] = 2345.678901234;
  const float z = read(spec).grid.z[0];
  EXPECT_EQ(z, 2345.678901234F);
  EXPECT_NEAR(z, 2345.678901234, 0.000125);
}

TEST_F(RasterBand, ReadsIntegersOfEveryType) {
  for (const GDALDataType type : {GDT_Byte, GDT_UInt16, GDT_Int16, GDT_UInt32, GDT_Int32, GDT_Int64, GDT_UInt64}) {
    RasterSpec spec;
    spec.type = type;
    EXPECT_EQ(read(spec).grid.z, from_the_south) << GDALGetDataTypeName(type);
  }
}

TEST_F(RasterBand, RefusesUndeclaredNoData) {
  RasterSpec spec;
  spec.cells[0] = spec.cells[5] = -9999;
  EXPECT_EQ(
      refusal(spec),
      "dem.tif: has elevations such as -9999 m (2 of 12 cells are below -9000 m or above 100000 m; they are probably "
      "no-data values that the file does not declare). Declare them: gdal_translate -a_nodata -9999 dem.tif "
      "dem_declared.tif");
  spec.cells[0] = spec.cells[5] = -3.4028234663852886e+38;
  EXPECT_THAT(refusal(spec), HasSubstr("gdal_translate -a_nodata -3.4028234663852886e+38 dem.tif"));
}

// The sea counts as ground, a rim of zeros at the foot of walls does not.
TEST_F(RasterBand, WarnsOfZerosThatSeemToBeNoData) {
  RasterSpec spec;
  spec.cells = {0, 0, 0, 0, 0, 710, 720, 0, 0, 715, 730, 0};
  read(spec);
  EXPECT_EQ(warnings(),
            "dem.tif: warning: has 8 cells of 0 m (walls surround them; they are probably no-data values that the file "
            "does not declare). Declare them: gdal_translate -a_nodata 0 dem.tif dem_declared.tif");
  spec.cells = {0, 0, 0, 0, 0, 10, 20, 0, 0, 15, 130, 0};
  read(spec);
  EXPECT_EQ(warnings(), "");
  spec.cells.assign(12, 0);
  read(spec);
  EXPECT_EQ(warnings(), "");
}

TEST_F(RasterBand, RefusesARasterWithoutSurface) {
  RasterSpec spec;
  spec.cells.assign(12, -1);
  spec.no_data = -1;
  EXPECT_EQ(refusal(spec), "dem.tif: has no surface (no cell has data)");
  spec.cells = {1, -1, 1, -1, 1, -1, 1, -1, 1, -1, 1, -1};
  EXPECT_EQ(refusal(spec),
            "dem.tif: has no surface (a surface needs four neighbouring cells with data, and there are none)");
}

TEST_F(RasterBand, RefusesFilesThatAreCutShortAndPrintsNothing) {
  RasterSpec spec;
  spec.columns = 200;
  spec.rows = 200;
  spec.cells.assign(40000, 5);
  make("dem.tif", spec);
  std::filesystem::resize_file(path("dem.tif"), 60000);
  write("dem.asc", ascii_header(4, 3, 100, 200, 5) + "1 2 3 4\n5 6");
  ::testing::internal::CaptureStderr();
  ::testing::internal::CaptureStdout();
  const std::string tif = refusal("dem.tif"), asc = refusal("dem.asc");
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
  EXPECT_THAT(tif, StartsWith("dem.tif: "));
  EXPECT_THAT(tif, HasSubstr("(GDAL: "));
  EXPECT_EQ(asc, "dem.asc:7: has 6 cells (ncols 4 and nrows 3 make 12). Copy it again from its source");
}

}  // namespace
}  // namespace talus

#endif
