// Hostile or contradictory rasters: pipes and devices, impossible places, conflicting units.

#ifdef TALUS_HAS_GDAL

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "support/raster_reading.hpp"

namespace talus {
namespace {

using namespace testing_tools;

class RefusedRaster : public RasterReading {};

TEST_F(RefusedRaster, APipe) {
  ASSERT_EQ(::mkfifo(path("pipe.tif").c_str(), 0600), 0);
  EXPECT_EQ(refusal("pipe.tif"), "pipe.tif: cannot be read (it is a pipe). Name a file");
  EXPECT_EQ(refusal_as_classes("pipe.tif"), "pipe.tif: cannot be read (it is a pipe). Name a file");
}

TEST_F(RefusedRaster, ADevice) {
  EXPECT_EQ(refusal("/dev/zero"), "/dev/zero: cannot be read (it is a device). Name a file");
}

TEST_F(RefusedRaster, HeightsInTwoUnits) {
  RasterSpec spec;
  spec.crs = "EPSG:32610+6360";
  spec.geotransform = {500000, 10, 0, 4000030, 0, -10};
  spec.unit = "m";
  EXPECT_EQ(refusal(spec),
            "dem.tif: has heights in m and in US survey foot (the first is the unit of its band, the second that of "
            "WGS 84 / UTM zone 10N + NAVD88 height (ftUS)). Correct the wrong one: gdal_translate -a_srs EPSG:XXXX "
            "dem.tif dem_placed.tif, or "
            "gdal_edit.py -units");
}

TEST_F(RefusedRaster, Depths) {
  RasterSpec spec;
  spec.crs = "EPSG:31287+5715";
  EXPECT_EQ(refusal(spec),
            "dem.tif: has depths (MGI / Austria Lambert + MSL depth measures them downwards; Talus needs heights). "
            "Negate them: gdal_translate -ot Float32 -scale 0 1 0 -1 -a_srs EPSG:XXXX dem.tif dem_heights.tif");
}

TEST_F(RefusedRaster, AScaleOfZero) {
  RasterSpec spec;
  spec.scale = 0;
  spec.offset = 100;
  EXPECT_EQ(
      refusal(spec),
      "dem.tif: has the scale 0 and the offset 100 for its heights (all cells would have the same height, or none). "
      "Remove them: gdal_translate -a_scale 1 -a_offset 0 dem.tif dem_heights.tif");
}

TEST_F(RefusedRaster, DegreesWithoutACoordinateSystem) {
  write("dem.asc", ascii_header(3, 2, 13.1, 47.2, 0.0001) + "1 2 3\n4 5 6\n");
  EXPECT_EQ(refusal("dem.asc"),
            "dem.asc: seems to be in degrees (its cells are 0.0001 x 0.0001, and it has no coordinate system). Assign "
            "the right one: gdal_translate -a_srs EPSG:4326 dem.asc dem_placed.tif, and project the result");
}

TEST_F(RefusedRaster, NotLocalMetresThatLookLikeDegrees) {
  write("dem.asc", ascii_header(3, 2, 13, 47, 0.5) + "1 2 3\n4 5 6\n");
  EXPECT_EQ(refusal("dem.asc"), "was read");
}

TEST_F(RefusedRaster, DegreesInACoordinateSystemInMetres) {
  RasterSpec spec;
  spec.geotransform = {13.1, 1e-4, 0, 47.3, 0, -1e-4};
  EXPECT_EQ(
      refusal(spec),
      "dem.tif: seems to be in degrees (its cells are 0.0001 x 0.0001, and it has the coordinate system EPSG:31287). "
      "Assign the right one: gdal_translate -a_srs EPSG:4326 dem.tif dem_placed.tif, and project the result");
}

TEST_F(RefusedRaster, ExchangedXAndY) {
  RasterSpec spec;
  spec.crs = "EPSG:32633";
  spec.geotransform = {5200000, 10, 0, 500030, 0, -10};
  EXPECT_EQ(refusal(spec),
            "dem.tif: is far outside the area of its coordinate system (its centre (5200020, 500015) is 36 degrees "
            "outside the area of EPSG:32633). Assign the right one, or put its coordinates in the order x, y: "
            "gdal_translate -a_srs EPSG:XXXX dem.tif "
            "dem_placed.tif");
}

TEST_F(RefusedRaster, NotTheNextZoneButAWarningForTheOneAfter) {
  RasterSpec spec;
  spec.crs = "EPSG:32633";  // 12 to 18 degrees east; at 47 degrees north one degree is 76 km
  spec.geotransform = {800000, 10, 0, 5200030, 0, -10};
  EXPECT_EQ(refusal(spec), "was read");
  EXPECT_EQ(warnings(), "");
  spec.geotransform = {1000000, 10, 0, 5200030, 0, -10};
  EXPECT_EQ(refusal(spec), "was read");
  EXPECT_EQ(warnings(),
            "dem.tif: warning: is outside the area of its coordinate system (its centre (1000020, 5200015) is 4 "
            "degrees outside the area of EPSG:32633). Assign the right one, or put its coordinates in the order x, y: "
            "gdal_translate -a_srs EPSG:XXXX "
            "dem.tif dem_placed.tif");
}

TEST_F(RefusedRaster, APlaceOffTheEarth) {
  RasterSpec spec;
  spec.crs = "EPSG:3035";
  spec.geotransform = {400000000, 10, 0, 300030, 0, -10};
  EXPECT_EQ(refusal(spec),
            "dem.tif: is nowhere on the earth (its centre (400000020, 300015) has no position in EPSG:3035). Assign "
            "the right one, or put its coordinates in the order x, y: gdal_translate -a_srs EPSG:XXXX dem.tif "
            "dem_placed.tif");
}

TEST_F(RefusedRaster, CoordinatesTooFarFromTheOrigin) {
  RasterSpec spec;
  spec.crs = "";
  spec.geotransform = {1e12, 10, 0, 300030, 0, -10};
  EXPECT_EQ(refusal(spec),
            "dem.tif: is too far from the origin (x = 1e+12 to 1e+12, y = 300000 to 300030; coordinates must be "
            "smaller than 1e+09 m). "
            "Assign its extent: gdal_translate -a_ullr WEST NORTH EAST SOUTH dem.tif dem_placed.tif");
}

TEST_F(RefusedRaster, APictureAsClasses) {
  RasterSpec spec;
  spec.type = GDT_Byte;
  spec.colour = GCI_RedBand;
  make("photo.tif", spec);
  EXPECT_EQ(refusal_as_classes("photo.tif"),
            "photo.tif: is a picture (band 1 is the colour component \"Red\"; Talus needs classes there). If it does "
            "contain them: gdal_translate -b 1 -colorinterp_1 gray photo.tif photo_classes.tif");
}

}  // namespace
}  // namespace talus

#endif
