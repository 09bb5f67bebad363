// Rasters that are refused before their cells are read.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#ifdef TALUS_HAS_GDAL

#include <algorithm>

#include "support/raster_reading.hpp"

namespace talus {
namespace {

using namespace testing_tools;
using ::testing::HasSubstr;

class RasterChecks : public RasterReading {};

TEST_F(RasterChecks, RefusesDegreesWithTheCommandThatProjectsThem) {
  RasterSpec spec;
  spec.crs = "EPSG:4326";
  spec.geotransform = {11.2, 0.001, 0, 47.3, 0, -0.001};
  EXPECT_EQ(refusal(spec),
            "dem.tif: is in degrees (EPSG:4326 is a geographic coordinate system; Talus needs metres on plan). Project "
            "it: gdalwarp -t_srs EPSG:32632 -r bilinear dem.tif dem_metres.tif");
  spec.geotransform = {-70.2, 0.001, 0, -33.3, 0, -0.001};
  EXPECT_THAT(refusal(spec), HasSubstr("gdalwarp -t_srs EPSG:32719 -r bilinear dem.tif dem_metres.tif"));
}

TEST_F(RasterChecks, RefusesFeetOnPlan) {
  RasterSpec spec;
  spec.crs = "EPSG:2232";  // Colorado Central, US survey feet
  spec.geotransform = {3000000, 10, 0, 1700000, 0, -10};
  EXPECT_EQ(refusal(spec),
            "dem.tif: is not in metres on plan (the unit of EPSG:2232 is US survey foot, 0.3048006096 m). Project it: "
            "gdalwarp -t_srs EPSG:32613 -r bilinear dem.tif dem_metres.tif");
}

TEST_F(RasterChecks, RefusesMetresThatAreNotMetresOnTheGround) {
  RasterSpec spec;
  spec.crs = "EPSG:3857";
  spec.geotransform = {1250000, 10, 0, 6000000, 0, -10};
  EXPECT_EQ(refusal(spec),
            "dem.tif: is in EPSG:3857, whose metres are not metres on the ground (at its centre a metre along y is "
            "0.677 m). Project it: gdalwarp -t_srs EPSG:32632 -r bilinear dem.tif dem_metres.tif");
}

TEST_F(RasterChecks, WarnsOfMetresThatAreSlightlyOff) {
  RasterSpec spec;
  spec.crs = "EPSG:32632";
  spec.geotransform = {1700000, 10, 0, 5300000, 0, -10};  // 1200 km from the zone's meridian
  static_cast<void>(read(spec));
  EXPECT_EQ(warnings(),
            "dem.tif: warning: is in EPSG:32632, whose metres are not metres on the ground (at its centre a metre "
            "along y is 0.983 m). Project it: gdalwarp -t_srs EPSG:32635 -r bilinear dem.tif dem_metres.tif");
}

TEST_F(RasterChecks, KnowsPlacesInGradsAndFromOtherMeridiansThanGreenwich) {
  RasterSpec spec;
  spec.crs = "EPSG:27572";  // NTF (Paris) / Lambert zone II
  spec.geotransform = {600000, 10, 0, 2428000, 0, -10};
  static_cast<void>(read(spec));
  spec.crs = "EPSG:31282";  // MGI (Ferro) / Austria Central Zone
  spec.geotransform = {0, 10, 0, 5300000, 0, -10};
  static_cast<void>(read(spec));
  EXPECT_EQ(warnings(), "");
}

TEST_F(RasterChecks, RefusesARotatedGrid) {
  RasterSpec spec;
  spec.geotransform = {400000, 10, 1, 300000, 1, -10};
  EXPECT_EQ(refusal(spec),
            "dem.tif: is rotated or sheared (its geotransform is 400000, 10, 1, 300000, 1, -10; Talus needs rows that "
            "run from west to east). Make it north-up: gdalwarp -r bilinear dem.tif dem_north_up.tif");
}

TEST_F(RasterChecks, RefusesAGridThatIsNotGeoreferenced) {
  RasterSpec spec;
  spec.geotransform.reset();
  EXPECT_EQ(refusal(spec),
            "dem.tif: is not georeferenced (it has no geotransform: neither a corner nor a cell size). Assign its "
            "extent: gdal_translate -a_ullr WEST NORTH EAST SOUTH dem.tif dem_placed.tif");
  Vrt points;
  points.place =
      "<GCPList Projection=\"EPSG:31287\">"
      "<GCP Id=\"1\" Pixel=\"0\" Line=\"0\" X=\"400000\" Y=\"300000\"/>"
      "<GCP Id=\"2\" Pixel=\"4\" Line=\"0\" X=\"400040\" Y=\"300000\"/>"
      "<GCP Id=\"3\" Pixel=\"0\" Line=\"3\" X=\"400000\" Y=\"299970\"/></GCPList>";
  write("gcp.vrt", points.band(vrt_source("dem.tif")).text());
  EXPECT_EQ(refusal("gcp.vrt"),
            "gcp.vrt: has no regular grid on the map (it is georeferenced by 3 control points). Resample it: "
            "gdalwarp -r bilinear gcp.vrt gcp_grid.tif");
}

TEST_F(RasterChecks, RefusesCoordinateSystemsThatAreNotProjected) {
  RasterSpec spec;
  spec.crs = "EPSG:4978";
  EXPECT_EQ(
      refusal(spec),
      "dem.tif: has no projected coordinate system (WGS 84 is geocentric; Talus needs a projected one in metres). "
      "Assign the right one: gdal_translate -a_srs EPSG:XXXX dem.tif dem_placed.tif");
}

TEST_F(RasterChecks, LocalCoordinateSystemsInMetresAreLocal) {
  RasterSpec spec;
  for (const char* crs : {"LOCAL_CS[\"site grid\",UNIT[\"metre\",1],AXIS[\"E\",EAST],AXIS[\"N\",NORTH]]",
                          "ENGCRS[\"site grid\",EDATUM[\"site\"],CS[Cartesian,2],AXIS[\"x\",east],AXIS[\"y\",north],"
                          "LENGTHUNIT[\"metre\",1]]"}) {
    spec.crs = crs;
    spec.geotransform = {0, 0.005, 0, 0.015, 0, -0.005};  // as small as degrees
    make("dem.tif", spec);
    for (const ProjectCrs& project : {ProjectCrs{}, local_crs()}) {
      const RasterFile file = read("dem.tif", project);
      EXPECT_EQ(file.crs_wkt, "");
      EXPECT_EQ(file.crs_name, "local coordinates");
      EXPECT_EQ(warnings(), "");
    }
    EXPECT_THAT(refusal("dem.tif", project_crs("EPSG:31287")), HasSubstr("(the project sets crs = \"EPSG:31287\")"));
  }
  spec.crs = "LOCAL_CS[\"site grid\",UNIT[\"foot\",0.3048],AXIS[\"E\",EAST],AXIS[\"N\",NORTH]]";
  EXPECT_EQ(
      refusal(spec),
      "dem.tif: is not in metres on plan (the unit of site grid is foot, 0.3048 m). Multiply its coordinates by that "
      "number, and assign the result no coordinate system");
}

TEST_F(RasterChecks, TheProjectionOfCompoundSystemsKeepsHeights) {
  RasterSpec spec;
  spec.crs = "EPSG:4326+5773";
  spec.geotransform = {11, 0.001, 0, 47, 0, -0.001};
  EXPECT_EQ(
      refusal(spec),
      "dem.tif: is in degrees (WGS 84 + EGM96 height is a geographic coordinate system; Talus needs metres on plan). "
      "Project it: gdalwarp -s_srs EPSG:4326 -t_srs EPSG:32632 -r bilinear dem.tif dem_metres.tif");
}

TEST_F(RasterChecks, RefusesHeightsInFeet) {
  RasterSpec spec;
  spec.unit = "ft";
  EXPECT_EQ(refusal(spec),
            "dem.tif: has heights in ft (Talus needs metres; the unit is 0.3048 m). Convert them: "
            "gdal_translate -ot Float32 -scale 0 1 0 0.3048 dem.tif dem_metres_high.tif");
  spec.unit = "US survey foot";
  EXPECT_THAT(refusal(spec), HasSubstr("-scale 0 1 0 0.304800609601219 dem.tif"));
  spec.unit = "dB";
  EXPECT_EQ(refusal(spec),
            "dem.tif: has heights in \"dB\" (Talus needs metres). If they are metres, remove the unit: gdal_translate "
            "-ot Float32 -scale 0 1 0 1 dem.tif dem_metres_high.tif");
  for (const char* metres : {"m", "metre", "Meters"}) {
    spec.unit = metres;
    EXPECT_EQ(refusal(spec), "was read") << metres;
  }
}

TEST_F(RasterChecks, RefusesHeightsInFeetByTheCoordinateSystem) {
  RasterSpec spec;
  spec.crs = "EPSG:32613+6360";  // NAVD88 height (ftUS)
  spec.geotransform = {500000, 10, 0, 4400000, 0, -10};
  EXPECT_EQ(refusal(spec),
            "dem.tif: has heights in US survey foot (Talus needs metres; the unit is 0.3048006096 m). Convert "
            "them: gdal_translate -ot Float32 -scale 0 1 0 0.304800609601219 -a_srs EPSG:32613 dem.tif "
            "dem_metres_high.tif");
}

TEST_F(RasterChecks, RefusesBandsThatAreNotElevations) {
  RasterSpec spec;
  spec.type = GDT_CFloat32;
  EXPECT_EQ(refusal(spec),
            "dem.tif: has complex numbers in band 1 (an elevation is a real number). Keep the real part: "
            "gdal_translate -ot Float32 dem.tif dem_real.tif");
  write("photo.vrt", Vrt{}.band("<ColorInterp>Red</ColorInterp>", "Byte").text());
  EXPECT_EQ(refusal("photo.vrt"),
            "photo.vrt: is a picture (band 1 is the colour component \"Red\"; Talus needs elevations there). If it "
            "does contain them: gdal_translate -b 1 -ot Float32 -colorinterp_1 gray photo.vrt photo_heights.tif");
}

TEST_F(RasterChecks, RefusesImpossibleSizesBeforeAllocatingMemory) {
  RasterSpec spec;
  spec.columns = 12;
  spec.rows = 1;
  EXPECT_EQ(refusal(spec), "dem.tif: has 12 x 1 cells (a surface needs 2 x 2 or more)");
  Vrt huge{.columns = 2'000'000'000, .rows = 2'000'000'000};
  huge.place = "<SRS>EPSG:31287</SRS><GeoTransform>400000,0.0001,0,300000,0,-0.0001</GeoTransform>";
  write("huge.vrt", huge.band("").text());
  EXPECT_EQ(
      refusal("huge.vrt"),
      "huge.vrt: has 2000000000 x 2000000000 cells (Talus reads fewer than 2147483648). Cut it to the slope: "
      "gdal_translate -projwin WEST NORTH EAST SOUTH huge.vrt huge_slope.tif\n"
      "huge.vrt: seems to be in degrees (its cells are 0.0001 x 0.0001, and it has the coordinate system EPSG:31287). "
      "Assign the right one: gdal_translate -a_srs EPSG:4326 huge.vrt huge_placed.tif, and project the result");
}

TEST_F(RasterChecks, ReportsAllErrorsAtOnce) {
  RasterSpec spec;
  spec.crs = "EPSG:4326";
  spec.geotransform = {11.2, 0.001, 0.0001, 47.3, 0, -0.001};
  spec.unit = "ft";
  spec.type = GDT_CFloat32;
  const std::string text = refusal(spec);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3) << text;
  for (const char* part : {"is rotated", "is in degrees", "has complex numbers", "has heights in ft"}) {
    EXPECT_THAT(text, HasSubstr(part));
  }
}

TEST_F(RasterChecks, QuotesFileNamesInCommandsForAShell) {
  RasterSpec spec;
  spec.geotransform.reset();
  make("it's here.tif", spec);
  EXPECT_THAT(refusal("it's here.tif"), HasSubstr("it'\\''s here.tif' '"));
  EXPECT_THAT(refusal("it's here.tif"), HasSubstr("it'\\''s here_placed.tif'"));
}

}  // namespace
}  // namespace talus

#endif
