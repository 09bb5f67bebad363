// Areas of the ground, on rasters, meshes and extruded sections: they override other materials.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <array>
#include <string>

#include "support/gis_project.hpp"
#include "support/projects.hpp"
#include "talus/campaign/simulate.hpp"

namespace talus::project {
namespace {

using namespace testing_tools;

struct Case {
  const char* name;
  const char* text;      // from line 10 on
  const char* problems;  // errors, or warnings
  const char* terrain = "vertices = [[0, 0, 0], [9, 0, 0], [0, 9, 5], [9, 9, 0]]\ntriangles = [[0, 1, 2], [1, 3, 2]]";
};

std::string project_text(const Case& c) {
  const std::string terrain = c.terrain;
  const std::string place = terrain.starts_with("section") ? "[1, 5]" : "[1, 0, 5]";
  return "[terrain]\n" + terrain +
         "\n[[material]]\nname = \"Rock\"\n[[material]]\nname = \"Scree\"\n[ground]\ndefault = \"Rock\"\n" + c.text +
         "[[seeder]]\nposition = " + place + "\nmass_kg = 10\n";
}

class Areas : public ::testing::TestWithParam<Case> {};

TEST_P(Areas, HaveTheseProblems) { EXPECT_EQ(problems_of_model(project_text(GetParam())), GetParam().problems); }

const Case cases[] = {
    {"Good", "[[area]]\nmaterial = \"Scree\"\npolygon = [[1, 1], [9, 1], [1, 9]]\n", ""},
    {"MaterialUnknown", "[[area]]\nname = \"Fan\"\nmaterial = \"Scre\"\npolygon = [[1, 1], [9, 1], [1, 9]]\n",
     "slope.toml:12: area \"Fan\": material is \"Scre\" (no material has this name; the project has \"Rock\", "
     "\"Scree\"). Did you mean \"Scree\"?"},
    {"WithoutMaterial", "[[area]]\npolygon = [[1, 1], [9, 1], [1, 9]]\n", "slope.toml:10: area 1: material is missing"},
    {"WithoutPolygon", "[[area]]\nmaterial = \"Scree\"\n", "slope.toml:10: area 1: polygon is missing"},
    {"CrossesItself", "[[area]]\nmaterial = \"Scree\"\npolygon = [[0, 0], [1, 1], [1, 0], [0, 1]]\n",
     "slope.toml:12: area 1: polygon crosses or touches itself (at or near (0.5, 0.5)). Give its corners in order, "
     "once around"},
    {"TwoPoints", "[[area]]\nmaterial = \"Scree\"\npolygon = [[0, 0], [1, 1]]\n",
     "slope.toml:12: area 1: polygon is [[0, 0], [1, 1]] (expected three or more points on plan, [[x, y], [x, y], [x, "
     "y]])"},
    {"SameName",
     "[[area]]\nname = \"Fan\"\nmaterial = \"Scree\"\npolygon = [[1, 1], [9, 1], [1, 9]]\n"
     "[[area]]\nname = \"Fan\"\nmaterial = \"Scree\"\npolygon = [[1, 1], [9, 1], [1, 9]]\n",
     "slope.toml:15: two areas are named \"Fan\" (the first begins in line 10). Give each its own name"},
    {"Beyond", "[[area]]\nname = \"Fan\"\nmaterial = \"Scree\"\npolygon = [[10, 1], [19, 1], [10, 9]]\n",
     "slope.toml:10: warning: area \"Fan\": has no effect (its polygon lies outside the terrain, which extends over x "
     "= 0 to 9, y = 0 to 9)"},
    {"BetweenCentres", "[[area]]\nmaterial = \"Scree\"\npolygon = [[0, 0], [2, 0], [0, 2]]\n",
     "slope.toml:10: warning: area \"area 1\": has no effect (its polygon contains the centre of no triangle of the "
     "terrain). A triangle counts by its centre: draw the polygon around that"},
    {"InASection", "[[area]]\nmaterial = \"Scree\"\npolygon = [[0, 0], [2, 0], [0, 2]]\n",
     "slope.toml:10: area 1: an area is given in 2D (a section has segments). Use ground.segments, with one name for "
     "each segment",
     "section = [[0, 0], [10, -10]]\n"},
};

INSTANTIATE_TEST_SUITE_P(All, Areas, testing::ValuesIn(cases),
                         [](const auto& given) { return std::string(given.param.name); });

TEST(AreasOfAMesh, ALaterAreaOverridesEarlierOnesAndListedTriangles) {
  const std::string terrain =
      "[terrain]\nvertices = [[0, 0, 0], [9, 0, 0], [9, 9, 0], [0, 9, 5], [18, 0, 0], [18, 9, 0]]\n"
      "triangles = [[0, 1, 2], [0, 2, 3], [1, 4, 5], [1, 5, 2]]\n[[material]]\nname = \"A\"\n[[material]]\nname = "
      "\"B\"\n[[material]]\nname = \"C\"\n[ground]\ntriangles = [1, 0, 1, 0]\n"
      "[[seeder]]\nposition = [1, 0, 5]\nmass_kg = 10\n";
  const auto area = [](const char* material, int x0, int x1) {
    return fmt::format("[[area]]\nmaterial = \"{0}\"\npolygon = [[{1}, -1], [{2}, -1], [{2}, 10], [{1}, 10]]\n",
                       material, x0, x1);
  };
  const auto materials = [&](const std::string& areas) {
    const Model model = model_without_warnings(terrain + areas);
    std::array<std::uint32_t, 4> of{};
    for (std::uint32_t k = 0; k < 4; ++k) of[k] = model.ground.material_of(k).index;
    return of;
  };
  EXPECT_EQ(materials(""), (std::array{1U, 0U, 1U, 0U}));
  // The centres are at x = 6, 3, 15 and 12.
  EXPECT_EQ(materials(area("C", 5, 13)), (std::array{2U, 0U, 1U, 2U}));
  EXPECT_EQ(materials(area("C", 5, 13) + area("A", 4, 20)), (std::array{0U, 0U, 0U, 0U}));
  EXPECT_EQ(materials(area("A", 4, 20) + area("C", 5, 13)), (std::array{2U, 0U, 0U, 2U}));
}

// A strip of the slope may have its material by segment or by area, with the same result.
TEST(AreasOfASlope, TrajectoriesAreAsOnTheSegmentUnderTheArea) {
  const std::string head =
      "[terrain]\nsection = [[0, 60], [20, 30], [50, 10], [90, 5]]\nwidth_m = 40\n[[material]]\nname = \"Rock\"\n"
      "[[material]]\nname = \"Soil\"\nnormal_restitution = 0.2\ntangential_restitution = 0.6\n";
  const std::string seeder =
      "[[seeder]]\ntype = \"line\"\npoints = [[1, 10], [1, 30]]\nheight_above_m = 2\nmass_kg = 500\nrocks = 40\n";
  const Model by_segment =
      model_without_warnings(head + "[ground]\nsegments = [\"Rock\", \"Soil\", \"Rock\"]\n" + seeder);
  const Model by_area =
      model_without_warnings(head + "[ground]\ndefault = \"Rock\"\n" + seeder +
                             "[[area]]\nmaterial = \"Soil\"\npolygon = [[20, -50], [50, -50], [50, 90], [20, 90]]\n");
  Simulator one(by_segment), other(by_area);
  for (std::uint64_t rock = 0; rock < 40; ++rock) {
    const RockOutcome a = one.simulate(rock, false).outcome, b = other.simulate(rock, false).outcome;
    EXPECT_EQ(a.end.position, b.end.position) << rock;
    EXPECT_EQ(a.events, b.events) << rock;
  }
}

#ifdef TALUS_HAS_GDAL

class AreasOfARaster : public GisProject {
 protected:
  AreasOfARaster() { make("dem.tif", mountain()); }
  const std::string head = fmt::format(
      "[terrain]\nraster = \"dem.tif\"\n[[material]]\nname = \"Rock\"\n[[material]]\nname = \"Scree\"\n[[material]]\n"
      "name = \"Meadow\"\n[[seeder]]\nposition = [{}, {}]\nheight_above_m = 1\nmass_kg = 1000\n[ground]\ndefault = "
      "\"Meadow\"\n",
      west + 50, south + 50);
};

TEST_F(AreasOfARaster, CellsHaveTheMaterialOfTheAreaAtTheirCentre) {
  // A triangle with no centre on its edges: those of the cells are at 5, 10, 15 ... m.
  const auto is_within = [](double x, double y) { return x > 21.3 && y > 11.7 && (x - 21.3) + (y - 11.7) < 120.1; };
  const std::string area =
      fmt::format("[[area]]\nmaterial = \"Scree\"\npolygon = [[{0}, {1}], [{2}, {1}], [{0}, {3}]]\n", west + 21.3,
                  south + 11.7, west + 141.4, south + 131.8);
  const auto expect_materials = [&](const Model& model, auto&& elsewhere) {
    const auto& grid = std::get<RasterSurface>(*model.surface).grid();
    std::uint32_t cell_number = 0;
    for (std::uint32_t row = 0; row + 1 < grid.rows; ++row) {
      for (std::uint32_t column = 0; column + 1 < grid.columns; ++column, ++cell_number) {
        const double x = cell * (column + 1), y = cell * (row + 1);
        EXPECT_EQ(model.ground.material_of(cell_number).index, is_within(x, y) ? 1U : elsewhere(x)) << x << ' ' << y;
      }
    }
  };
  expect_materials(model(head + area), [](double) { return 2U; });
  EXPECT_EQ(warnings(), "");
  // Over polygons of a file, which need not have its material.
  layer("ground.gpkg", "kind", {{box(0, 0, 100, 200), "Rock"}, {box(100, 0, 300, 200), "Meadow"}});
  expect_materials(model(head + "polygons = \"ground.gpkg\"\nattribute = \"kind\"\n" + area),
                   [](double x) { return x < 100 ? 0U : 2U; });
  EXPECT_EQ(warnings(), "");
  // Over a raster of classes.
  RasterSpec classes = mountain();
  classes.type = GDT_Byte;
  classes.no_data.reset();
  for (std::size_t k = 0; k < classes.cells.size(); ++k) classes.cells[k] = k % columns < 30 ? 1 : 2;
  make("classes.tif", classes);
  expect_materials(model(head + "raster = \"classes.tif\"\nclasses = { 1 = \"Rock\", 2 = \"Meadow\" }\n" + area),
                   [](double x) { return x < 150 ? 0U : 2U; });
  EXPECT_EQ(warnings(), "");
}

TEST_F(AreasOfARaster, AnAreaOnlyOverHolesHasNoEffect) {
  RasterSpec holed = mountain();
  for (int row = 0; row < rows; ++row) {
    for (int column = 30; column < columns; ++column) {
      holed.cells[static_cast<std::size_t>(row * columns + column)] = -9999;
    }
  }
  make("dem.tif", holed);
  static_cast<void>(
      model(head + fmt::format("[[area]]\nmaterial = \"Rock\"\npolygon = [[{0}, {1}], [{2}, {1}], [{2}, {3}]]\n",
                               west + 170, south + 20, west + 260, south + 90)));
  EXPECT_EQ(warnings(),
            "slope.toml:15: warning: area \"area 1\": has no effect (its polygon contains the centre of no cell of the "
            "terrain). A cell counts by its centre: draw the polygon around that");
}

#endif

}  // namespace
}  // namespace talus::project
