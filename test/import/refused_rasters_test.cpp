// Rasters that cannot be what they seem: pipes, sizes beyond the machine, places and units that contradict each other.

#ifdef TALUS_HAS_GDAL

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fmt/format.h>

#include "support/rasters.hpp"
#include "talus/import/class_raster.hpp"
#include "talus/import/raster_file.hpp"

namespace talus {
namespace {

using namespace testing_tools;

class RefusedRaster : public RasterFolder {
 protected:
  [[nodiscard]] std::string refusal(const std::string& name) {
    warnings_ = Problems{};
    return refusal_of([&] { static_cast<void>(read_raster_file(path(name), warnings_)); });
  }
  [[nodiscard]] std::string refusal(const RasterSpec& spec) {
    make("dem.tif", spec);
    return refusal("dem.tif");
  }
  [[nodiscard]] std::string refusal_as_classes(const std::string& name) {
    return refusal_of([&] { ClassRaster(path(name), "", warnings_); });
  }
  [[nodiscard]] std::string in_folder(const std::string& name) const { return path(name).string(); }
  [[nodiscard]] std::string warnings() const { return without_folder(warnings_.text()); }

  Problems warnings_;
};

TEST_F(RefusedRaster, APipeIsNotWaitedFor) {
  ASSERT_EQ(::mkfifo(path("pipe.tif").c_str(), 0600), 0);
  EXPECT_EQ(refusal("pipe.tif"), "pipe.tif: cannot be read (it is a pipe). Name a file");
  EXPECT_EQ(refusal_as_classes("pipe.tif"), "pipe.tif: cannot be read (it is a pipe). Name a file");
}

TEST_F(RefusedRaster, ADeviceHasNoEnd) {
  EXPECT_EQ(refusal("/dev/zero"), "/dev/zero: cannot be read (it is a device). Name a file");
}

TEST_F(RefusedRaster, HeightsInTwoUnits) {
  RasterSpec spec;
  spec.crs = "EPSG:32610+6360";
  spec.geotransform = {500000, 10, 0, 4000030, 0, -10};
  spec.unit = "m";
  EXPECT_EQ(refusal(spec),
            "dem.tif: has heights in m and in US survey foot (its band says one, WGS 84 / UTM zone 10N + NAVD88 height "
            "(ftUS) the other). Say what they are: gdal_translate -a_srs EPSG:XXXX dem.tif dem_placed.tif, or "
            "gdal_edit.py -units");
}

TEST_F(RefusedRaster, Depths) {
  RasterSpec spec;
  spec.crs = "EPSG:31287+5715";
  EXPECT_EQ(refusal(spec),
            "dem.tif: has depths (MGI / Austria Lambert + MSL depth counts them downwards; Talus needs heights). Turn "
            "them round: gdal_translate -ot Float32 -scale 0 1 0 -1 -a_srs EPSG:XXXX dem.tif dem_heights.tif");
}

TEST_F(RefusedRaster, AScaleOfNothing) {
  RasterSpec spec;
  spec.scale = 0;
  spec.offset = 100;
  EXPECT_EQ(refusal(spec),
            "dem.tif: has the scale 0 and the offset 100 for its heights (all cells would have one height, or none). "
            "Leave them out: gdal_translate -a_scale 1 -a_offset 0 dem.tif dem_heights.tif");
}

TEST_F(RefusedRaster, DegreesWithoutACoordinateSystem) {
  write("dem.asc", "ncols 3\nnrows 2\nxllcorner 13.1\nyllcorner 47.2\ncellsize 0.0001\n1 2 3\n4 5 6\n");
  EXPECT_EQ(refusal("dem.asc"),
            "dem.asc: seems to be in degrees (its cells are 0.0001 x 0.0001, and it names no coordinate system). Name "
            "the true one: gdal_translate -a_srs EPSG:4326 dem.asc dem_placed.tif, and project that");
}

TEST_F(RefusedRaster, MetresOfNoMapAreNoDegrees) {
  write("dem.asc", "ncols 3\nnrows 2\nxllcorner 13\nyllcorner 47\ncellsize 0.5\n1 2 3\n4 5 6\n");
  EXPECT_EQ(refusal("dem.asc"), "was read");
}

TEST_F(RefusedRaster, DegreesThatAreSaidToBeMetres) {
  RasterSpec spec;
  spec.geotransform = {13.1, 1e-4, 0, 47.3, 0, -1e-4};
  EXPECT_EQ(refusal(spec),
            "dem.tif: seems to be in degrees (its cells are 0.0001 x 0.0001, and it is said to be in EPSG:31287). Name "
            "the true one: gdal_translate -a_srs EPSG:4326 dem.tif dem_placed.tif, and project that");
}

TEST_F(RefusedRaster, ExchangedXAndYLieElsewhere) {
  RasterSpec spec;
  spec.crs = "EPSG:32633";
  spec.geotransform = {5200000, 10, 0, 500030, 0, -10};
  EXPECT_EQ(
      refusal(spec),
      "dem.tif: lies elsewhere (its centre (5200020, 500015) is 36 degrees from where EPSG:32633 holds). Name the "
      "true one, or bring its coordinates into the order x, y: gdal_translate -a_srs EPSG:XXXX dem.tif "
      "dem_placed.tif");
}

TEST_F(RefusedRaster, TheNextZoneIsTakenAndTheOneAfterIsDoubted) {
  RasterSpec spec;
  spec.crs = "EPSG:32633";  // 12 to 18 degrees east; at 47 degrees north one degree is 76 km
  spec.geotransform = {800000, 10, 0, 5200030, 0, -10};
  EXPECT_EQ(refusal(spec), "was read");
  EXPECT_EQ(warnings(), "");
  spec.geotransform = {1000000, 10, 0, 5200030, 0, -10};
  EXPECT_EQ(refusal(spec), "was read");
  EXPECT_EQ(
      warnings(),
      "dem.tif: warning: seems to lie elsewhere (its centre (1000020, 5200015) is 4 degrees from where EPSG:32633 "
      "holds). Name the true one, or bring its coordinates into the order x, y: gdal_translate -a_srs EPSG:XXXX "
      "dem.tif dem_placed.tif");
}

TEST_F(RefusedRaster, APlaceOffTheEarth) {
  RasterSpec spec;
  spec.crs = "EPSG:3035";
  spec.geotransform = {400000000, 10, 0, 300030, 0, -10};
  EXPECT_EQ(refusal(spec),
            "dem.tif: lies nowhere on the earth (its centre (400000020, 300015) has no place in EPSG:3035). Name the "
            "true one, or bring its coordinates into the order x, y: gdal_translate -a_srs EPSG:XXXX dem.tif "
            "dem_placed.tif");
}

TEST_F(RefusedRaster, CoordinatesThatNoMapHas) {
  RasterSpec spec;
  spec.crs = "";
  spec.geotransform = {1e12, 10, 0, 300030, 0, -10};
  EXPECT_EQ(refusal(spec),
            "dem.tif: lies too far away (x = 1e+12 to 1e+12, y = 300000 to 300030; coordinates lie within 1e+09 m). "
            "Tell it: gdal_translate -a_ullr WEST NORTH EAST SOUTH dem.tif dem_placed.tif");
}

TEST_F(RefusedRaster, APictureHasNoClasses) {
  RasterSpec spec;
  spec.type = GDT_Byte;
  spec.colour = GCI_RedBand;
  make("photo.tif", spec);
  EXPECT_EQ(refusal_as_classes("photo.tif"),
            "photo.tif: is a picture (band 1 is the colour component \"Red\"; Talus needs classes there). If it does "
            "hold them: gdal_translate -b 1 -colorinterp_1 gray photo.tif photo_classes.tif");
}

}  // namespace
}  // namespace talus

#endif
