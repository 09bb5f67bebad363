// Terrains and releases that can be computed with and were probably not meant.

#include "talus/model/doubtful_terrain.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "talus/core/problems.hpp"
#include "talus/model/check_releases.hpp"
#include "talus/model/model.hpp"
#include "talus/project/read.hpp"

namespace talus::project {
namespace {

/// 40 x 40 nodes of 5 m that fall by so much over a cell eastwards.
RasterGrid inclined(double fall_m) {
  RasterGrid grid{.columns = 40, .rows = 40, .dx = 5, .dy = 5};
  for (std::uint32_t row = 0; row < grid.rows; ++row) {
    for (std::uint32_t column = 0; column < grid.columns; ++column) {
      grid.z.push_back(static_cast<float>(2000 - fall_m * column));
    }
  }
  return grid;
}

Project named(const char* raster, const char* mesh) {
  Project project;
  project.file = "slope.toml";
  project.terrain.raster = raster;
  project.terrain.mesh = mesh;
  return project;
}

std::string warned_of(const RasterGrid& grid) {
  Problems warnings;
  warn_of_steep_raster(grid, named("dem.tif", ""), warnings);
  return warnings.text();
}

TEST(DoubtfulRaster, HasElevationsInCentimetres) {
  EXPECT_EQ(warned_of(inclined(3)), "") << "31 degrees";
  EXPECT_EQ(
      warned_of(inclined(300)),
      "slope.toml: warning: [terrain]: \"dem.tif\" is steeper than 89 degrees on half of its area (its elevations "
      "seem not to be in metres; as centimetres they would make 31 degrees). Convert the elevations to metres");
}

TEST(DoubtfulRaster, IsNotOneWithACliff) {
  RasterGrid grid = inclined(3);
  for (std::size_t k = 0; k < grid.z.size(); ++k) grid.z[k] += k % 40 < 20 ? 500.F : 0.F;
  EXPECT_EQ(warned_of(grid), "");
  for (float& z : grid.z) z = std::nanf("");
  EXPECT_EQ(warned_of(grid), "");
}

/// A roof of 100 x 60 m on plan with its ridge 20 m up; `up` is the axis that its heights are on.
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

std::string warned_of(const RawMesh& mesh) {
  Problems warnings;
  warn_of_steep_mesh(mesh, named("", "slope.obj"), warnings);
  return warnings.text();
}

TEST(DoubtfulMesh, LiesOnItsSide) {
  EXPECT_EQ(warned_of(roof(2)), "");
  EXPECT_EQ(
      warned_of(roof(1)),
      "slope.toml: warning: [terrain]: \"slope.obj\" seems to lie on its side (as a whole it is 90 degrees steep and "
      "faces along y). z points up: if y does in this file, exchange y and z");
  EXPECT_NE(warned_of(roof(0)).find("exchange x and z"), std::string::npos);
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

Model model_with(const std::string& more, Problems& warnings) {
  const Reading reading = read_project_text(plane + more, "slope.toml");
  return build_model(reading.project, warnings);
}

TEST(DoubtfulReleases, AreHighAboveTheGround) {
  Problems warnings;
  (void)model_with("position = [20, 10, 350]\n", warnings);
  EXPECT_EQ(warnings.text(), "");
  (void)model_with("position = [20, 10, 2090]\n", warnings);
  EXPECT_EQ(warnings.text(),
            "warning: seeder \"Crest\": a rock starts 2000 m above the ground (z is an elevation in the terrain's own "
            "system). On the ground, z is \"surface\"; above it, give height_above_m");
}

TEST(DoubtfulReleases, AreInTheGround) {
  const auto warned = [](const std::string& where) {
    Problems none, warnings;
    warn_of_buried_releases(model_with(where, none), warnings);
    return warnings.text();
  };
  EXPECT_EQ(warned("position = [20, 10, 91]\n"), "");
  EXPECT_EQ(warned("position = [20, 10, \"surface\"]\n"), "");
  EXPECT_EQ(
      warned("position = [20, 10, 80]\n"),
      "warning: seeders: 10 of 10 rocks are to start in the ground (a run lifts them onto it, or lowers them from a "
      "ceiling). Compare their z with the terrain, or let z be \"surface\"");
  // Half of a line that is level lies in the slope: five of ten strata.
  EXPECT_EQ(warned("type = \"line\"\npoints = [[0, 10, 50], [199, 10, 50]]\n[sampling]\nmethod = \"latin_hypercube\"\n")
                .substr(0, 29),
            "warning: seeders: 5 of 10 roc");
  EXPECT_NE(warned("position = [20, 10, 80]\n[[seeder]]\nname = \"Many\"\nmass_kg = 10\nrocks = 1000000\n"
                   "position = [20, 10, 91]\n")
                .size(),
            0u)
      << "the first of a million is in the sample";
}

TEST(DoubtfulPlaces, HaveTheirCoordinatesExchanged) {
  const auto refused = [](const std::string& more) {
    Problems warnings;
    try {
      (void)model_with(more, warnings);
    } catch (const BadInput& bad) {
      return bad.problems().text();
    }
    return std::string();
  };
  EXPECT_NE(refused("position = [20, 150, \"surface\"]\n").find("With x and y exchanged it would lie on the terrain"),
            std::string::npos);
  EXPECT_EQ(refused("position = [300, 150, \"surface\"]\n").find("exchanged"), std::string::npos);
  EXPECT_NE(refused("position = [20, 10, \"surface\"]\n[[barrier]]\nheight_m = 3\nline = [[10, 100], [40, 100]]\n")
                .find("With x and y exchanged it would lie on the terrain"),
            std::string::npos);
}

}  // namespace
}  // namespace talus::project
