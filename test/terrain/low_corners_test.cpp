// The corners of a body over a mesh, against its elevations.

#include <gtest/gtest.h>

#include <limits>
#include <optional>
#include <vector>

#include "support/dice.hpp"
#include "support/meshes.hpp"
#include "talus/rocks/shape.hpp"
#include "talus/terrain/triangle_mesh.hpp"

namespace talus::low_corners_test {
namespace {

using namespace testing_tools;

constexpr double infinite = std::numeric_limits<double>::infinity();

std::vector<std::optional<double>> gaps(const TriangleMesh& mesh, const Posture& body, double bound) {
  std::vector<std::optional<double>> gaps(body.corners.size());
  mesh.visit_low_corners(body, bound, [&](std::size_t corner, double gap) {
    EXPECT_FALSE(gaps[corner]);
    gaps[corner] = gap;
    return bound;
  });
  return gaps;
}

// Bodies from much smaller to much larger than triangles, also over the rim of the mesh.
TEST(LowCorners, OfABodyOverAMeshAreAtItsElevations) {
  Dice dice(3);
  int left_out = 0, off_terrain = 0;
  for (int i = 0; i < 300; ++i) {
    const TriangleMesh mesh = random_slope(dice, 16, 60, 0.7, 0.6).mesh();
    std::vector<Vec3> corners;
    for (int k = 0; k < 12; ++k) corners.push_back(dice.direction());
    Posture body{corners, {}, {}, dice.between(0.1, i % 3 == 0 ? 20 : 3)};
    body.turned = body.reach * Orientation::of_turn(dice.between(0, 3) * dice.direction()).matrix();
    const double x = dice.between(0, 60), y = dice.between(0, 60);
    body.centre = {x, y, mesh.elevation(x, y).value_or(0) + dice.between(-1, 1) * body.reach};
    const auto all = gaps(mesh, body, infinite), low = gaps(mesh, body, 0.1);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Vec3 place = body.place(k);
      const auto ground = mesh.elevation(place.x(), place.y());
      const double gap = ground ? place.z() - *ground : infinite;
      ASSERT_TRUE(all[k]);
      EXPECT_EQ(*all[k], gap);
      if (low[k]) {
        EXPECT_EQ(*low[k], gap);
      } else {
        EXPECT_GT(gap, 0.1);
        ++left_out;
      }
      off_terrain += !ground;
    }
  }
  EXPECT_GT(left_out, 500);
  EXPECT_GT(off_terrain, 30);
}

TEST(LowCorners, NoFacetIsSteeperThanTheSlant) {
  Dice dice(4);
  const TriangleMesh mesh = random_slope(dice, 16, 60, 0.7, 0.6).mesh();
  double slant = 0;
  for (std::uint32_t k = 0; k < mesh.facet_count(); ++k) slant = std::max(slant, 1 / mesh.normal(FacetId{k}).z());
  EXPECT_EQ(mesh.slant(), slant);
}

}  // namespace
}  // namespace talus::low_corners_test
