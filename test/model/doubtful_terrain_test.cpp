// Warnings of terrains and releases that are valid but probably wrong.

#include "talus/model/doubtful_terrain.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/dice.hpp"
#include "support/projects.hpp"
#include "talus/model/check_releases.hpp"

namespace talus::project {
namespace {

using testing_tools::model_of;
using testing_tools::problems_of_model;

/// 40 x 40 nodes, 5 m apart, that fall by `fall_m` per cell to the east.
RasterGrid inclined(double fall_m) {
  RasterGrid grid{.columns = 40, .rows = 40, .dx = 5, .dy = 5};
  for (std::uint32_t row = 0; row < grid.rows; ++row) {
    for (std::uint32_t column = 0; column < grid.columns; ++column) {
      grid.z.push_back(static_cast<float>(2000 - fall_m * column));
    }
  }
  return grid;
}

Project project_with(const char* raster, const char* mesh) {
  Project project;
  project.file = "slope.toml";
  project.terrain.raster.file = raster;
  if (*mesh != 0) project.terrain.mesh.files = {mesh};
  return project;
}

std::string warning_of(const RasterGrid& grid) {
  Problems warnings;
  warn_of_steep_raster(grid, project_with("dem.tif", ""), warnings);
  return warnings.text();
}

TEST(DoubtfulRaster, HasElevationsInCentimetres) {
  EXPECT_EQ(warning_of(inclined(3)), "") << "31 degrees";
  EXPECT_EQ(
      warning_of(inclined(300)),
      "slope.toml: warning: [terrain]: \"dem.tif\" is steeper than 89 degrees on half of its area (its elevations seem "
      "not to be in metres; as centimetres they would make 31 degrees). Convert the elevations to metres");
}

TEST(DoubtfulRaster, HasCellsFinerThanItsData) {
  // Cells of 20 m as 4 x 4 of 5 m: nearest neighbour.
  RasterGrid grid{.columns = 160, .rows = 160, .dx = 5, .dy = 5};
  testing_tools::Dice dice(5);
  std::vector<double> coarse;
  for (int k = 0; k < 40 * 40; ++k) coarse.push_back(2000 - 8 * (k % 40) + dice.between(0, 6));
  for (std::uint32_t row = 0; row < 160; ++row) {
    for (std::uint32_t column = 0; column < 160; ++column)
      grid.z.push_back(static_cast<float>(coarse[row / 4 * 40 + column / 4]));
  }
  Problems warnings;
  warn_of_coarse_raster(grid, project_with("dem.tif", ""), warnings);
  EXPECT_EQ(
      warnings.text(),
      "slope.toml: warning: [terrain]: \"dem.tif\" has cells of 5 m, but its elevations seem to be interpolated "
      "from cells of about 20 m (they bend at regular distances; interpolation adds no detail, and bends or steps "
      "that the ground does not have). Use the original cells");
}

TEST(DoubtfulRaster, HasElevationsInSteps) {
  testing_tools::Dice dice(6);
  RasterGrid grid = inclined(3);
  for (float& z : grid.z) z = static_cast<float>(std::round(dice.between(-0.4, 0.4) + static_cast<double>(z) * 0.9));
  const auto warning = [&] {
    Problems warnings;
    warn_of_coarse_raster(grid, project_with("dem.tif", ""), warnings);
    return warnings.text();
  };
  EXPECT_EQ(
      warning(),
      "slope.toml: warning: [terrain]: \"dem.tif\" has elevations in steps of 1 m (with cells of 5 m a step bends "
      "the ground by 11 degrees). Use a file with decimals, or average the elevations over several cells");
  grid.dx = grid.dy = 10;
  EXPECT_EQ(warning(), "") << "6 degrees";
}

TEST(DoubtfulRaster, HasCellsSmallerThanTheRocks) {
  const RasterGrid grid = inclined(3);
  Model model;
  model.surface = RasterSurface(grid);
  model.ground = talus::Ground(talus::Material{});
  talus::Seeder seeder;
  seeder.name = "crest";
  seeder.rocks = 1000;
  seeder.where = Vec3(50, 50, 2000);
  seeder.size_of = SizeOf::diameter;
  seeder.density = Sampler(2700.0);
  const auto warning_for = [&](double diameter) {
    seeder.size = Sampler(diameter);
    model.seeders = {seeder};
    Problems warnings;
    warn_of_rocks_larger_than_cells(model, warnings);
    return warnings.text();
  };
  EXPECT_EQ(warning_for(5), "");
  EXPECT_EQ(warning_for(6.5),
            "warning: seeder \"crest\": rocks of 6.5 m in diameter are larger than the terrain's cells of 5 m (a rock "
            "bridges bumps that are smaller than itself; a point mass or a sphere follows them all). Average the "
            "elevations to cells of 10 m or more, and give smaller bumps as roughness");
}

TEST(DoubtfulRaster, MayHaveACliff) {
  RasterGrid grid = inclined(3);
  for (std::size_t k = 0; k < grid.z.size(); ++k) grid.z[k] += k % 40 < 20 ? 500.F : 0.F;
  EXPECT_EQ(warning_of(grid), "");
  for (float& z : grid.z) z = std::nanf("");
  EXPECT_EQ(warning_of(grid), "");
}

/// A roof of 100 x 60 m on plan with its ridge at 20 m; `up` is the axis of the heights.
RawMesh roof(int up) {
  RawMesh mesh;
  for (const auto& [x, y, z] :
       {std::array{0., 0., 0.}, {100., 0., 0.}, {100., 30., 20.}, {0., 30., 20.}, {100., 60., 0.}, {0., 60., 0.}}) {
    Vec3 v(x, y, z);
    std::swap(v[2], v[up]);
    mesh.vertices.push_back(v);
  }
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {3, 2, 4}, {3, 4, 5}};
  return mesh;
}

std::string warning_of(const RawMesh& mesh) {
  Problems warnings;
  warn_of_steep_mesh(mesh, project_with("", "slope.obj"), warnings);
  return warnings.text();
}

TEST(DoubtfulMesh, LiesOnItsSide) {
  EXPECT_EQ(warning_of(roof(2)), "");
  EXPECT_EQ(warning_of(roof(1)),
            "slope.toml: warning: [terrain]: \"slope.obj\" seems to lie on its side (as a whole it is 90 degrees steep "
            "and faces along y; z points up). If y points up in the file, write up = \"y\" in [terrain]");
  EXPECT_NE(warning_of(roof(0)).find("If x points up in the file, turn it so that z does"), std::string::npos);
}

TEST(DoubtfulMesh, OverhangsOnMuchOfItsArea) {
  Problems warnings;
  CleanMesh flat = clean(roof(2), {.source = "slope.obj"});
  warn_of_overhangs(flat, project_with("", "slope.obj"), warnings);
  EXPECT_EQ(warnings.text(), "");
  // Half of its facets are turned over.
  CleanMesh folded = flat;
  std::swap(folded.triangles[0][0], folded.triangles[0][1]);
  std::swap(folded.triangles[1][0], folded.triangles[1][1]);
  warn_of_overhangs(folded, project_with("", "slope.obj"), warnings);
  EXPECT_EQ(
      warnings.text(),
      "slope.toml: warning: [terrain]: \"slope.obj\" overhangs on much of its area (50 % of the area of its facets "
      "faces downwards; z points up). If y points up in the file, write up = \"y\" in [terrain]");
}

constexpr const char* plane = R"(
[terrain]
section = [[0, 100], [200, 0]]
width_m = 50
[[material]]
name = "Rock"
[[seeder]]
name = "Crest"
mass_kg = 1000
rocks = 10
)";

TEST(DoubtfulReleases, AreFarAboveTheGround) {
  EXPECT_EQ(problems_of_model(plane + std::string("position = [20, 10, 350]\n")), "");
  EXPECT_EQ(problems_of_model(plane + std::string("position = [20, 10, 2090]\n")),
            "warning: seeder \"Crest\": a rock starts 2000 m above the ground (z is an elevation in the coordinate "
            "system of the terrain). Compare z with the terrain; z = \"surface\" starts on the ground, height_above_m "
            "above it");
}

TEST(DoubtfulReleases, AreInTheGround) {
  const auto warning = [](const std::string& where) {
    Problems none, warnings;
    warn_of_buried_releases(model_of(plane + where, none), warnings);
    return warnings.text();
  };
  EXPECT_EQ(warning("position = [20, 10, 91]\n"), "");
  EXPECT_EQ(warning("position = [20, 10, \"surface\"]\n"), "");
  EXPECT_EQ(warning("position = [20, 10, 80]\n"),
            "warning: seeder \"Crest\": 10 of 10 rocks start in the ground (a run lifts them onto the surface, or "
            "lowers them from a ceiling). Compare z with the terrain; z = \"surface\" starts on the ground, "
            "height_above_m above it");
  // Half of a level line is in the ground: five of ten strata.
  EXPECT_EQ(
      warning("type = \"line\"\npoints = [[0, 10, 50], [199, 10, 50]]\n[sampling]\nmethod = \"latin_hypercube\"\n")
          .substr(0, 32),
      "warning: seeder \"Crest\": 5 of 10");
  EXPECT_NE(warning("position = [20, 10, 80]\n[[seeder]]\nname = \"Many\"\nmass_kg = 10\nrocks = 1000000\n"
                    "position = [20, 10, 91]\n")
                .size(),
            0u)
      << "the first of a million is in the sample";
}

TEST(DoubtfulPlaces, HaveTheirCoordinatesSwapped) {
  const auto refused = [](const std::string& more) { return problems_of_model(plane + more); };
  EXPECT_NE(refused("position = [20, 150, \"surface\"]\n").find("With x and y swapped it would lie on the terrain"),
            std::string::npos);
  EXPECT_EQ(refused("position = [300, 150, \"surface\"]\n").find("swapped"), std::string::npos);
  EXPECT_NE(refused("position = [20, 10, \"surface\"]\n[[barrier]]\nheight_m = 3\nline = [[10, 100], [40, 100]]\n")
                .find("With x and y swapped it would lie on the terrain"),
            std::string::npos);
}

TEST(DoubtfulTerrain, IsHigherThanAnySlope) {
  const auto warning_of_size = [](const Vec3& size, const Project& project) {
    Problems warnings;
    warn_of_high_terrain(size, project, warnings);
    return warnings.text();
  };
  EXPECT_EQ(warning_of_size(Vec3(20000, 5000, 9000), project_with("", "slope.obj")), "");
  EXPECT_EQ(
      warning_of_size(Vec3(78000, 30000, 46800), project_with("", "slope.obj")),
      "slope.toml: warning: [terrain]: \"slope.obj\" is 46.8 km high and 78 km wide (no slope is that high, so its "
      "coordinates seem not to be in metres; as millimetres it would be 46.8 m high). Convert the coordinates to "
      "metres");
  Project section = project_with("", "");
  section.terrain.section.file = "profile.csv";
  EXPECT_EQ(warning_of_size(Vec3(40000, 0, 30000), section).substr(0, 71),
            "slope.toml: warning: [terrain]: \"profile.csv\" is 30 km high and 40 km w");
}

}  // namespace
}  // namespace talus::project
