// The cells of rasters: no data, scales, types, and values that are not elevations.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#ifdef TALUS_HAS_GDAL

#include <algorithm>
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

/// 40 x 20 cells of 2 m on a slope from 1100 m down, with a patch of another value.
RasterSpec slope_with_patch(double value, GDALDataType type = GDT_Float32, double lowest = 1021) {
  RasterSpec spec;
  spec.columns = 40;
  spec.rows = 20;
  spec.type = type;
  spec.geotransform = {400000, 2, 0, 300040, 0, -2};
  spec.cells.clear();
  for (int row = 0; row < spec.rows; ++row) {
    for (int column = 0; column < spec.columns; ++column) {
      const bool is_patch = row >= 5 && row < 10 && column >= 30 && column < 35;
      spec.cells.push_back(is_patch ? value : lowest + 2.0 * (39 - column) + 0.25 * row);
    }
  }
  return spec;
}

TEST_F(RasterBand, WarnsOfUndeclaredNoData) {
  const auto warning = [](const std::string& value, const std::string& raw, const std::string& cells = "25") {
    return "dem.tif: warning: has " + cells + " cells of " + value +
           " m (walls surround them; they are probably no-data values that the file does not declare). Declare them: "
           "gdal_translate -a_nodata " +
           raw + " dem.tif dem_declared.tif";
  };
  for (const char* value : {"-999", "-1", "0", "-99", "9999", "32767", "99999", "-8888", "255"}) {
    static_cast<void>(read(slope_with_patch(std::stod(value))));
    EXPECT_EQ(warnings(), warning(value, value));
  }
  static_cast<void>(read(slope_with_patch(65535, GDT_UInt16)));
  EXPECT_EQ(warnings(), warning("65535", "65535"));
  // Among the heights: the patch is a hole or a block all the same.
  static_cast<void>(read(slope_with_patch(999, GDT_Float32, 960)));
  EXPECT_EQ(warnings(), warning("999", "999", "27")) << "two of the slope are as high";
  // Any value far from all others.
  static_cast<void>(read(slope_with_patch(-1234)));
  EXPECT_EQ(warnings(), warning("-1234", "-1234"));
  static_cast<void>(read(slope_with_patch(31234.5)));
  EXPECT_EQ(warnings(), warning("31234.5", "31234.5"));
}

TEST_F(RasterBand, NamesUndeclaredNoDataByTheRawValue) {
  RasterSpec spec = slope_with_patch(65535, GDT_UInt16);
  for (double& cell : spec.cells) cell = cell == 65535 ? cell : 10 * cell;
  spec.scale = 0.1;
  spec.offset = 0;
  static_cast<void>(read(spec));
  EXPECT_THAT(warnings(), HasSubstr("has 25 cells of 6553.5 m"));
  EXPECT_THAT(warnings(), HasSubstr("-a_nodata 65535"));
}

TEST_F(RasterBand, OneCellIsEnough) {
  RasterSpec spec = slope_with_patch(1050);
  spec.cells[45] = -999;
  static_cast<void>(read(spec));
  EXPECT_THAT(warnings(),
              HasSubstr("has 1 cell of -999 m (walls surround it; it is probably a no-data value that the file "
                        "does not declare)"));
}

TEST_F(RasterBand, GroundIsNoFiller) {
  const RasterSpec slope = slope_with_patch(1050);
  // A slope around 999 m, in whole metres and in decimals; a flat lake at 999 m; the flat floor of a quarry.
  for (const GDALDataType type : {GDT_Int16, GDT_Float32}) {
    RasterSpec spec = slope;
    spec.type = type;
    for (double& cell : spec.cells) cell -= 50;
    static_cast<void>(read(spec));
    EXPECT_EQ(warnings(), "");
    for (double& cell : spec.cells) cell = std::max(cell, 999.0);
    static_cast<void>(read(spec));
    EXPECT_EQ(warnings(), "");
  }
  RasterSpec quarry = slope;
  for (double& cell : quarry.cells) cell = cell < 1060 ? 1000 : cell;  // walls of 60 m
  static_cast<void>(read(quarry));
  EXPECT_EQ(warnings(), "");
  RasterSpec forest = slope;  // whole metres with trees: walls everywhere
  for (std::size_t k = 0; k < forest.cells.size(); ++k) forest.cells[k] = 990 + static_cast<double>((k * 7919) % 31);
  static_cast<void>(read(forest));
  EXPECT_EQ(warnings(), "");
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
