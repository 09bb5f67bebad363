// Forests over the ground: materials below them, the order of forests, files, and what is refused.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <string>
#include <vector>

#include "support/gis_project.hpp"
#include "support/projects.hpp"
#include "talus/campaign/simulate.hpp"
#include "talus/model/model.hpp"
#include "talus/project/parameter.hpp"

namespace talus::project {
namespace {

using namespace testing_tools;

struct ForestCase {
  const char* name;
  const char* forest;    // from line 10 on
  const char* problems;  // errors, or warnings
  const char* terrain = "vertices = [[0, 0, 0], [9, 0, 0], [0, 9, 5], [9, 9, 0]]\ntriangles = [[0, 1, 2], [1, 3, 2]]";
};

std::string with_forest(const ForestCase& c) {
  const std::string terrain = c.terrain;
  const std::string place = terrain.starts_with("section") ? "[1, 5]" : "[1, 0, 5]";
  return "[terrain]\n" + terrain + "\n[[material]]\nname = \"Rock\"\n[[material]]\nname = \"Scree\"\n[ground]\n" +
         "default = \"Rock\"\n[[forest]]\n" + c.forest + "[[seeder]]\nposition = " + place + "\nmass_kg = 10\n";
}

class Forests : public ::testing::TestWithParam<ForestCase> {};

TEST_P(Forests, HaveTheseProblems) { EXPECT_EQ(problems_of_model(with_forest(GetParam())), GetParam().problems); }

const ForestCase forest_cases[] = {
    {"Good", "density = \"open\"\nheight_m = 9\npolygon = [[1, 1], [9, 1], [1, 9]]\n", ""},
    {"AClearingHasNoHeight", "density = \"none\"\npolygon = [[1, 1], [9, 1], [1, 9]]\n", ""},
    {"Empty", "",
     "slope.toml:10: forest 1: polygon is missing (nothing says where the forest stands). Give polygon = [[x, y], "
     "...], or polygons = a file of them\n"
     "slope.toml:10: forest 1: density is missing (nothing says how much the forest slows rocks). Write density = "
     "\"open\", \"medium\" or \"dense\", or give drag_kg_s\n"
     "slope.toml:10: forest 1: height_m is missing (a forest slows rocks only up to its effective height). Give the "
     "height above the ground up to which trunks and branches slow rocks"},
    {"TwoPlaces", "drag_kg_s = 9\nheight_m = 9\npolygon = [[1, 1], [9, 1], [1, 9]]\npolygons = \"a.gpkg\"\n",
     "slope.toml:14: forest 1: polygon and polygons are given together (they exclude each other)"},
    {"ValuesOfNothing", "drag_kg_s = 9\nheight_m = 9\npolygon = [[1, 1], [9, 1], [1, 9]]\nattribute = \"kind\"\n",
     "slope.toml:14: forest 1: attribute is given without polygons (it would have no effect)\n"
     "slope.toml:14: forest 1: values is missing (attribute tells which polygons are this forest by its values). Write "
     "values = [\"...\"], or leave out attribute for all polygons of the file"},
    {"Beyond", "name = \"Wood\"\ndrag_kg_s = 9\nheight_m = 9\npolygon = [[10, 1], [19, 1], [10, 9]]\n",
     "slope.toml:10: warning: forest \"Wood\": has no effect (its polygon lies outside the terrain, which extends over "
     "x = 0 to 9, y = 0 to 9)"},
    {"InASection", "drag_kg_s = 9\nheight_m = 9\npolygon = [[1, 1], [9, 1], [1, 9]]\n",
     "slope.toml:10: forest 1: a [[forest]] is given in 2D (it is drawn on plan). Give the materials of the section a "
     "forest, with forest and forest_height_m",
     "section = [[0, 0], [10, -10]]\n"},
};

INSTANTIATE_TEST_SUITE_P(All, Forests, testing::ValuesIn(forest_cases),
                         [](const auto& given) { return std::string(given.param.name); });

// A slope with two materials, forest over parts of both.
const std::string wooded_slope =
    "[terrain]\nsection = [[0, 60], [20, 30], [50, 10], [90, 5]]\nwidth_m = 40\n"
    "[[material]]\nname = \"Rock\"\n"
    "normal_restitution = { mean = 0.4, distribution = \"normal\", std_dev = 0.05 }\n"
    "[[material]]\nname = \"Soil\"\nnormal_restitution = { mean = 0.3, distribution = \"normal\", std_dev = 0.05 }\n"
    "tangential_restitution = 0.6\nforest = \"open\"\nforest_height_m = 3\n"
    "[[seeder]]\ntype = \"line\"\npoints = [[1, 10], [1, 30]]\nheight_above_m = 2\nmass_kg = 500\nrocks = 40\n";
const std::string ground_of_segments = "[ground]\nsegments = [\"Rock\", \"Soil\", \"Rock\"]\n";

std::string forest_over(const std::string& keys, int from_x, int to_x) {
  return fmt::format("[[forest]]\n{0}\npolygon = [[{1}, -50], [{2}, -50], [{2}, 90], [{1}, 90]]\n", keys, from_x, to_x);
}

void expect_same_trajectories(const Model& one, const Model& other) {
  Simulator a(one), b(other);
  for (std::uint64_t rock = 0; rock < 40; ++rock) {
    const RockOutcome of_a = a.simulate(rock, false).outcome, of_b = b.simulate(rock, false).outcome;
    EXPECT_EQ(of_a.end.position, of_b.end.position) << rock;
    EXPECT_EQ(of_a.events, of_b.events) << rock;
  }
}

std::vector<std::string> material_names(const Model& model) {
  std::vector<std::string> names;
  for (const talus::Material& material : model.ground.materials()) names.push_back(material.name);
  return names;
}

const std::string spruce_wood = "name = \"wood\"\ndensity = \"medium\"\nheight_m = 12";

TEST(ForestsOverASlope, TrajectoriesAreAsOnMaterialsThatHaveTheForest) {
  const std::string as_materials =
      "[[material]]\nname = \"Soil, in wood\"\n"
      "normal_restitution = { mean = 0.3, distribution = \"normal\", std_dev = 0.05 }\n"
      "tangential_restitution = 0.6\nforest = \"medium\"\nforest_height_m = 12\n"
      "[[material]]\nname = \"Rock, in wood\"\n"
      "normal_restitution = { mean = 0.4, distribution = \"normal\", std_dev = 0.05 }\n"
      "forest = \"medium\"\nforest_height_m = 12\n";
  const Model laid = model_without_warnings(wooded_slope + ground_of_segments + forest_over(spruce_wood, 20, 90));
  EXPECT_THAT(material_names(laid), testing::ElementsAre("Rock", "Soil", "Rock, in wood", "Soil, in wood"));
  expect_same_trajectories(
      laid, model_without_warnings(wooded_slope + as_materials +
                                   "[ground]\nsegments = [\"Rock\", \"Soil, in wood\", \"Rock, in wood\"]\n"));
}

TEST(ForestsOverASlope, TheLaterForestAppliesAndAClearingTakesTheMaterialsForestAway) {
  const Model model = model_without_warnings(wooded_slope + ground_of_segments + forest_over(spruce_wood, 20, 90) +
                                             forest_over("name = \"clearing\"\ndensity = \"none\"", 20, 50));
  EXPECT_THAT(material_names(model), testing::ElementsAre("Rock", "Soil", "Rock, in wood", "Soil, in clearing"));
  EXPECT_EQ(model.ground[MaterialId{1}].forest_drag, 250);
  EXPECT_EQ(model.ground[MaterialId{2}].forest_drag, 500);
  EXPECT_FALSE(model.ground[MaterialId{3}].has_forest());
}

// What is laid over the ground leaves it as it is: with sampling per rock, a rock draws the same properties there.
TEST(ForestsOverASlope, ARockHasTheSamePropertiesBelowAForestAsOutside) {
  const std::string head = wooded_slope + "[ground]\ndefault = \"Rock\"\n[sampling]\nmaterials = \"per_rock\"\n";
  const Model with = model_without_warnings(head + forest_over("density = \"none\"", 20, 50));
  EXPECT_THAT(material_names(with), testing::ElementsAre("Rock", "Soil", "Rock, in forest 1"));
  expect_same_trajectories(model_without_warnings(head), with);
}

// A part of the terrain has one byte for its material.
TEST(ForestsOverASlope, MoreForestsOrMaterialsThanAByteHoldsAreRefused) {
  const auto of_forests = [](int count) {
    std::string text = wooded_slope + ground_of_segments;
    for (int k = 0; k < count; ++k) text += forest_over("drag_kg_s = 99\nheight_m = 5", 20, 90);
    return problems_of_model(text);
  };
  EXPECT_EQ(of_forests(255), "");  // the last one lies over all others
  EXPECT_EQ(
      of_forests(256),
      "slope.toml: [[forest]]: there are 256 forests (expected at most 255). Give forests of the same density and "
      "height one entry, with a file of polygons");
}

TEST(ForestsOverASlope, AModelGetsOtherDragsWithoutItsTerrain) {
  EXPECT_TRUE(needs_no_terrain("forest.wood.density"));
  EXPECT_TRUE(needs_no_terrain("forest.0.drag_kg_s"));
  EXPECT_TRUE(needs_no_terrain("forest.0.height_m"));
  EXPECT_FALSE(needs_no_terrain("forest.0.polygon"));
  const std::string dense = replaced(spruce_wood, "medium", "dense");
  Model model = model_without_warnings(wooded_slope + ground_of_segments + forest_over(spruce_wood, 20, 90));
  const std::string text = wooded_slope + ground_of_segments + forest_over(dense, 20, 90);
  set_properties(read_project_text(text, "slope.toml").project, model);
  expect_same_trajectories(model, model_without_warnings(text));
}

#ifdef TALUS_HAS_GDAL

class ForestsOfAFile : public GisProject {
 protected:
  ForestsOfAFile() { make("dem.tif", mountain()); }
  const std::string head = fmt::format(
      "[terrain]\nraster = \"dem.tif\"\n[[material]]\nname = \"Rock\"\n[[seeder]]\nposition = [{}, {}]\n"
      "height_above_m = 1\nmass_kg = 1000\n",
      west + 50, south + 50);
  static std::string stand(const std::string& name, const std::string& more) {
    return fmt::format("[[forest]]\nname = \"{}\"\ndensity = \"open\"\nheight_m = 20\npolygons = \"stands.gpkg\"\n{}",
                       name, more);
  }
};

TEST_F(ForestsOfAFile, CellsBelongToThePolygonsOfTheirValues) {
  layer("stands.gpkg", "kind",
        {{box(0, 0, 100, 200), "spruce"}, {box(100, 0, 200, 200), "beech"}, {box(200, 0, 300, 200), "meadow"}});
  const Model built = model(head + stand("A", "attribute = \"kind\"\nvalues = [\"spruce\"]\n") +
                            stand("B", "attribute = \"kind\"\nvalues = [\"beech\", \"oak\"]\n"));
  EXPECT_EQ(warnings(),
            "slope.toml:16: warning: forest \"B\": values has \"oak\", which no polygon has (in kind of polygons "
            "\"stands.gpkg\")");
  EXPECT_THAT(material_names(built), testing::ElementsAre("Rock", "Rock, in A", "Rock, in B"));
  const auto& grid = std::get<RasterSurface>(*built.surface).grid();
  std::uint32_t number = 0;
  for (std::uint32_t row = 0; row + 1 < grid.rows; ++row) {
    for (std::uint32_t column = 0; column + 1 < grid.columns; ++column, ++number) {
      const double x = cell * (column + 1);
      EXPECT_EQ(built.ground.material_of(number).index, x < 100 ? 1U : x < 200 ? 2U : 0U) << x;
    }
  }
}

TEST_F(ForestsOfAFile, AWrongFileIsReportedAtItsRow) {
  layer("stands.gpkg", "kind", {{box(0, 0, 100, 200), "spruce"}});
  EXPECT_EQ(
      refusal(head + stand("A", "layer = \"woods\"\n") + stand("B", "attribute = \"species\"\nvalues = [\"x\"]\n")),
      "slope.toml:13: forest \"A\": polygons stands.gpkg: has no layer \"woods\" (it has \"layer\")\n"
      "slope.toml:19: forest \"B\": polygons stands.gpkg: layer \"layer\" has no attribute \"species\" (it has "
      "\"kind\")");
}

#endif

}  // namespace
}  // namespace talus::project
