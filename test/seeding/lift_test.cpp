#include "talus/seeding/lift.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/dice.hpp"
#include "talus/terrain/profile.hpp"
#include "talus/terrain/raster_surface.hpp"

namespace talus {
namespace {

using testing_tools::Dice;

template <class Surface>
double distance_from(const Surface& surface, const Vec3& centre) {
  double least = 1e300;
  surface.supports(centre, 100, 0,
                   [&](const Vec3&, const Vec3&, double distance, FacetId) { least = std::min(least, distance); });
  return least;
}

TEST(Lifted, SphereTouchesTheEdgeThatItIsBeside) {
  const Profile ridge(std::vector<Vec2>{{0, 0}, {10, -4}, {20, -16}});
  const auto z = lifted(ridge, {10.45, 0, -4.54}, 1.0);
  ASSERT_TRUE(z);
  EXPECT_NEAR(*z, -4 + std::sqrt(1 - 0.45 * 0.45), 1e-9);
}

TEST(Lifted, SphereOnAPlaneTouchesItsFace) {
  const Profile plane(std::vector<Vec2>{{0, 0}, {100, -75}});
  const auto z = lifted(plane, {40, 0, -30}, 1.0);
  ASSERT_TRUE(z);
  EXPECT_NEAR(*z, -30 + 1.25, 1e-12);
}

// As low as it can be: it touches, and does not overlap.
TEST(Lifted, SphereTouchesRoughGround) {
  Dice dice(41);
  RasterGrid grid;
  grid.columns = grid.rows = 40;
  for (int k = 0; k < 40 * 40; ++k) grid.z.push_back(static_cast<float>(dice.between(0, 2)));
  const RasterSurface ground(grid);
  for (int k = 0; k < 500; ++k) {
    const double x = dice.between(5, 34), y = dice.between(5, 34), radius = dice.between(0.1, 1.5);
    const auto z = lifted(ground, {x, y, *ground.elevation(x, y)}, radius);
    ASSERT_TRUE(z);
    EXPECT_NEAR(distance_from(ground, {x, y, *z}), radius, 2e-9) << k;
  }
}

}  // namespace
}  // namespace talus
