#include "talus/rocks/arc_length.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "support/dice.hpp"

namespace talus::arc_length_test {
namespace {

using testing_tools::Dice;

TEST(ArcLength, OfAStraightPathIsItsChord) {
  EXPECT_EQ(arc_length({{1, 2, 3}, {3, 0, 4}, Vec3{}}, 2), 10);
  EXPECT_EQ(arc_length({{1, 2, 3}, {3, 0, 4}, {0, 0, -9.81}}, 0), 0);
}

// Thrown up at 20 m/s, it turns at 20 m after 2 s and is back after 4 s.
TEST(ArcLength, CountsTheWayUpAndDown) {
  EXPECT_DOUBLE_EQ(arc_length({Vec3{}, {0, 0, 20}, {0, 0, -10}}, 2), 20);
  EXPECT_DOUBLE_EQ(arc_length({Vec3{}, {0, 0, 20}, {0, 0, -10}}, 4), 40);
}

TEST(ArcLength, IsTheSumOfManyChords) {
  Dice dice(3);
  for (int trial = 0; trial < 200; ++trial) {
    const Parabola path{dice.in_cube(100), dice.magnitude(0.01, 40) * dice.direction(), {0, 0, -9.81}};
    const double t = dice.magnitude(1e-3, 10);
    constexpr int parts = 2000;
    double sum = 0;
    for (int k = 0; k < parts; ++k) sum += (path.at(t * (k + 1) / parts) - path.at(t * k / parts)).norm();
    ASSERT_NEAR(arc_length(path, t), sum, 1e-5 * sum) << trial;
  }
}

TEST(TimeAtLength, OnAStraightPath) {
  const Vec3 e = Vec3(1, 2, -2) / 3;
  const Parabola path{Vec3{}, 4 * e, -1.5 * e};
  EXPECT_NEAR(time_at_length(path, 5, 2).value(), 2, 1e-13);
  EXPECT_FALSE(time_at_length(path, 5.001, 2));
  EXPECT_FALSE(time_at_length({Vec3{}, Vec3{}, Vec3{}}, 1, 2));
  const Parabola from_rest{Vec3{}, Vec3{}, 2 * e};
  EXPECT_NEAR(time_at_length(from_rest, 9, std::numeric_limits<double>::infinity()).value(), 3, 1e-13);
}

TEST(TimeAtLength, OnACurvedPath) {
  const Parabola path{Vec3{}, Vec3(5, 0, 0), Vec3(0, 6, 0)};
  EXPECT_NEAR(time_at_length(path, arc_length(path, 0.07), 0.1).value(), 0.07, 1e-12);
}

}  // namespace
}  // namespace talus::arc_length_test
