#include "talus/import/class_raster.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#ifdef TALUS_HAS_GDAL

#include <cmath>

#include "support/dice.hpp"
#include "support/rasters.hpp"

namespace talus {
namespace {

using namespace testing_tools;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using Class = std::optional<std::int32_t>;

class ClassRasterTest : public RasterFolder {
 protected:
  [[nodiscard]] ClassRaster open(const RasterSpec& spec, const std::string& terrain_crs = "EPSG:31287") {
    make("ground.tif", spec);
    warnings_ = Problems{};
    return ClassRaster(path("ground.tif"), terrain_crs.empty() ? "" : wkt(terrain_crs), warnings_);
  }
  [[nodiscard]] std::string refusal(const RasterSpec& spec, const std::string& terrain_crs = "EPSG:31287") {
    return refusal_of([&] {
      const Vec2 point(400005, 300025);
      static_cast<void>(open(spec, terrain_crs).at({&point, 1}));
    });
  }
};

RasterSpec byte_raster() {
  RasterSpec spec;
  spec.type = GDT_Byte;
  return spec;
}

TEST_F(ClassRasterTest, ReturnsTheClassOfTheCellThatContainsAPoint) {
  RasterSpec spec = byte_raster();
  spec.no_data = 6;
  ClassRaster classes = open(spec);
  const std::vector<Vec2> points{{400000.1, 300029.9}, {400009.9, 300020.1}, {400010.1, 300029.9}, {400039.9, 300000.1},
                                 {400015, 300015},     {399999.9, 300015},   {400040.1, 300015},   {400005, 300031}};
  EXPECT_THAT(classes.at(points),
              ElementsAre(Class{1}, Class{1}, Class{2}, Class{12}, Class{}, Class{}, Class{}, Class{}));
  EXPECT_EQ(classes.points_within(), 5U);
  EXPECT_EQ(classes.crs_name(), "EPSG:31287");
  EXPECT_EQ(warnings(), "");
}

TEST_F(ClassRasterTest, ReadsRotatedRasters) {
  RasterSpec spec = byte_raster();
  spec.geotransform = {400000, 0, 10, 300000, 10, 0};  // columns go north, rows go east
  const std::vector<Vec2> points{{400005, 300005}, {400005, 300015}, {400015, 300005}};
  EXPECT_THAT(open(spec).at(points), ElementsAre(Class{1}, Class{2}, Class{5}));
}

TEST_F(ClassRasterTest, ReadsIntegersStoredAsFloatsAndNegativeOnes) {
  RasterSpec spec;
  spec.cells[0] = -7;
  const Vec2 point(400005, 300025);
  EXPECT_THAT(open(spec).at({&point, 1}), ElementsAre(Class{-7}));
}

TEST_F(ClassRasterTest, TransformsPointsToTheCoordinateSystemOfTheFile) {
  RasterSpec spec = byte_raster();
  spec.crs = "EPSG:32632";
  spec.columns = spec.rows = 200;
  spec.geotransform = {600000, 10, 0, 5236000, 0, -10};
  spec.cells.clear();
  for (int row = 0; row < 200; ++row) {
    for (int column = 0; column < 200; ++column) spec.cells.push_back((column / 8 + 31 * (row / 8)) % 251);
  }
  ClassRaster classes = open(spec);
  OGRSpatialReference lambert, utm;
  lambert.importFromEPSG(31287);
  utm.importFromEPSG(32632);
  lambert.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  utm.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  const std::unique_ptr<OGRCoordinateTransformation> there(OGRCreateCoordinateTransformation(&utm, &lambert));
  // The south-west of the raster, in the coordinates of the terrain.
  double x = 600200, y = 5234200;
  ASSERT_TRUE(there->Transform(1, &x, &y));
  std::vector<Vec2> points;
  for (int j = 0; j < 60; ++j) {
    for (int i = 0; i < 60; ++i) points.emplace_back(x + 25.3 * i, y + 25.3 * j);
  }
  const auto found = classes.at(points);
  const std::unique_ptr<OGRCoordinateTransformation> back(OGRCreateCoordinateTransformation(&lambert, &utm));
  int compared = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    double east = points[i].x(), north = points[i].y();
    ASSERT_TRUE(back->Transform(1, &east, &north));
    const double column = (east - 600000) / 10, row = (5236000 - north) / 10;
    const auto near_border = [](double cell) { return std::abs(cell - std::round(cell)) < 0.1; };
    if (near_border(column) || near_border(row)) continue;
    ++compared;
    EXPECT_EQ(found[i], (static_cast<int>(column) / 8 + 31 * (static_cast<int>(row) / 8)) % 251) << i;
  }
  EXPECT_GT(compared, 2000);
  EXPECT_EQ(classes.points_within(), points.size());
}

TEST_F(ClassRasterTest, ReadsDistantPointsInWindows) {
  RasterSpec spec = byte_raster();
  spec.columns = 3000;
  spec.rows = 3000;
  spec.cells.assign(9000000, 0);
  Dice dice(5);
  for (double& cell : spec.cells) cell = std::floor(dice.between(0, 250));
  ClassRaster classes = open(spec);
  std::vector<Vec2> points;
  std::vector<Class> expected;
  for (int i = 0; i < 100; ++i) {
    const int column = static_cast<int>(dice.between(0, 3000)), row = static_cast<int>(dice.between(0, 3000));
    points.emplace_back(400005 + 10 * column, 300025 - 10 * row);
    expected.push_back(static_cast<std::int32_t>(spec.cells[static_cast<std::size_t>(row) * 3000 + column]));
  }
  EXPECT_EQ(classes.at(points), expected);
}

TEST_F(ClassRasterTest, WithoutACoordinateSystemThatOfTheTerrainIsAssumed) {
  RasterSpec spec = byte_raster();
  spec.crs = "";
  const Vec2 point(400005, 300025);
  EXPECT_THAT(open(spec).at({&point, 1}), ElementsAre(Class{1}));
  EXPECT_EQ(warnings(),
            "ground.tif: warning: has no coordinate system (that of the terrain is assumed). Assign it: gdal_translate "
            "-a_srs EPSG:XXXX ground.tif ground_placed.tif");
  EXPECT_THAT(open(spec, "").at({&point, 1}), ElementsAre(Class{1}));
  EXPECT_EQ(warnings(), "");
}

TEST_F(ClassRasterTest, WarnsOfFurtherBands) {
  make("ground.tif", byte_raster());
  const std::string source = vrt_source("ground.tif");
  write("two.vrt", Vrt{}.band(source, "Byte").band(source, "Byte").text());
  const ClassRaster classes(path("two.vrt"), wkt("EPSG:31287"), warnings_);
  EXPECT_EQ(warnings(), "two.vrt: warning: has 2 bands (Talus reads the first)");
}

TEST_F(ClassRasterTest, RefusesRastersThatAreNotClasses) {
  EXPECT_EQ(refusal_of([&] {
              Problems warnings;
              const ClassRaster none(path("none.tif"), "", warnings);
            }),
            "none.tif: cannot be read (there is no such file). Paths are relative to the project file");
  RasterSpec fraction;
  fraction.cells[0] = 2.5;
  EXPECT_EQ(refusal(fraction),
            "ground.tif: has the class 2.5 (a class is a whole number of at most 32 bits). Round them: gdal_translate "
            "-ot Int32 ground.tif ground_classes.tif");
  RasterSpec imaginary;
  imaginary.type = GDT_CInt16;
  imaginary.geotransform.reset();
  EXPECT_EQ(refusal(imaginary),
            "ground.tif: has complex numbers in band 1 (a class is a whole number). Keep the real part: "
            "gdal_translate -ot Int32 ground.tif ground_classes.tif\n"
            "ground.tif: is not georeferenced (it has no geotransform: neither a corner nor a cell size). Assign its "
            "extent: gdal_translate -a_ullr WEST NORTH EAST SOUTH ground.tif ground_placed.tif");
  RasterSpec scaled = byte_raster();
  scaled.scale = 0.1;
  EXPECT_EQ(refusal(scaled),
            "ground.tif: has the scale 0.1 and the offset 0 (classes are the raw values of cells). Remove them: "
            "gdal_translate -a_scale 1 -a_offset 0 ground.tif ground_classes.tif");
  RasterSpec site = byte_raster();
  site.crs = "LOCAL_CS[\"site grid\",UNIT[\"metre\",1]]";
  EXPECT_EQ(refusal(site),
            "ground.tif: is in site grid (there is no transformation to it from EPSG:31287, that of the terrain). "
            "Assign the right one: gdal_translate -a_srs EPSG:XXXX ground.tif ground_placed.tif");
}

TEST_F(ClassRasterTest, RefusesFilesThatCannotBeReadCompletely) {
  const std::string properties =
      "<SourceProperties RasterXSize=\"4\" RasterYSize=\"3\" DataType=\"Float32\" BlockXSize=\"4\" BlockYSize=\"3\"/>";
  write("cut.vrt", Vrt{}.band(vrt_source("gone.tif", true, properties), "Byte").text());
  make("gone.tif");
  Problems none;
  ClassRaster classes(path("cut.vrt"), "", none);
  std::filesystem::remove(path("gone.tif"));  // before its first cell is read
  EXPECT_THAT(refusal_of([&] {
                const Vec2 point(400005, 300025);
                static_cast<void>(classes.at({&point, 1}));
              }),
              HasSubstr("cut.vrt: cannot be read completely (GDAL: "));
}

}  // namespace
}  // namespace talus

#else

namespace talus {
namespace {

TEST(ClassRaster, IsRefusedWithoutGdal) {
  Problems warnings;
  try {
    const ClassRaster classes("ground.tif", "", warnings);
    FAIL() << "was read";
  } catch (const BadInput& error) {
    EXPECT_STREQ(error.what(),
                 "ground.tif: cannot be read (this build of Talus has no GDAL). Build it with GDAL: cmake --preset "
                 "release -DTALUS_GDAL=ON");
  }
}

}  // namespace
}  // namespace talus

#endif
