#include "talus/results/runout_frame.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/dice.hpp"

namespace talus::runout_frame_test {
namespace {

using testing_tools::Dice;

TEST(RunoutFrame, IsTheReleaseUnlessOneIsChosen) {
  const RunoutFrame frame;
  EXPECT_TRUE(frame.is_from_release());
  EXPECT_DOUBLE_EQ(frame.of({1, 1}, {4, 5}).runout, 5);
  EXPECT_FALSE(frame.of({1, 1}, {4, 5}).lateral);
}

TEST(RunoutFrame, FromAPointIsTheDistanceFromIt) {
  const RunoutFrame frame = RunoutFrame::from({4, 0});
  EXPECT_FALSE(frame.is_from_release());
  EXPECT_DOUBLE_EQ(frame.of({1, 1}, {1, 4}).runout, 5);
  EXPECT_FALSE(frame.of({1, 1}, {1, 4}).lateral);
}

void expect_place(const RunoutFrame& frame, const Vec2& place, double runout, double lateral) {
  const RunoutPlace found = frame.of({0, 0}, place);
  EXPECT_NEAR(found.runout, runout, 1e-12) << place;
  ASSERT_TRUE(found.lateral);
  EXPECT_NEAR(*found.lateral, lateral, 1e-12) << place;
}

TEST(RunoutFrame, AlongALineIsTheChainageOfTheNearestPoint) {
  const RunoutFrame frame = RunoutFrame::along({{0, 0}, {10, 0}, {10, 10}});
  expect_place(frame, {3, 2}, 3, 2);  // left
  expect_place(frame, {3, -2}, 3, -2);
  expect_place(frame, {9, 6}, 16, 1);
  expect_place(frame, {13, -4}, 10, -5);  // outside the bend: its corner is nearest
  // The line goes on beyond its ends.
  expect_place(frame, {-4, 1}, -4, 1);
  expect_place(frame, {12, 15}, 25, -2);
}

// Inside a sharp bend the corner is nearest on both segments, which say different things about the side.
TEST(RunoutFrame, KnowsTheSideBehindASharpBend) {
  const RunoutFrame frame = RunoutFrame::along({{0, 0}, {10, 0}, {0, 1}});
  expect_place(frame, {12, 0.05}, 10, -std::hypot(2, 0.05));
  expect_place(frame, {12, 0.4}, 10, -std::hypot(2, 0.4));
}

// On a circle of many chords, runout is the angle times the radius, and lateral the distance from the circle.
TEST(RunoutFrame, ConvergesToACircle) {
  constexpr double radius = 100;
  constexpr int chords = 3600;
  std::vector<Vec2> circle;
  for (int k = 0; k <= chords / 2; ++k) {
    const double angle = 2 * std::numbers::pi * k / chords;
    circle.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  const RunoutFrame frame = RunoutFrame::along(circle);
  Dice dice(5);
  for (int i = 0; i < 200; ++i) {
    const double angle = dice.between(0.01, 3.1), r = dice.between(60, 140);
    const RunoutPlace place = frame.of({0, 0}, {r * std::cos(angle), r * std::sin(angle)});
    EXPECT_NEAR(place.runout, radius * angle, 0.2);
    EXPECT_NEAR(*place.lateral, radius - r, 0.001);  // its centre is on the left
  }
}

TEST(RunoutFrame, DoesNotChangeWhenEverythingIsMovedAndTurned) {
  Dice dice(9);
  const auto moved = [](const Vec2& p) {
    return Vec2(2.6e6 + 0.28 * p.x() - 0.96 * p.y(), 0.96 * p.x() + 0.28 * p.y());
  };
  std::vector<Vec2> line, moved_line;
  for (int k = 0; k < 8; ++k) {
    line.emplace_back(20 * k, dice.between(-10, 10));
    moved_line.push_back(moved(line.back()));
  }
  const RunoutFrame frame = RunoutFrame::along(line), other = RunoutFrame::along(moved_line);
  for (int i = 0; i < 100; ++i) {
    const Vec2 p(dice.between(-20, 170), dice.between(-30, 30));
    const RunoutPlace a = frame.of({0, 0}, p), b = other.of({0, 0}, moved(p));
    EXPECT_NEAR(a.runout, b.runout, 1e-6);
    EXPECT_NEAR(*a.lateral, *b.lateral, 1e-6);
  }
}

}  // namespace
}  // namespace talus::runout_frame_test
