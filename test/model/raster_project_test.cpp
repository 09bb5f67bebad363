// Projects whose terrain or ground is a raster: their models and problems.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#ifdef TALUS_HAS_GDAL

#include <fmt/format.h>

#include "support/rasters.hpp"
#include "talus/campaign/simulate.hpp"
#include "talus/model/model.hpp"
#include "talus/project/read.hpp"

namespace talus::project {
namespace {

using namespace testing_tools;

// A plane that falls to the east by 1 in 2, 200 m by 100 m, with 5 m cells, in Austria.
constexpr int columns = 40, rows = 20;
constexpr double west = 400000, north = 300100, cell = 5;

double height(double x) { return 1500 - 0.5 * (x - west); }

RasterSpec falling_plane() {
  RasterSpec spec;
  spec.columns = columns;
  spec.rows = rows;
  spec.geotransform = {west, cell, 0, north, 0, -cell};
  spec.cells.clear();
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) spec.cells.push_back(height(west + cell * (column + 0.5)));
  }
  return spec;
}

/// Classes on cells of 20 m: 1 in the west half, 2 in the east.
RasterSpec halves() {
  RasterSpec spec;
  spec.columns = 10;
  spec.rows = 5;
  spec.type = GDT_Byte;
  spec.geotransform = {west, 20, 0, north, 0, -20};
  spec.cells.clear();
  for (int k = 0; k < 50; ++k) spec.cells.push_back(k % 10 < 5 ? 1 : 2);
  return spec;
}

const std::string terrain_raster = "[terrain]\nraster = \"dem.tif\"\n";

const std::string rest = R"(
[[material]]
name = "Rock"
[[material]]
name = "Scree"
[[seeder]]
name = "Crest"
position = [400010, 300050]
height_above_m = 5
rocks = 10
mass_kg = 1000
horizontal_velocity_m_s = { mean = 3, distribution = "normal", std_dev = 1 }
)";

const std::string all_rock = "[ground]\ndefault = \"Rock\"\n";
const std::string from_classes =
    "[ground]\ndefault = \"Rock\"\nraster = \"ground.tif\"\nclasses = { 1 = \"Rock\", 2 = \"Scree\" }\n";

class RasterProject : public RasterFolder {
 protected:
  [[nodiscard]] Model model(const std::string& text) {
    write("slope.toml", text);
    warnings_ = Problems{};
    return build_model(read_project(path("slope.toml")).project, warnings_);
  }
  [[nodiscard]] std::string refusal(const std::string& text) {
    return refusal_of([&] { static_cast<void>(model(text)); });
  }
  [[nodiscard]] std::string warnings() const { return without_folder(warnings_.text()); }

  Problems warnings_;
};

std::uint32_t material_at(const Model& model, std::uint32_t column, std::uint32_t row) {
  return model.ground.material_of(row * (columns - 1) + column).index;
}

TEST_F(RasterProject, TrajectoriesAreAsOnTheSamePlaneOfTriangles) {
  make("dem.tif", falling_plane());
  const Model raster = model(terrain_raster + rest + all_rock);
  EXPECT_EQ(warnings(), "");
  EXPECT_EQ(raster.terrain_report, "dem.tif: 40 x 20 nodes, 5 x 5 m apart, EPSG:31287, 0 without data");
  EXPECT_THAT(raster.crs_wkt, ::testing::StartsWith("PROJCRS["));
  EXPECT_EQ(raster.frame.origin, Vec3(400384, 300032, 0));
  const double low = west + 2.5, high = west + 197.5;
  const Model mesh = model(fmt::format("[terrain]\nvertices = "
                                       "[[{0},300002.5,{2}],[{1},300002.5,{3}],[{1},300097.5,{3}],[{0},300097.5,{2}]]"
                                       "\ntriangles = [[0,1,2],[0,2,3]]\n",
                                       low, high, height(low), height(high)) +
                           rest + all_rock);
  Simulator on_raster(raster), on_mesh(mesh);
  for (std::uint64_t rock = 0; rock < 10; ++rock) {
    const Vec3 a = raster.frame.global_from_local(on_raster.simulate(rock, false).outcome.end.position);
    const Vec3 b = mesh.frame.global_from_local(on_mesh.simulate(rock, false).outcome.end.position);
    EXPECT_LT((a - b).norm(), 1e-3) << rock;
    EXPECT_GT(a.x(), 400020);
  }
}

TEST_F(RasterProject, CellsHaveTheMaterialOfTheirClass) {
  make("dem.tif", falling_plane());
  make("ground.tif", halves());
  const Model both = model(terrain_raster + rest + from_classes);
  EXPECT_EQ(warnings(), "");
  // The centres of cells are at 5 m, 10 m, ... from the west; the border of the classes is at 100 m.
  EXPECT_EQ(material_at(both, 0, 0), 0U);
  EXPECT_EQ(material_at(both, 18, 7), 0U);
  EXPECT_EQ(material_at(both, 20, 7), 1U);
  EXPECT_EQ(material_at(both, 38, 18), 1U);
  EXPECT_EQ(both.ground.bytes(), 39U * 19U);
}

TEST_F(RasterProject, ASingleMaterialTakesNoMemory) {
  make("dem.tif", falling_plane());
  make("ground.tif", halves());
  EXPECT_EQ(model(terrain_raster + rest + all_rock).ground.bytes(), 0U);
  const Model scree =
      model(terrain_raster + rest + "[ground]\nraster = \"ground.tif\"\nclasses = { 1 = \"Scree\", 2 = \"Scree\" }\n");
  EXPECT_EQ(scree.ground.bytes(), 0U);
  EXPECT_EQ(material_at(scree, 3, 3), 1U);
}

TEST_F(RasterProject, TrianglesHaveTheClassAtTheirCentre) {
  make("ground.tif", halves());
  const Model mesh = model(
      "[terrain]\nvertices = "
      "[[400000,300000,1500],[400100,300000,1450],[400000,300100,1500],[400200,300000,1400],[400200,300100,1400],["
      "400100,300100,1450]]\ntriangles = [[0,1,2],[1,3,4],[1,5,2],[1,4,5]]\n" +
      rest + from_classes);
  EXPECT_EQ(warnings(), "");
  std::vector<std::uint32_t> found;
  for (std::uint32_t k = 0; k < 4; ++k) found.push_back(mesh.ground.material_of(k).index);
  EXPECT_THAT(found, ::testing::ElementsAre(0, 1, 0, 1));
}

TEST_F(RasterProject, CellsWithoutClassAreReportedAndGetTheDefault) {
  make("dem.tif", falling_plane());
  RasterSpec classes = halves();
  classes.columns = 9;  // the last 20 m of the terrain are outside: the centres of 4 columns of cells
  classes.cells.resize(45);
  classes.no_data = 0;
  for (int k = 0; k < 45; ++k) classes.cells[static_cast<std::size_t>(k)] = k == 0 ? 0 : 2;
  make("ground.tif", classes);
  const Model out = model(terrain_raster + rest + from_classes);
  EXPECT_EQ(material_at(out, 0, 18), 0U);
  EXPECT_EQ(material_at(out, 0, 0), 1U);
  EXPECT_EQ(warnings(),
            "slope.toml:17: warning: [ground]: 85 of 741 cells of the terrain have no class (raster \"ground.tif\" has "
            "no data there, or does not reach that far). They are given the default material, \"Rock\"\n"
            "slope.toml:17: warning: [ground]: classes has 1, which no part of the terrain has (in raster "
            "\"ground.tif\" at the centres of the terrain's cells)");
}

TEST_F(RasterProject, UnusedClassesAreReported) {
  make("dem.tif", falling_plane());
  make("ground.tif", halves());
  const std::string more =
      "[ground]\ndefault = \"Rock\"\nraster = \"ground.tif\"\n"
      "classes = { 1 = \"Rock\", 2 = \"Scree\", 7 = \"Scree\", -3 = \"Rock\" }\n";
  static_cast<void>(model(terrain_raster + rest + more));
  EXPECT_EQ(warnings(),
            "slope.toml:17: warning: [ground]: classes has -3, 7, which no part of the terrain has (in raster "
            "\"ground.tif\" at the centres of the terrain's cells)");
}

TEST_F(RasterProject, HolesOfTheTerrainNeedNoClass) {
  RasterSpec terrain = falling_plane();
  terrain.no_data = -1;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < 8; ++column) terrain.cells[static_cast<std::size_t>(row * columns + column)] = -1;
  }
  make("dem.tif", terrain);
  RasterSpec classes = halves();
  classes.no_data = 0;
  for (std::size_t k = 0; k < 50; k += 10) classes.cells[k] = classes.cells[k + 1] = 0;
  make("ground.tif", classes);
  std::string text = terrain_raster + rest + from_classes;
  EXPECT_EQ(refusal(text),
            "slope.toml:8: seeder \"Crest\": (400010, 300050) is off the terrain (the terrain has a hole there, "
            "without data or triangles)");
  text.replace(text.find("400010"), 6, "400060");
  static_cast<void>(model(text));
  EXPECT_EQ(warnings(), "");
}

TEST_F(RasterProject, ClassesWithoutAMaterialAreRefusedWithTheirCounts) {
  make("dem.tif", falling_plane());
  RasterSpec classes = halves();
  classes.cells[0] = 7;
  classes.cells[9] = 9;
  make("ground.tif", classes);
  EXPECT_EQ(refusal(terrain_raster + rest + from_classes),
            "slope.toml:17: [ground]: raster \"ground.tif\" has classes that are not in classes (7 in 9, 9 in 12 of "
            "the terrain's cells). Add 7 = \"...\" to classes");
}

TEST_F(RasterProject, AGroundWithoutAnyClassIsRefused) {
  make("dem.tif", falling_plane());
  RasterSpec classes = halves();
  classes.no_data = 0;
  std::fill(classes.cells.begin(), classes.cells.end(), 0);
  make("ground.tif", classes);
  EXPECT_EQ(refusal(terrain_raster + rest + from_classes),
            "slope.toml:17: [ground]: raster \"ground.tif\" has no class anywhere on the terrain (none of 741 cells "
            "has data in it). Check it with gdalinfo -stats: its no-data value is not a class");
}

TEST_F(RasterProject, AGroundOutsideTheTerrainIsRefused) {
  make("dem.tif", falling_plane());
  RasterSpec classes = halves();
  classes.geotransform = {500000, 20, 0, north, 0, -20};
  make("ground.tif", classes);
  EXPECT_EQ(refusal(terrain_raster + rest + from_classes),
            "slope.toml:17: [ground]: raster \"ground.tif\" does not reach the terrain (the terrain lies within x = "
            "400002.5 to 400197.5, y = 300002.5 to 300097.5). Check its extent and coordinate system with gdalinfo");
}

TEST_F(RasterProject, AGroundWithTooManyMaterialsIsRefused) {
  make("dem.tif", falling_plane());
  make("ground.tif", halves());
  std::string many;
  for (int k = 0; k < 255; ++k) many += fmt::format("[[material]]\nname = \"{}\"\n", k);
  EXPECT_EQ(refusal(terrain_raster + rest + many + from_classes),
            "slope.toml: [ground]: raster is given with 257 materials (a ground from a file has at most 255)");
}

TEST_F(RasterProject, ErrorsInFilesAndSeedersAreReportedTogetherByLine) {
  make("dem.tif", falling_plane());
  make("ground.tif", halves());
  RasterSpec classes = halves();
  classes.type = GDT_Float32;
  classes.cells[3] = 1.5;
  make("ground.tif", classes);
  std::string text = terrain_raster + rest + from_classes;
  text.replace(text.find("400010"), 6, "400210");
  EXPECT_EQ(refusal(text),
            "slope.toml:8: seeder \"Crest\": (400210, 300050) is off the terrain (on plan the terrain lies within x = "
            "400002.5 to 400197.5, y = 300002.5 to 300097.5)\n"
            "slope.toml:17: [ground]: raster ground.tif: has the class 1.5 (a class is a whole number of at most 32 "
            "bits). Round them: gdal_translate -ot Int32 ground.tif ground_classes.tif");
}

TEST_F(RasterProject, MissingFilesAreReportedAtTheirLines) {
  EXPECT_EQ(refusal(terrain_raster + rest + from_classes),
            "slope.toml:2: [terrain]: raster is \"dem.tif\" (there is no such file). The path is relative to the "
            "project file\n"
            "slope.toml:17: [ground]: raster is \"ground.tif\" (there is no such file). The path is relative to "
            "the project file");
}

TEST_F(RasterProject, UsesTheGivenCoordinateSystemIfTheFileHasNone) {
  RasterSpec spec = falling_plane();
  spec.crs = "";
  make("dem.tif", spec);
  const auto with_crs = [&](const std::string& crs) {
    return model("[terrain]\nraster = \"dem.tif\"\n" + crs + rest + all_rock).crs_wkt;
  };
  EXPECT_EQ(with_crs(""), "");
  EXPECT_NE(warnings(), "");
  EXPECT_EQ(with_crs("crs = \"local\"\n"), "");
  EXPECT_EQ(warnings(), "");
  EXPECT_THAT(with_crs("crs = \"EPSG:31287\"\n"), ::testing::StartsWith("PROJCRS["));
  EXPECT_EQ(warnings(), "");
}

TEST_F(RasterProject, ATerrainInDegreesIsRefused) {
  RasterSpec spec = falling_plane();
  spec.crs = "EPSG:4326";
  spec.geotransform = {11.2, 0.0001, 0, 47.3, 0, -0.0001};
  make("dem.tif", spec);
  EXPECT_EQ(refusal(terrain_raster + rest + all_rock),
            "slope.toml:2: [terrain]: raster dem.tif: is in degrees (EPSG:4326 is a geographic coordinate system; "
            "Talus needs metres on plan). Project it: gdalwarp -t_srs EPSG:32632 -r bilinear dem.tif dem_metres.tif");
}

}  // namespace
}  // namespace talus::project

#endif
