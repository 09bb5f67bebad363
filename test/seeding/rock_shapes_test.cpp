// Shapes drawn for rocks: axes, shares and orientations against what was asked for.

#include "talus/seeding/rock_shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace talus {
namespace {

/// The corners of a cube, to be stretched.
RockShape cube() {
  RockShape shape;
  for (const double x : {-0.5, 0.5}) {
    for (const double y : {-0.5, 0.5}) {
      for (const double z : {-0.5, 0.5}) shape.corners.push_back({x, y, z});
    }
  }
  // Numbered x y z: 000, 001, 010, 011, 100, ...; counter-clockwise from outside.
  shape.triangles = {{0, 1, 3}, {0, 3, 2}, {4, 6, 7}, {4, 7, 5}, {0, 4, 5}, {0, 5, 1},
                     {2, 3, 7}, {2, 7, 6}, {0, 2, 6}, {0, 6, 4}, {1, 5, 7}, {1, 7, 3}};
  return shape;
}

Draws draws_of(std::uint64_t rock) { return {SamplingPlan{.seed = 5, .count = 100'000}, rock}; }

RockShapes boxes(double b_over_a, double c_over_b) {
  return {{{.hulls = {cube()}, .stretch = AxisRatios{Sampler(b_over_a), Sampler(c_over_b)}}}};
}

TEST(RockShapes, StretchesToTheRatios) {
  RockShape own;
  const RockShape* const drawn = boxes(0.5, 0.8).draw(draws_of(0), {}, own);
  ASSERT_EQ(drawn, &own);
  // A box of 1 : 0.5 : 0.4, of a volume of 1 m3.
  const double a = 1 / std::cbrt(0.2), b = 0.5 * a, c = 0.4 * a;
  EXPECT_NEAR(own.gyration[0], (b * b + c * c) / 12, 1e-12);
  EXPECT_NEAR(own.gyration[1], (a * a + c * c) / 12, 1e-12);
  EXPECT_NEAR(own.gyration[2], (a * a + b * b) / 12, 1e-12);
  EXPECT_NEAR(own.reach, 0.5 * std::sqrt(a * a + b * b + c * c), 1e-12);
}

TEST(RockShapes, GivenAxesReplaceDrawnRatios) {
  RockShape own, given;
  static_cast<void>(boxes(0.5, 0.8).draw(draws_of(0), {}, own));
  static_cast<void>(boxes(0.9, 0.9).draw(draws_of(1), Vec3(3, 1.5, 1.2), given));
  for (std::size_t i = 0; i < own.corners.size(); ++i) EXPECT_LT((own.corners[i] - given.corners[i]).norm(), 1e-12);
}

TEST(RockShapes, SharesAreThoseOfTheRocks) {
  RockShapes shapes = boxes(0.5, 0.5);
  shapes.kinds.front().share = 0.3;
  shapes.kinds.push_back({.share = 0.7});  // spheres
  int spheres = 0;
  constexpr int rocks = 4000;
  RockShape own;
  for (std::uint64_t rock = 0; rock < rocks; ++rock) spheres += shapes.draw(draws_of(rock), {}, own) == nullptr;
  EXPECT_NEAR(spheres, 0.7 * rocks, 4 * std::sqrt(rocks * 0.3 * 0.7));
}

// Of orientations that are all equally likely, the image of every axis has mean 0 and the second moments of the sphere.
TEST(ReleaseTurn, EveryOrientationIsEquallyLikely) {
  const RockShape shape = cube();
  constexpr int rocks = 20'000;
  for (const Vec3& axis : {unit_x, unit_y, unit_z}) {
    Vec3 mean, squares;
    double mixed = 0;
    for (std::uint64_t rock = 0; rock < rocks; ++rock) {
      const Vec3 image = ReleaseTurn{}.draw(draws_of(rock), shape).to_world(axis);
      mean += image / rocks;
      squares += image.times(image) / rocks;
      mixed += image.x() * image.y() / rocks;
    }
    const double error = 4 / std::sqrt(3.0 * rocks);
    EXPECT_LT(mean.abs().largest(), error);
    EXPECT_LT((squares - Vec3::all(1.0 / 3)).abs().largest(), error);
    EXPECT_LT(std::abs(mixed), error);
  }
}

TEST(ReleaseTurn, InASectionTurnsAboutYOnly) {
  const RockShape shape = cube();
  double mean = 0;
  constexpr int rocks = 4000;
  for (std::uint64_t rock = 0; rock < rocks; ++rock) {
    const Orientation turn = ReleaseTurn{InitialTurn::in_section, {}}.draw(draws_of(rock), shape);
    EXPECT_LT((turn.to_world(unit_y) - unit_y).norm(), 1e-15);
    mean += turn.to_world(unit_x).x() / rocks;
  }
  EXPECT_LT(std::abs(mean), 4 / std::sqrt(2.0 * rocks));
}

TEST(ReleaseTurn, GivenIsThatOfTheShapeAsItWasGiven) {
  RockShape shape = cube();
  shape.as_given = Orientation::of_turn(0.3 * unit_x);
  const Orientation asked = Orientation::of_turn(1.1 * unit_z);
  const Orientation turn = ReleaseTurn{InitialTurn::given, asked}.draw(draws_of(0), shape);
  const Vec3 in_body(0.1, 0.2, 0.3);
  EXPECT_LT((turn.to_world(in_body) - asked.to_world(shape.as_given.to_world(in_body))).norm(), 1e-15);
}

}  // namespace
}  // namespace talus
