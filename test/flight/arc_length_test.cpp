#include "talus/flight/arc_length.hpp"

#include <gtest/gtest.h>

#include "support/dice.hpp"

namespace talus {
namespace {

using testing_tools::Dice;

TEST(ArcLength, OfAStraightPathIsItsChord) {
  EXPECT_EQ(arc_length({{1, 2, 3}, {3, 0, 4}, Vec3::Zero()}, 2), 10);
  EXPECT_EQ(arc_length({{1, 2, 3}, {3, 0, 4}, {0, 0, -9.81}}, 0), 0);
}

// Thrown up at 20 m/s, it turns at 20 m after 2 s and is back after 4 s.
TEST(ArcLength, CountsTheWayUpAndDown) {
  EXPECT_DOUBLE_EQ(arc_length({Vec3::Zero(), {0, 0, 20}, {0, 0, -10}}, 2), 20);
  EXPECT_DOUBLE_EQ(arc_length({Vec3::Zero(), {0, 0, 20}, {0, 0, -10}}, 4), 40);
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

}  // namespace
}  // namespace talus
