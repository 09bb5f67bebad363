// Volumes and moments of hulls against closed forms, and what is made of them.

#include "talus/meshing/rock_shape.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "support/dice.hpp"
#include "talus/core/orientation.hpp"
#include "talus/core/problems.hpp"
#include "talus/meshing/rock_hull.hpp"

namespace talus::rock_shape_test {
namespace {

using namespace testing_tools;

void expect_near(const Vec3& value, const Vec3& expected, double tolerance = 1e-12) {
  EXPECT_LT((value - expected).abs().largest(), tolerance) << value << " expected " << expected;
}

double volume_of(const RockShape& shape) {
  double volume = 0;
  for (const auto& [a, b, c] : shape.triangles) {
    volume += shape.corners[a].dot(shape.corners[b].cross(shape.corners[c])) / 6;
  }
  return volume;
}

// Moments over mass of solids with edge 1, and their volumes.
TEST(RockShape, RegularSolidsHaveTheKnownMoments) {
  const double phi = std::numbers::phi;
  struct Known {
    RegularSolid solid;
    std::size_t corners, triangles;
    double moment, volume;
  };
  for (const Known& known :
       {Known{RegularSolid::tetrahedron, 4, 4, 1.0 / 20, std::sqrt(2.0) / 12},
        Known{RegularSolid::cube, 8, 12, 1.0 / 6, 1},
        Known{RegularSolid::octahedron, 6, 8, 1.0 / 10, std::sqrt(2.0) / 3},
        Known{RegularSolid::dodecahedron, 20, 36, (39 * phi + 28) / 150, (15 + 7 * std::sqrt(5.0)) / 4},
        Known{RegularSolid::icosahedron, 12, 20, phi * phi / 10, 5 * (3 + std::sqrt(5.0)) / 12}}) {
    const RockShape shape = regular_shape(known.solid);
    EXPECT_EQ(shape.corners.size(), known.corners);
    EXPECT_EQ(shape.triangles.size(), known.triangles);
    EXPECT_NEAR(volume_of(shape), 1, 1e-12);
    expect_near(shape.gyration, Vec3::all(known.moment / std::pow(known.volume, 2.0 / 3)));
  }
}

TEST(RockShape, BoxesAndPrismsHaveTheirMoments) {
  const RockShape box = box_shape({1, 3, 2});
  // The longest edge is along x.
  expect_near(box.gyration, Vec3{1 + 4, 9 + 1, 9 + 4} / 12 / std::pow(6, 2.0 / 3));
  EXPECT_NEAR(box.reach, 0.5 * std::sqrt(14) / std::cbrt(6), 1e-12);

  const double a = std::numbers::pi / 6, volume = 6 * std::sin(2 * a) / 2 * 4;
  const double area = 6 * std::sin(2 * a) / 2;  // of a hexagon of radius 1
  const RockShape hexagon = prism_shape(regular_outline(6), 4 / std::sqrt(area));
  const double along = (2 + std::cos(2 * a)) / 6, across = along / 2 + 16.0 / 12;
  expect_near(hexagon.gyration, Vec3{along, across, across} / std::pow(volume, 2.0 / 3));
}

TEST(RockShape, ManyCornersComeNearToTheEllipsoid) {
  const Vec3 half(0.6, 0.45, 0.3);
  const RockShape shape = ellipsoid_shape(2 * half, 4000);
  const Vec3 q = half.times(half) / std::pow(4 * std::numbers::pi / 3 * half[0] * half[1] * half[2], 2.0 / 3);
  expect_near(shape.gyration, Vec3{q[1] + q[2], q[0] + q[2], q[0] + q[1]} / 5, 1e-3);
}

// The same body, wherever it lies, however it is turned, whatever its unit.
TEST(RockShape, DoesNotDependOnPlaceTurnOrUnit) {
  Dice dice(1);
  std::vector<Vec3> points;
  for (int i = 0; i < 60; ++i) points.push_back(dice.direction().times({1, 0.7, 0.4}));
  const Hull hull = hull_of(points);
  for (const double unit : {1e-3, 1.0, 1e3}) {
    const Orientation turn = Orientation::of_turn(2 * dice.direction());
    std::vector<Vec3> moved;
    for (const Vec3& p : points) moved.push_back(unit * turn.to_world(p) + unit * Vec3(300, -200, 50));
    const Hull again = hull_of(moved);
    EXPECT_NEAR(again.volume, unit * unit * unit * hull.volume, 1e-9 * again.volume);
    expect_near(again.shape.gyration, hull.shape.gyration, 1e-9);
    EXPECT_NEAR(again.shape.reach, hull.shape.reach, 1e-9);
  }
}

TEST(RockShape, LeavesOutPointsWithin) {
  std::vector<Vec3> points{{0, 0, 0}};
  for (const Vec3& corner : box_shape({1, 1, 1}).corners) points.push_back(corner);
  points.push_back({0.5, 0.1, 0.2});  // on a face
  EXPECT_EQ(hull_of(points).shape.corners.size(), 8U);
}

// A section has the moment of the prism that is as long as the root of its area: of a square, the cube's.
TEST(RockShape, SectionsHaveTheMomentOfTheirPrism) {
  const RockShape square = section_shape(regular_outline(4));
  EXPECT_EQ(square.corners.size(), 4U);
  EXPECT_NEAR(square.gyration.y(), 1.0 / 6, 1e-12);
  EXPECT_NEAR(square.reach, std::sqrt(0.5), 1e-12);
  for (const Vec3& corner : square.corners) {
    EXPECT_EQ(corner.y(), 0);
    EXPECT_NEAR(std::abs(corner.z()), 0.5, 1e-12) << "the first side is below";
  }
  // A rectangle of 1 by 3, longer than its prism and shorter: (a^2 + b^2) / 12 about y, of an area of 1.
  EXPECT_NEAR(section_shape(rectangle_outline(1.0 / 3)).gyration.y(), (3 + 1.0 / 3) / 12, 1e-12);
  // An ellipse of area 1 with b/a = 1/2: (a^2 + b^2) / 4, with pi a b = 1.
  const double a = std::sqrt(2 / std::numbers::pi), b = a / 2;
  EXPECT_NEAR(section_shape(superellipse_outline(0.5, 2)).gyration.y(), (a * a + b * b) / 4, 1e-3);
}

TEST(RockShape, SuperEllipsesLieOnTheirCurve) {
  for (const double power : {1.5, 2.0, 4.0, 8.0, 20.0}) {
    for (const Vec2& p : superellipse_outline(0.6, power)) {
      EXPECT_NEAR(std::pow(std::abs(p.x()), power) + std::pow(std::abs(p.y()) / 0.6, power), 1, 1e-12) << power;
    }
  }
}

TEST(RockShape, IcospheresHaveTheirTriangles) {
  EXPECT_EQ(icosphere_shape(RegularSolid::octahedron).triangles.size(), 32U);
  EXPECT_EQ(icosphere_shape(RegularSolid::icosahedron).triangles.size(), 80U);
}

TEST(RockShape, TurnsBackToTheFrameInWhichItWasGiven) {
  Dice dice(3);
  std::vector<Vec3> points;
  for (int i = 0; i < 20; ++i) points.push_back(dice.direction().times({1, 0.6, 0.4}));
  const Hull hull = hull_of(points);
  const double scale = std::cbrt(hull.volume);
  for (std::size_t i = 0; i + 1 < hull.shape.corners.size(); ++i) {
    const Vec3 between = scale * hull.shape.as_given.to_world(hull.shape.corners[i + 1] - hull.shape.corners[i]);
    const bool is_found = std::ranges::any_of(points, [&](const Vec3& p) {
      return std::ranges::any_of(points, [&](const Vec3& q) { return (q - p - between).norm() < 1e-9; });
    });
    EXPECT_TRUE(is_found) << i;
  }
}

// Of a smooth body of a thousand points, 48 keep nearly all of the volume and the moments.
TEST(RockShape, ThinnedHullsKeepTheBody) {
  Dice dice(4);
  std::vector<Vec3> points;
  for (int i = 0; i < 1000; ++i) points.push_back(dice.direction().times({1, 0.8, 0.5}));
  const Hull whole = hull_of(points), thinned = thinned_hull_of(points, 48);
  EXPECT_EQ(thinned.shape.corners.size(), 48U);
  EXPECT_GT(thinned.volume, 0.85 * whole.volume);
  EXPECT_LT(thinned.volume, whole.volume);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(thinned.shape.gyration[k] / whole.shape.gyration[k], 1, 0.05);
  EXPECT_EQ(thinned_hull_of(box_shape({1, 2, 3}).corners, 48).shape.corners.size(), 8U);
}

TEST(RockShape, IrregularBallsDifferAndAreTheSameEveryTime) {
  const auto balls = irregular_balls(24), again = irregular_balls(24);
  ASSERT_EQ(balls.size(), again.size());
  for (std::size_t i = 0; i < balls.size(); ++i) {
    EXPECT_EQ(balls[i].corners, again[i].corners);
    EXPECT_EQ(balls[i].corners.size(), 24U);
    EXPECT_NEAR(volume_of(balls[i]), 1, 1e-12);
    EXPECT_TRUE(i == 0 || balls[i].corners != balls[0].corners);
  }
}

std::string refusal(const std::vector<Vec3>& points) {
  try {
    (void)hull_of(points);
  } catch (const BadInput& bad) {
    return bad.what();
  }
  return "accepted";
}

TEST(RockShape, RefusesWhatHasNoVolume) {
  EXPECT_EQ(refusal({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), "it has 3 points (a hull has four or more)");
  EXPECT_EQ(refusal({{1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {1, 2, 3}}),
            "all its points are one (a hull has a volume)");
  EXPECT_EQ(refusal({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}),
            "its points lie in a plane (a hull has a volume)");
  EXPECT_EQ(refusal({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, std::numeric_limits<double>::quiet_NaN()}}),
            "point 4 is not a number");
  EXPECT_THAT(refusal({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1e-4}}), testing::HasSubstr("as thick as long"));
}

}  // namespace
}  // namespace talus::rock_shape_test
