#include "talus/import/raster_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#ifdef TALUS_HAS_GDAL

#include <fmt/format.h>

#include "support/raster_reading.hpp"

namespace talus {
namespace {

using namespace testing_tools;
using ::testing::HasSubstr;
using ::testing::StartsWith;

class RasterFileTest : public RasterReading {};

TEST_F(RasterFileTest, NodesAreTheCentresOfCellsFromTheSouthWest) {
  const RasterFile file = read(RasterSpec{});
  EXPECT_EQ(file.grid.columns, 4U);
  EXPECT_EQ(file.grid.rows, 3U);
  EXPECT_EQ(file.grid.x0, 400005);
  EXPECT_EQ(file.grid.y0, 300005);
  EXPECT_EQ(file.grid.dx, 10);
  EXPECT_EQ(file.grid.dy, 10);
  EXPECT_EQ(file.grid.z, from_the_south);
  EXPECT_EQ(file.crs_name, "EPSG:31287");
  EXPECT_THAT(file.crs_wkt, StartsWith("PROJCRS[\"MGI / Austria Lambert\""));
  EXPECT_EQ(file.without_data, 0U);
  EXPECT_EQ(warnings(), "");
}

TEST_F(RasterFileTest, GridsStoredFromTheSouthOrTheEastAreFlipped) {
  RasterSpec south;
  south.geotransform = {400000, 10, 0, 300000, 0, 10};
  south.cells = {9, 10, 11, 12, 5, 6, 7, 8, 1, 2, 3, 4};
  RasterSpec east;
  east.geotransform = {400040, -10, 0, 300030, 0, -10};
  east.cells = {4, 3, 2, 1, 8, 7, 6, 5, 12, 11, 10, 9};
  RasterSpec both;
  both.geotransform = {400040, -10, 0, 300000, 0, 10};
  both.cells = {12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1};
  for (const RasterSpec& spec : {south, east, both}) {
    const RasterFile file = read(spec);
    EXPECT_EQ(file.grid.z, from_the_south);
    EXPECT_EQ(file.grid.x0, 400005);
    EXPECT_EQ(file.grid.y0, 300005);
  }
}

TEST_F(RasterFileTest, CellsNeedNotBeSquare) {
  RasterSpec spec;
  spec.geotransform = {400000, 2.5, 0, 300000, 0, -0.5};
  const RasterFile file = read(spec);
  EXPECT_EQ(file.grid.dx, 2.5);
  EXPECT_EQ(file.grid.dy, 0.5);
  EXPECT_EQ(file.grid.x0, 400001.25);
  EXPECT_EQ(file.grid.y0, 299998.75);
}

TEST_F(RasterFileTest, AnAsciiGridWithoutACoordinateSystemIsReadWithAWarning) {
  write("dem.asc", ascii_header(4, 3, 100, 200, 5) + "NODATA_value -9999\n1 2 3 4\n5 6 -9999 8\n9 10 11 12\n");
  const RasterFile file = read("dem.asc");
  EXPECT_EQ(file.grid.x0, 102.5);
  EXPECT_EQ(file.grid.y0, 202.5);
  EXPECT_EQ(file.grid.z[file.grid.index(3, 0)], 12);
  EXPECT_EQ(file.without_data, 1U);
  EXPECT_EQ(file.crs_wkt, "");
  EXPECT_EQ(warnings(),
            "dem.asc: warning: has no coordinate system (its cells are assumed to be 5 x 5 m). Set crs = \"EPSG:XXXX\" "
            "in [terrain], or \"local\" for metres that belong to no map");
}

TEST_F(RasterFileTest, AFileWithoutACoordinateSystemTakesThatOfTheProject) {
  write("dem.asc", ascii_header(2, 2, 400000, 300000, 5) + "NODATA_value -9999\n1 2\n3 4\n");
  const RasterFile placed = read("dem.asc", project_crs("EPSG:31287"));
  EXPECT_EQ(placed.crs_name, "EPSG:31287");
  EXPECT_EQ(placed.crs_wkt, read(RasterSpec{}).crs_wkt);
  read("dem.asc", project_crs("EPSG:31287"));
  EXPECT_EQ(warnings(), "");
  EXPECT_EQ(read("dem.asc", local_crs()).crs_wkt, "");
  EXPECT_EQ(warnings(), "");
}

TEST_F(RasterFileTest, IsCheckedAgainstTheCoordinateSystemOfTheProject) {
  write("dem.asc", ascii_header(2, 2, 4, 45, 0.001) + "NODATA_value -9999\n1 2\n3 4\n");
  EXPECT_EQ(refusal("dem.asc", project_crs("EPSG:4326")),
            "dem.asc: is in degrees (EPSG:4326 is a geographic coordinate system; Talus needs metres on plan). Project "
            "it: gdalwarp -t_srs EPSG:32631 -r bilinear dem.asc dem_metres.tif");
  // A laboratory model of a slope, in metres.
  EXPECT_EQ(read("dem.asc", local_crs()).grid.dx, 0.001);
}

TEST_F(RasterFileTest, RefusesAFileWithAnotherCoordinateSystemThanTheProject) {
  read(RasterSpec{});
  const std::string hint =
      "Remove crs, or assign the right one to the file: gdal_translate -a_srs EPSG:XXXX dem.tif dem_placed.tif";
  EXPECT_EQ(refusal("dem.tif", project_crs("EPSG:32633")),
            "dem.tif: is in EPSG:31287 (the project sets crs = \"EPSG:32633\"). " + hint);
  EXPECT_EQ(refusal("dem.tif", local_crs()), "dem.tif: is in EPSG:31287 (the project sets crs = \"local\"). " + hint);
  EXPECT_EQ(read("dem.tif", project_crs("EPSG:31287")).crs_name, "EPSG:31287");
}

TEST_F(RasterFileTest, AMosaicOfTilesIsTheSameGridAsOneFile) {
  // 3 x 3 tiles, larger together than a block of a VRT.
  constexpr int columns = 360, rows = 270, tile_columns = 120, tile_rows = 90;
  const auto height = [](int column, int row) { return 1000 + 0.25 * column - 0.5 * row + (column * row) % 7; };
  RasterSpec whole;
  whole.columns = columns;
  whole.rows = rows;
  whole.geotransform = {400000, 2, 0, 300000, 0, -2};
  whole.cells.clear();
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) whole.cells.push_back(height(column, row));
  }
  make("whole.tif", whole);
  std::string sources;
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i < 3; ++i) {
      RasterSpec tile;
      tile.columns = tile_columns;
      tile.rows = tile_rows;
      const int first_column = i * tile_columns, first_row = j * tile_rows;
      tile.geotransform = {400000 + 2.0 * first_column, 2, 0, 300000 - 2.0 * first_row, 0, -2};
      tile.cells.clear();
      for (int row = 0; row < tile_rows; ++row) {
        for (int column = 0; column < tile_columns; ++column) {
          tile.cells.push_back(height(first_column + column, first_row + row));
        }
      }
      const std::string name = fmt::format("tile{}{}.tif", i, j);
      make(name, tile);
      sources += fmt::format(
          "<SimpleSource><SourceFilename relativeToVRT=\"1\">{}</SourceFilename><SourceBand>1</SourceBand>"
          "<SrcRect xOff=\"0\" yOff=\"0\" xSize=\"{}\" ySize=\"{}\"/>"
          "<DstRect xOff=\"{}\" yOff=\"{}\" xSize=\"{}\" ySize=\"{}\"/></SimpleSource>",
          name, tile_columns, tile_rows, first_column, first_row, tile_columns, tile_rows);
    }
  }
  write("mosaic.vrt", fmt::format("<VRTDataset rasterXSize=\"{}\" rasterYSize=\"{}\"><SRS>EPSG:31287</SRS>"
                                  "<GeoTransform>400000,2,0,300000,0,-2</GeoTransform>"
                                  "<VRTRasterBand dataType=\"Float32\" band=\"1\">{}</VRTRasterBand></VRTDataset>",
                                  columns, rows, sources));
  const RasterFile one = read("whole.tif"), many = read("mosaic.vrt");
  EXPECT_EQ(one.grid.z, many.grid.z);
  EXPECT_EQ(one.grid.x0, many.grid.x0);
  EXPECT_EQ(one.grid.y0, many.grid.y0);
  EXPECT_EQ(one.crs_wkt, many.crs_wkt);
  EXPECT_EQ(one.grid.z[one.grid.index(7, 0)], static_cast<float>(height(7, rows - 1)));
  std::filesystem::remove(path("tile11.tif"));
  EXPECT_THAT(refusal("mosaic.vrt"), HasSubstr("refers to \"tile11.tif\" (there is no such file)"));
}

TEST_F(RasterFileTest, ReadsACompoundCoordinateSystemInMetres) {
  RasterSpec spec;
  spec.crs = "EPSG:25832+5783";
  spec.geotransform = {600000, 10, 0, 5300000, 0, -10};
  EXPECT_EQ(read(spec).crs_name, "ETRS89 / UTM zone 32N + DHHN92 height");
  EXPECT_EQ(warnings(), "");
}

TEST_F(RasterFileTest, ReadsTheFirstOfSeveralBandsWithAWarning) {
  make("dem.tif");
  write("two.vrt", Vrt{}.band(vrt_source("dem.tif")).band(vrt_source("dem.tif")).text());
  EXPECT_EQ(read("two.vrt").grid.z, from_the_south);
  EXPECT_EQ(warnings(), "two.vrt: warning: has 2 bands (Talus reads the first)");
}

TEST_F(RasterFileTest, RefusesFilesThatAreNotRasters) {
  EXPECT_EQ(refusal("none.tif"),
            "none.tif: cannot be read (there is no such file). Paths are relative to the project file");
  write("text.tif", "this is not a raster");
  EXPECT_EQ(
      refusal("text.tif"),
      "text.tif: is not a raster that Talus reads (GDAL: `text.tif' not recognized as a supported file format). Talus "
      "reads GeoTIFF, Esri ASCII grid (.asc), Esri float grid (.flt, .bil), Erdas Imagine (.img) and VRT");
  write("empty.tif", "");
  EXPECT_THAT(refusal("empty.tif"), StartsWith("empty.tif: is not a raster that Talus reads (GDAL"));
}

}  // namespace
}  // namespace talus

#else

namespace talus {
namespace {

TEST(RasterFile, IsRefusedWithoutGdal) {
  EXPECT_FALSE(can_read_rasters());
  Problems warnings;
  try {
    static_cast<void>(read_raster_file("dem.tif", warnings));
    FAIL() << "was read";
  } catch (const BadInput& error) {
    EXPECT_STREQ(
        error.what(),
        "dem.tif: cannot be read (this build of Talus has no GDAL). Build it with GDAL: cmake --preset release "
        "-DTALUS_GDAL=ON");
  }
}

}  // namespace
}  // namespace talus

#endif
