#include "talus/import/raster_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#ifdef TALUS_HAS_GDAL

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "support/rasters.hpp"

namespace talus {
namespace {

using namespace testing_tools;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

class RasterFileTest : public RasterFolder {
 protected:
  RasterFile read(const std::string& name, const ProjectCrs& said = {}) {
    warnings_ = Problems{};
    return read_raster_file(path(name), warnings_, said);
  }
  RasterFile read(const RasterSpec& spec) {
    make("dem.tif", spec);
    return read("dem.tif");
  }
  [[nodiscard]] std::string refusal(const std::string& name) {
    return refusal_of([&] { static_cast<void>(read(name)); });
  }
  [[nodiscard]] std::string refusal(const RasterSpec& spec) {
    make("dem.tif", spec);
    return refusal("dem.tif");
  }
  [[nodiscard]] std::string warnings() const { return without_folder(warnings_.text()); }

  Problems warnings_;
};

const std::vector<float> from_the_south{9, 10, 11, 12, 5, 6, 7, 8, 1, 2, 3, 4};

// ---- what is read ----

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

TEST_F(RasterFileTest, GridsStoredFromTheSouthOrTheEastAreTurned) {
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

TEST_F(RasterFileTest, WhatHasNoDataIsNotANumber) {
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

TEST_F(RasterFileTest, NumbersTooLargeForAFloatAreNoData) {
  RasterSpec spec;
  spec.type = GDT_Float64;
  spec.cells[3] = -std::numeric_limits<double>::max();
  EXPECT_EQ(read(spec).without_data, 1U);
}

TEST_F(RasterFileTest, AMaskHidesCells) {
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

TEST_F(RasterFileTest, ScaleAndOffsetAreAppliedAfterNoData) {
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

TEST_F(RasterFileTest, DoublesAreRoundedToTheNearestFloat) {
  RasterSpec spec;
  spec.type = GDT_Float64;
  spec.cells[8] = 2345.678901234;
  const float z = read(spec).grid.z[0];
  EXPECT_EQ(z, 2345.678901234F);
  EXPECT_NEAR(z, 2345.678901234, 0.000125);
}

TEST_F(RasterFileTest, WholeNumbersOfEveryKindAreRead) {
  for (const GDALDataType type : {GDT_Byte, GDT_UInt16, GDT_Int16, GDT_UInt32, GDT_Int32, GDT_Int64, GDT_UInt64}) {
    RasterSpec spec;
    spec.type = type;
    EXPECT_EQ(read(spec).grid.z, from_the_south) << GDALGetDataTypeName(type);
  }
}

TEST_F(RasterFileTest, AaiGridWithoutACoordinateSystemIsReadWithAWarning) {
  write("dem.asc",
        "ncols 4\nnrows 3\nxllcorner 100\nyllcorner 200\ncellsize 5\nNODATA_value -9999\n1 2 3 4\n5 6 -9999 8\n9 10 11 "
        "12\n");
  const RasterFile file = read("dem.asc");
  EXPECT_EQ(file.grid.x0, 102.5);
  EXPECT_EQ(file.grid.y0, 202.5);
  EXPECT_EQ(file.grid.z[file.grid.index(3, 0)], 12);
  EXPECT_EQ(file.without_data, 1U);
  EXPECT_EQ(file.crs_wkt, "");
  EXPECT_EQ(warnings(),
            "dem.asc: warning: names no coordinate system (its cells are taken to be 5 x 5 m). Name it: crs = "
            "\"EPSG:XXXX\" in [terrain], or \"local\" for metres of no map");
}

TEST_F(RasterFileTest, TakesTheCoordinateSystemThatIsSaidWhereItNamesNone) {
  write("dem.asc", "ncols 2\nnrows 2\nxllcorner 400000\nyllcorner 300000\ncellsize 5\nNODATA_value -9999\n1 2\n3 4\n");
  const RasterFile placed = read("dem.asc", {.crs = *crs_in_words("EPSG:31287"), .is_local = false});
  EXPECT_EQ(placed.crs_name, "EPSG:31287");
  EXPECT_EQ(placed.crs_wkt, read(RasterSpec{}).crs_wkt);
  read("dem.asc", {.crs = *crs_in_words("EPSG:31287"), .is_local = false});
  EXPECT_EQ(warnings(), "");
  EXPECT_EQ(read("dem.asc", {.crs = {}, .is_local = true}).crs_wkt, "");
  EXPECT_EQ(warnings(), "");
}

TEST_F(RasterFileTest, IsHeldToTheCoordinateSystemThatIsSaid) {
  write("dem.asc", "ncols 2\nnrows 2\nxllcorner 4\nyllcorner 45\ncellsize 0.001\nNODATA_value -9999\n1 2\n3 4\n");
  EXPECT_EQ(refusal_of([&] { read("dem.asc", {.crs = *crs_in_words("EPSG:4326"), .is_local = false}); }),
            "dem.asc: is in degrees (EPSG:4326 is a geographic coordinate system; Talus needs metres on plan). Project "
            "it: gdalwarp -t_srs EPSG:32631 -r bilinear dem.asc dem_metres.tif");
  // A model of a metre, in the laboratory.
  EXPECT_EQ(read("dem.asc", {.crs = {}, .is_local = true}).grid.dx, 0.001);
}

TEST_F(RasterFileTest, RefusesAnotherCoordinateSystemThanItsOwn) {
  read(RasterSpec{});
  const std::string hint =
      "Leave out crs, or give the file the true one: gdal_translate -a_srs EPSG:XXXX dem.tif dem_placed.tif";
  EXPECT_EQ(refusal_of([&] { read("dem.tif", {.crs = *crs_in_words("EPSG:32633"), .is_local = false}); }),
            "dem.tif: is in EPSG:31287 (the project says crs = \"EPSG:32633\"). " + hint);
  EXPECT_EQ(refusal_of([&] { read("dem.tif", {.crs = {}, .is_local = true}); }),
            "dem.tif: is in EPSG:31287 (the project says crs = \"local\"). " + hint);
  EXPECT_EQ(read("dem.tif", {.crs = *crs_in_words("EPSG:31287"), .is_local = false}).crs_name, "EPSG:31287");
}

TEST_F(RasterFileTest, AMosaicOfTilesIsTheSameGridAsOneFile) {
  // 9 x 9 tiles of 40 x 30 cells, larger than a block of a VRT.
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
  EXPECT_THAT(refusal("mosaic.vrt"), HasSubstr("names \"tile11.tif\" (there is no such file)"));
}

TEST_F(RasterFileTest, ACompoundSystemInMetresIsRead) {
  RasterSpec spec;
  spec.crs = "EPSG:25832+5783";
  spec.geotransform = {600000, 10, 0, 5300000, 0, -10};
  EXPECT_EQ(read(spec).crs_name, "ETRS89 / UTM zone 32N + DHHN92 height");
  EXPECT_EQ(warnings(), "");
}

TEST_F(RasterFileTest, OfSeveralBandsTheFirstIsReadWithAWarning) {
  const std::string band =
      "<SimpleSource><SourceFilename relativeToVRT=\"1\">dem.tif</SourceFilename><SourceBand>1</SourceBand>"
      "</SimpleSource></VRTRasterBand>";
  make("dem.tif");
  write("two.vrt",
        "<VRTDataset rasterXSize=\"4\" rasterYSize=\"3\"><SRS>EPSG:31287</SRS>"
        "<GeoTransform>400000,10,0,300030,0,-10</GeoTransform><VRTRasterBand dataType=\"Float32\" band=\"1\">" +
            band + "<VRTRasterBand dataType=\"Float32\" band=\"2\">" + band + "</VRTDataset>");
  EXPECT_EQ(read("two.vrt").grid.z, from_the_south);
  EXPECT_EQ(warnings(), "two.vrt: warning: has 2 bands (Talus reads the first)");
}

// ---- refusals ----

TEST_F(RasterFileTest, DegreesAreRefusedWithTheCommandThatProjects) {
  RasterSpec spec;
  spec.crs = "EPSG:4326";
  spec.geotransform = {11.2, 0.001, 0, 47.3, 0, -0.001};
  EXPECT_EQ(refusal(spec),
            "dem.tif: is in degrees (EPSG:4326 is a geographic coordinate system; Talus needs metres on plan). Project "
            "it: gdalwarp -t_srs EPSG:32632 -r bilinear dem.tif dem_metres.tif");
  spec.geotransform = {-70.2, 0.001, 0, -33.3, 0, -0.001};
  EXPECT_THAT(refusal(spec), HasSubstr("gdalwarp -t_srs EPSG:32719 -r bilinear dem.tif dem_metres.tif"));
}

TEST_F(RasterFileTest, FeetOnPlanAreRefused) {
  RasterSpec spec;
  spec.crs = "EPSG:2232";  // Colorado Central, US survey feet
  spec.geotransform = {3000000, 10, 0, 1700000, 0, -10};
  EXPECT_EQ(refusal(spec),
            "dem.tif: is not in metres on plan (the unit of EPSG:2232 is US survey foot, 0.3048006096 m). Project it: "
            "gdalwarp -t_srs EPSG:32613 -r bilinear dem.tif dem_metres.tif");
}

TEST_F(RasterFileTest, MetresThatAreNotThoseOfTheGroundAreRefused) {
  RasterSpec spec;
  spec.crs = "EPSG:3857";
  spec.geotransform = {1250000, 10, 0, 6000000, 0, -10};
  EXPECT_EQ(refusal(spec),
            "dem.tif: is in EPSG:3857, whose metres are not metres on the ground (at its centre a metre along y is "
            "0.677 m). Project it: gdalwarp -t_srs EPSG:32632 -r bilinear dem.tif dem_metres.tif");
}

TEST_F(RasterFileTest, MetresThatAreALittleOffAreWarnedOf) {
  RasterSpec spec;
  spec.crs = "EPSG:32632";
  spec.geotransform = {1700000, 10, 0, 5300000, 0, -10};  // 1200 km beside the zone's meridian
  static_cast<void>(read(spec));
  EXPECT_EQ(warnings(),
            "dem.tif: warning: is in EPSG:32632, whose metres are not metres on the ground (at its centre a metre "
            "along y is 0.983 m). Project it: gdalwarp -t_srs EPSG:32635 -r bilinear dem.tif dem_metres.tif");
}

TEST_F(RasterFileTest, ATurnedGridIsRefused) {
  RasterSpec spec;
  spec.geotransform = {400000, 10, 1, 300000, 1, -10};
  EXPECT_EQ(refusal(spec),
            "dem.tif: is turned or sheared against the map (its geotransform is 400000, 10, 1, 300000, 1, -10; Talus "
            "needs rows from west to east). Turn it: gdalwarp -r bilinear dem.tif dem_north_up.tif");
}

TEST_F(RasterFileTest, AGridOfUnknownPlaceIsRefused) {
  RasterSpec spec;
  spec.geotransform.reset();
  EXPECT_EQ(refusal(spec),
            "dem.tif: does not say where it lies (it has no geotransform: no corner and no size of a cell). Tell it: "
            "gdal_translate -a_ullr WEST NORTH EAST SOUTH dem.tif dem_placed.tif");
  write("gcp.vrt",
        "<VRTDataset rasterXSize=\"4\" rasterYSize=\"3\"><GCPList Projection=\"EPSG:31287\">"
        "<GCP Id=\"1\" Pixel=\"0\" Line=\"0\" X=\"400000\" Y=\"300000\"/>"
        "<GCP Id=\"2\" Pixel=\"4\" Line=\"0\" X=\"400040\" Y=\"300000\"/>"
        "<GCP Id=\"3\" Pixel=\"0\" Line=\"3\" X=\"400000\" Y=\"299970\"/></GCPList>"
        "<VRTRasterBand dataType=\"Float32\" band=\"1\"><SimpleSource><SourceFilename relativeToVRT=\"1\">dem.tif"
        "</SourceFilename><SourceBand>1</SourceBand></SimpleSource></VRTRasterBand></VRTDataset>");
  EXPECT_EQ(refusal("gcp.vrt"),
            "gcp.vrt: has no grid of its own on the map (it is tied to it by 3 control points). Lay it on a grid: "
            "gdalwarp -r bilinear gcp.vrt gcp_grid.tif");
}

TEST_F(RasterFileTest, CoordinateSystemsThatAreNoMapsAreRefused) {
  RasterSpec spec;
  spec.crs = "LOCAL_CS[\"site grid\",UNIT[\"metre\",1]]";
  EXPECT_EQ(refusal(spec),
            "dem.tif: has no coordinate system of a map (site grid is local; Talus needs a projected one, in metres). "
            "Name the true one: gdal_translate -a_srs EPSG:XXXX dem.tif dem_placed.tif");
}

TEST_F(RasterFileTest, HeightsInFeetAreRefused) {
  RasterSpec spec;
  spec.unit = "ft";
  EXPECT_EQ(refusal(spec),
            "dem.tif: has heights in ft (Talus needs metres; one of these units is 0.3048 m). Convert them: "
            "gdal_translate -ot Float32 -scale 0 1 0 0.3048 dem.tif dem_metres_high.tif");
  spec.unit = "US survey foot";
  EXPECT_THAT(refusal(spec), HasSubstr("-scale 0 1 0 0.304800609601219 dem.tif"));
  spec.unit = "dB";
  EXPECT_EQ(refusal(spec),
            "dem.tif: has heights in \"dB\" (Talus needs metres). If they are metres, drop the name: gdal_translate "
            "-ot Float32 -scale 0 1 0 1 dem.tif dem_metres_high.tif");
  for (const char* metres : {"m", "metre", "Meters"}) {
    spec.unit = metres;
    EXPECT_EQ(refusal(spec), "was read") << metres;
  }
}

TEST_F(RasterFileTest, HeightsInFeetOfACoordinateSystemAreRefused) {
  RasterSpec spec;
  spec.crs = "EPSG:32613+6360";  // NAVD88 height (ftUS)
  spec.geotransform = {500000, 10, 0, 4400000, 0, -10};
  EXPECT_EQ(
      refusal(spec),
      "dem.tif: has heights in US survey foot (Talus needs metres; one of these units is 0.3048006096 m). Convert "
      "them: gdal_translate -ot Float32 -scale 0 1 0 0.304800609601219 -a_srs EPSG:32613 dem.tif "
      "dem_metres_high.tif");
}

TEST_F(RasterFileTest, BandsThatHoldNoElevationsAreRefused) {
  RasterSpec spec;
  spec.type = GDT_CFloat32;
  EXPECT_EQ(refusal(spec),
            "dem.tif: has complex numbers in band 1 (an elevation is a real number). Keep their real part: "
            "gdal_translate -ot Float32 dem.tif dem_real.tif");
  spec.type = GDT_Byte;
  write("photo.vrt",
        "<VRTDataset rasterXSize=\"4\" rasterYSize=\"3\"><SRS>EPSG:31287</SRS>"
        "<GeoTransform>400000,10,0,300000,0,-10</GeoTransform><VRTRasterBand dataType=\"Byte\" band=\"1\">"
        "<ColorInterp>Red</ColorInterp></VRTRasterBand></VRTDataset>");
  EXPECT_EQ(refusal("photo.vrt"),
            "photo.vrt: is a picture (band 1 is the colour component \"Red\"; Talus needs elevations there). If it "
            "does hold them: gdal_translate -b 1 -ot Float32 -colorinterp_1 gray photo.vrt photo_heights.tif");
}

TEST_F(RasterFileTest, SizesThatNoTerrainHasAreRefusedBeforeMemoryIsAskedFor) {
  RasterSpec spec;
  spec.columns = 12;
  spec.rows = 1;
  EXPECT_EQ(refusal(spec), "dem.tif: has 12 x 1 cells (a surface needs 2 x 2 or more)");
  write("huge.vrt",
        "<VRTDataset rasterXSize=\"2000000000\" rasterYSize=\"2000000000\"><SRS>EPSG:31287</SRS>"
        "<GeoTransform>400000,0.0001,0,300000,0,-0.0001</GeoTransform><VRTRasterBand dataType=\"Float32\" band=\"1\">"
        "</VRTRasterBand></VRTDataset>");
  EXPECT_EQ(refusal("huge.vrt"),
            "huge.vrt: has 2000000000 x 2000000000 cells (Talus takes fewer than 2147483648). Cut it to the slope: "
            "gdal_translate -projwin WEST NORTH EAST SOUTH huge.vrt huge_slope.tif\n"
            "huge.vrt: seems to be in degrees (its cells are 0.0001 x 0.0001, and it is said to be in EPSG:31287). "
            "Name the true one: gdal_translate -a_srs EPSG:4326 huge.vrt huge_placed.tif, and project that");
}

TEST_F(RasterFileTest, UndeclaredNoDataIsFound) {
  RasterSpec spec;
  spec.cells[0] = spec.cells[5] = -9999;
  EXPECT_EQ(refusal(spec),
            "dem.tif: has elevations such as -9999 m (2 of 12 cells are below -9000 m or above 100000 m; they seem to "
            "have no data, but the file does not say so). Tell it: gdal_translate -a_nodata -9999 dem.tif "
            "dem_declared.tif");
  spec.cells[0] = spec.cells[5] = -3.4028234663852886e+38;
  EXPECT_THAT(refusal(spec), HasSubstr("gdal_translate -a_nodata -3.4028234663852886e+38 dem.tif"));
}

// The sea is ground; a rim of zeros at the foot of walls is none.
TEST_F(RasterFileTest, ZerosThatSeemToBeNoDataAreWarnedOf) {
  RasterSpec spec;
  spec.cells = {0, 0, 0, 0, 0, 710, 720, 0, 0, 715, 730, 0};
  read(spec);
  EXPECT_EQ(warnings(),
            "dem.tif: warning: has 8 cells of 0 m (walls stand around them; they seem to have no data, but the file "
            "does not say so). Tell it: gdal_translate -a_nodata 0 dem.tif dem_declared.tif");
  spec.cells = {0, 0, 0, 0, 0, 10, 20, 0, 0, 15, 130, 0};
  read(spec);
  EXPECT_EQ(warnings(), "");
  spec.cells.assign(12, 0);
  read(spec);
  EXPECT_EQ(warnings(), "");
}

TEST_F(RasterFileTest, ARasterWithoutSurfaceIsRefused) {
  RasterSpec spec;
  spec.cells.assign(12, -1);
  spec.no_data = -1;
  EXPECT_EQ(refusal(spec), "dem.tif: has no surface (no cell has data)");
  spec.cells = {1, -1, 1, -1, 1, -1, 1, -1, 1, -1, 1, -1};
  EXPECT_EQ(refusal(spec),
            "dem.tif: has no surface (nowhere have four neighbouring cells data, which a piece of surface needs)");
}

TEST_F(RasterFileTest, FilesThatAreNoRastersAreRefused) {
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

TEST_F(RasterFileTest, FilesThatAreCutShortAreRefusedAndNothingIsPrinted) {
  RasterSpec spec;
  spec.columns = 200;
  spec.rows = 200;
  spec.cells.assign(40000, 5);
  make("dem.tif", spec);
  std::filesystem::resize_file(path("dem.tif"), 60000);
  write("dem.asc", "ncols 4\nnrows 3\nxllcorner 100\nyllcorner 200\ncellsize 5\n1 2 3 4\n5 6");
  ::testing::internal::CaptureStderr();
  ::testing::internal::CaptureStdout();
  const std::string tif = refusal("dem.tif"), asc = refusal("dem.asc");
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
  EXPECT_THAT(tif, StartsWith("dem.tif: "));
  EXPECT_THAT(tif, HasSubstr("(GDAL: "));
  EXPECT_EQ(asc, "dem.asc:7: has 6 cells (ncols 4 and nrows 3 make 12). Copy it again from where it comes from");
}

TEST_F(RasterFileTest, AllThatIsWrongIsToldAtOnce) {
  RasterSpec spec;
  spec.crs = "EPSG:4326";
  spec.geotransform = {11.2, 0.001, 0.0001, 47.3, 0, -0.001};
  spec.unit = "ft";
  spec.type = GDT_CFloat32;
  const std::string text = refusal(spec);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3) << text;
  for (const char* part : {"is turned", "is in degrees", "has complex numbers", "has heights in ft"}) {
    EXPECT_THAT(text, HasSubstr(part));
  }
}

TEST_F(RasterFileTest, CommandsAreFitForAShell) {
  RasterSpec spec;
  spec.geotransform.reset();
  make("it's here.tif", spec);
  EXPECT_THAT(refusal("it's here.tif"), HasSubstr("it'\\''s here.tif' '"));
  EXPECT_THAT(refusal("it's here.tif"), HasSubstr("it'\\''s here_placed.tif'"));
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
