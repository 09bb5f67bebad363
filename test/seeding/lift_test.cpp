#include "talus/seeding/lift.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/dice.hpp"
#include "support/meshes.hpp"
#include "talus/meshing/rock_shape.hpp"
#include "talus/rocks/separation.hpp"
#include "talus/terrain/profile.hpp"
#include "talus/terrain/raster_surface.hpp"

namespace talus::lift_test {
namespace {

using testing_tools::Dice;

template <class Surface>
double distance_from(const Surface& surface, const Vec3& centre) {
  double least = 1e300;
  surface.supports(centre, 100, 0,
                   [&](const Vec3&, const Vec3&, double distance, FacetId) { least = std::min(least, distance); });
  return least;
}

TEST(Lifted, SphereTouchesTheEdgeNextToIt) {
  const Profile ridge(std::vector<Vec2>{{0, 0}, {10, -4}, {20, -16}});
  const ClearPlace start = clear_place(ridge, {10.45, 0, -4.54}, 1.0);
  EXPECT_EQ(start.fit, Fit::moved);
  EXPECT_NEAR(start.z, -4 + std::sqrt(1 - 0.45 * 0.45), 1e-9);
}

TEST(Lifted, SphereOnAPlaneTouchesItsFace) {
  const Profile plane(std::vector<Vec2>{{0, 0}, {100, -75}});
  const ClearPlace start = clear_place(plane, {40, 0, -30}, 1.0);
  EXPECT_EQ(start.fit, Fit::moved);
  EXPECT_NEAR(start.z, -30 + 1.25, 1e-12);
}

// As low as possible: it touches without overlap.
TEST(Lifted, SphereTouchesRoughGround) {
  Dice dice(41);
  RasterGrid grid;
  grid.columns = grid.rows = 40;
  for (int k = 0; k < 40 * 40; ++k) grid.z.push_back(static_cast<float>(dice.between(0, 2)));
  const RasterSurface ground(grid);
  for (int k = 0; k < 500; ++k) {
    const double x = dice.between(5, 34), y = dice.between(5, 34), radius = dice.between(0.1, 1.5);
    const ClearPlace start = clear_place(ground, {x, y, *ground.elevation(x, y)}, radius);
    EXPECT_EQ(start.fit, Fit::moved);
    EXPECT_NEAR(distance_from(ground, {x, y, start.z}), radius, 2e-9) << k;
  }
}

// ---- rocks with a shape ----

const RockShape cube{{{-0.5, -0.5, -0.5},
                      {-0.5, -0.5, 0.5},
                      {-0.5, 0.5, -0.5},
                      {-0.5, 0.5, 0.5},
                      {0.5, -0.5, -0.5},
                      {0.5, -0.5, 0.5},
                      {0.5, 0.5, -0.5},
                      {0.5, 0.5, 0.5}},
                     {},
                     Vec3::all(1.0 / 6),
                     std::sqrt(0.75)};

double lowest_over(const RasterSurface& ground, const Posture& body) {
  double least = 1e300;
  for (std::size_t i = 0; i < body.corners.size(); ++i) {
    const Vec3 place = body.place(i);
    least = std::min(least, place.z() - *ground.elevation(place.x(), place.y()));
  }
  return least;
}

TEST(Lifted, ACornerOfABodyTouchesTheGround) {
  Dice dice(43);
  RasterGrid grid;
  grid.columns = grid.rows = 40;
  for (int k = 0; k < 40 * 40; ++k) grid.z.push_back(static_cast<float>(dice.between(0, 2)));
  const RasterSurface ground(grid);
  int moved = 0;
  for (int k = 0; k < 500; ++k) {
    const double x = dice.between(5, 34), y = dice.between(5, 34);
    const Body body = body_of(cube, sphere_of_diameter(dice.between(0.2, 3), 2700));
    const Orientation orientation = Orientation::of_turn(dice.between(0, 3) * dice.direction());
    const Vec3 place{x, y, *ground.elevation(x, y) + dice.between(-1, 2)};
    const double before = lowest_over(ground, body.at(place, orientation.matrix()));
    const ClearPlace start = clear_place(ground, place, body, orientation);
    if (before >= 0) {
      EXPECT_EQ(start.fit, Fit::as_given) << k;
      EXPECT_EQ(start.z, place.z()) << k;
      continue;
    }
    ++moved;
    EXPECT_EQ(start.fit, Fit::moved) << k;
    EXPECT_NEAR(lowest_over(ground, body.at({x, y, start.z}, orientation.matrix())), 0, 2e-9) << k;
  }
  EXPECT_GT(moved, 100);
}

// Over ground finer than their faces blocks are raised until they are clear of all facets, and no higher.
TEST(Lifted, ABlockTouchesGroundFinerThanItsFaces) {
  Dice dice(44);
  RasterGrid grid;
  grid.columns = grid.rows = 60;
  grid.dx = grid.dy = 0.25;
  for (int k = 0; k < 60 * 60; ++k) grid.z.push_back(static_cast<float>(dice.between(0, 0.4)));
  const RasterSurface ground(grid);
  const RockShape block = box_shape({1, 0.8, 0.5});
  const auto is_clear = [&](const Posture& body) {
    bool is_clear = true;
    ground.supports(body.centre, body.reach, 0, [&](const Vec3&, const Vec3&, double, FacetId facet) {
      const Triangle corner = ground.triangle(facet);
      is_clear = is_clear && separation(body, corner);
    });
    return is_clear;
  };
  for (int k = 0; k < 300; ++k) {
    const double x = dice.between(4, 10), y = dice.between(4, 10);
    const Body body = body_of(block, sphere_of_diameter(dice.between(0.5, 2), 2700));
    const Orientation orientation = Orientation::of_turn(dice.between(0, 3) * dice.direction());
    const ClearPlace start = clear_place(ground, {x, y, *ground.elevation(x, y) - 0.2}, body, orientation);
    EXPECT_EQ(start.fit, Fit::moved) << k;
    EXPECT_TRUE(is_clear(body.at({x, y, start.z + 1e-6}, orientation.matrix()))) << k;
    EXPECT_FALSE(is_clear(body.at({x, y, start.z - 1e-5}, orientation.matrix()))) << k;
  }
}

TEST(Lifted, AFlatBlockIsRaisedByHalfItsThickness) {
  const Profile level(std::vector<Vec2>{{0, 0}, {100, 0}});
  RockShape slab = cube;
  for (Vec3& corner : slab.corners) corner = corner.times({2, 2, 0.25});
  const Body body = body_of(slab, sphere_of_mass(2700, 2700));
  EXPECT_NEAR(clear_place(level, {50, 0, 0}, body, {}).z, 0.125, 1e-9);
  const Orientation upright = Orientation::of_turn({0, std::acos(0.0), 0});
  EXPECT_NEAR(clear_place(level, {50, 0, 0}, body, upright).z, 1, 1e-9);
}

// ---- under a ceiling ----

// A cave over a floor that falls from z = 10 to 8; its roof bulges down to (4, 14.6) under solid rock up to z = 20.
const std::vector<Vec2> cave{{0, 20}, {10, 20}, {4, 14.6}, {2, 15}, {2, 10}, {30, 8}};

template <class Surface>
void expect_lowered_from_the_bulge(const Surface& surface, double y) {
  for (const double z : {14.4, 14.5, 14.59}) {
    const ClearPlace start = clear_place(surface, {4, y, z}, 0.25);
    EXPECT_EQ(start.fit, Fit::moved);
    EXPECT_NEAR(start.z, 14.35, 1e-8) << z;
  }
  EXPECT_EQ(clear_place(surface, {4, y, 14.3}, 0.25).fit, Fit::as_given);
}

TEST(UnderACeiling, ASphereIsLoweredUntilItTouches) {
  Dice dice(42);
  expect_lowered_from_the_bulge(Profile(cave), 0);
  expect_lowered_from_the_bulge(testing_tools::extruded(cave, 20, 5, dice).mesh(), 10.3);
}

TEST(UnderACeiling, ASphereThatIsTooBigForTheCaveIsNotMovedIntoTheRock) {
  const Profile surface(cave);
  const double floor = *surface.elevation(4, 0, 12);
  for (const double z : {12.0, 14.5, floor, floor - 1}) {
    const ClearPlace start = clear_place(surface, {4, 0, z}, 2.5);
    EXPECT_EQ(start.fit, Fit::no_room) << z;
    EXPECT_DOUBLE_EQ(start.z, std::max(z, floor));
  }
}

// From under the floor it is lifted into the cave, even if that is hardly high enough, not onto the cliff.
TEST(UnderACeiling, ASphereIsLiftedOntoTheFloor) {
  const Profile surface(cave);
  for (const double radius : {0.1, 1.0, 1.9}) {
    const ClearPlace start = clear_place(surface, {4, 0, 9}, radius);
    EXPECT_EQ(start.fit, Fit::moved);
    EXPECT_LT(start.z, 14.6);
    EXPECT_GE(distance_from(surface, {4, 0, start.z}), radius - 2e-9);
  }
}

template <class Surface>
void expect_none_in_the_rock(const Surface& surface, double y, Dice& dice) {
  int moved = 0, caught = 0;
  for (int k = 0; k < 3000; ++k) {
    const Vec3 place(dice.between(5, 15), y, dice.between(-1, 10));
    const double radius = dice.magnitude(0.05, 2);
    const Vec3 open(place.x(), y, surface.ground_over(place).value_or(place.z()));
    const ClearPlace start = clear_place(surface, place, radius);
    const Vec3 centre(place.x(), y, start.z);
    // It has the same ground below it as before.
    ASSERT_EQ(surface.elevation(centre.x(), y, centre.z() + 1e-9), surface.elevation(open.x(), y, open.z() + 1e-9));
    if (start.fit == Fit::no_room) {
      EXPECT_EQ(start.z, open.z());
      ++caught;
    } else {
      ASSERT_GE(distance_from(surface, centre), radius - 2e-9) << place << " r " << radius;
      moved += start.z < open.z() ? 1 : 0;
    }
  }
  EXPECT_GT(moved, 10);
  EXPECT_GT(caught, 20);
}

TEST(UnderACeiling, NoSphereIsMovedThroughIt) {
  Dice dice(43);
  const std::vector<Vec2> folded{{0, 10}, {8, 9}, {7, 5}, {6, 4.5}, {14, 3}, {13, 0}, {20, -1}, {20, -4}, {40, -5}};
  expect_none_in_the_rock(Profile(folded), 0, dice);
  expect_none_in_the_rock(testing_tools::extruded(folded, 20, 5, dice).mesh(), 10.3, dice);
}

}  // namespace
}  // namespace talus::lift_test
