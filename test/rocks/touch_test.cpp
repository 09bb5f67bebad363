#include "talus/rocks/touch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/dice.hpp"

namespace talus::touch_test {
namespace {

using testing_tools::Dice;

// ---- planes ----

TEST(FallingRoot, OfAFallFromRest) {
  const auto t = falling_root(5, 0, -10, 0);
  ASSERT_TRUE(t);
  EXPECT_DOUBLE_EQ(*t, 1);
}

TEST(FallingRoot, IsTheLaterRootOfARisingRock) {
  const auto t = falling_root(0, 5, -10, 0);  // launched up from the plane: it leaves, and returns after a second
  ASSERT_TRUE(t);
  EXPECT_DOUBLE_EQ(*t, 1);
}

TEST(FallingRoot, DoesNotExistForARockThatNeverFallsBack) {
  EXPECT_FALSE(falling_root(1, 1, 0, 0));
  EXPECT_FALSE(falling_root(1, 0, 0, 0));
  EXPECT_FALSE(falling_root(1, -1, 2, 0));  // pulled away, it turns above the plane
  EXPECT_FALSE(falling_root(0, 1, 1, 0));
  EXPECT_FALSE(falling_root(0, 0, 1, 0));
}

TEST(FallingRoot, IsZeroAtTheSurfaceOnlyIfTheRockMovesIn) {
  EXPECT_EQ(falling_root(0, -1, 0, 0), 0.0);
  EXPECT_EQ(falling_root(0, 0, -1, 0), 0.0);
  EXPECT_EQ(falling_root(-1e-10, -1, 0, 1e-9), 0.0);
  EXPECT_FALSE(falling_root(-1e-8, -1, 0, 1e-9));
  EXPECT_FALSE(falling_root(-1, 1, -1, 1e-9));  // from below it rises to half a metre under the plane and sinks
}

// With the unstable formula a slow fall onto a near plane loses half its digits.
TEST(FallingRoot, AgreesWithLongDouble) {
  Dice dice(31);
  int compared = 0;
  for (int i = 0; i < 1'000'000; ++i) {
    const double h0 = dice.magnitude(1e-12, 1e4), sense = dice.chance(0.5) ? 1.0 : -1.0;
    const double vn = dice.chance(0.1) ? 0.0 : sense * dice.magnitude(1e-8, 1e2);
    const double an = dice.chance(0.1) ? 0.0 : (dice.chance(0.8) ? -1.0 : 1.0) * dice.magnitude(1e-6, 10);
    const auto t = falling_root(h0, vn, an, 0);
    const long double h = h0, v = vn, a = an, discriminant = v * v - 2 * a * h;
    // The root of a curve that almost misses is not defined within rounding.
    if (std::abs(discriminant) < 1e-10L * (v * v + std::abs(2 * a * h))) continue;
    if (a == 0 && v == 0) {
      ASSERT_FALSE(t);
      continue;
    }
    if (discriminant < 0 || (v >= 0 && a >= 0)) {
      ASSERT_FALSE(t) << h0 << ' ' << vn << ' ' << an;
      continue;
    }
    const long double root = v <= 0 ? 2 * h / (-v + std::sqrt(discriminant)) : (v + std::sqrt(discriminant)) / -a;
    ASSERT_TRUE(t) << h0 << ' ' << vn << ' ' << an;
    // The discriminant is rounded, which matters near a double root.
    const long double sharp = 4e-16L * (1 + (v * v + std::abs(2 * a * h)) / discriminant);
    ASSERT_NEAR(static_cast<double>(*t / root), 1.0, static_cast<double>(sharp));
    ++compared;
  }
  EXPECT_GT(compared, 500'000);
}

// ---- polynomials ----

TEST(Falls, OfAQuarticWithKnownRoots) {
  Dice dice(32);
  for (int i = 0; i < 100'000; ++i) {
    std::array<double, 4> root;
    for (double& r : root) r = dice.between(-2, 8);
    std::sort(root.begin(), root.end());
    if (root[1] - root[0] < 1e-3 || root[2] - root[1] < 1e-3 || root[3] - root[2] < 1e-3) continue;
    if (std::any_of(root.begin(), root.end(), [](double r) { return std::abs(r) < 1e-3 || std::abs(r - 5) < 1e-3; })) {
      continue;
    }
    std::array<double, 5> c{1, 0, 0, 0, 0};
    for (const double r : root) {
      for (std::size_t k = 4; k > 0; --k) c[k] = c[k - 1] - r * c[k];
      c[0] *= -r;
    }
    const Falls found = falls(c, 5.0, 0.0);
    // With a positive leading coefficient it falls through its first and third root.
    std::array<double, 2> expected{};
    int count = 0;
    const bool falling_at_start = c[0] <= 0 && c[1] < 0;
    if (falling_at_start) expected[static_cast<std::size_t>(count++)] = 0;
    for (const std::size_t k : {std::size_t{0}, std::size_t{2}}) {
      if (root[k] > 0 && root[k] < 5) expected[static_cast<std::size_t>(count++)] = root[k];
    }
    // From below zero it may rise to a maximum below zero: that is a touch at the maximum.
    if (c[0] <= 0 && c[1] > 0) continue;
    ASSERT_EQ(found.count, count) << root[0] << ' ' << root[1] << ' ' << root[2] << ' ' << root[3];
    for (int k = 0; k < count; ++k) {
      ASSERT_NEAR(found.t[static_cast<std::size_t>(k)], expected[static_cast<std::size_t>(k)], 1e-8);
    }
  }
}

TEST(Falls, OfLowDegrees) {
  EXPECT_EQ(falls({1, 0, 0, 0, 0}, 10, 0).count, 0);
  const Falls line = falls({1, -2, 0, 0, 0}, 10, 0);
  ASSERT_EQ(line.count, 1);
  EXPECT_DOUBLE_EQ(line.t[0], 0.5);
  EXPECT_EQ(falls({1, -2, 0, 0, 0}, 0.4, 0).count, 0);
  const Falls parabola = falls({0, 4, -2, 0, 0}, 10, 1e-9);
  ASSERT_EQ(parabola.count, 1);
  EXPECT_DOUBLE_EQ(parabola.t[0], 2);
}

// A rock that rests on an edge: by rounding it is slightly inside and rises slightly, and gravity presses it back.
TEST(Falls, SlightlyInsideAndRisingIsStillTouching) {
  const Falls found = falls({-1e-16, 1e-16, -5, 0, 24}, 1, 1e-9);
  ASSERT_GE(found.count, 1);
  EXPECT_LT(found.t[0], 1e-15);
}

TEST(Falls, ARockThatLeavesIsNotHeld) {
  EXPECT_EQ(falls({0, 1, 0, 0, 0}, 10, 1e-9).count, 0);
  const Falls found = falls({-1e-12, 1, -0.1, 0, 0}, 20, 1e-9);  // it rises by 2.5 and comes back
  ASSERT_EQ(found.count, 1);
  EXPECT_NEAR(found.t[0], 10, 1e-9);
}

// Over an edge faster than sqrt(g r): by rounding it moves in at first, but it takes off.
TEST(Falls, ATinySpeedInwardsIsNoContact) {
  EXPECT_EQ(falls({-1e-16, -1e-15, 5, 0, 24}, 1, 1e-9).count, 0);
  EXPECT_EQ(falls({1e-16, -1e-15, 5, 0, 24}, 1, 1e-9).count, 0);
  EXPECT_EQ(falls({1e-16, -1e-3, 5, 0, 24}, 1, 1e-9).count, 1);
}

// ---- edges and points: against minimisation by brute force ----

double distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& e, double length) {
  const double s = std::clamp((p - a).dot(e), 0.0, length);
  return (p - a - s * e).norm();
}

// The first time at which `distance` falls through `radius`, by steps and bisection; nullopt if it stays above.
template <class Distance>
std::optional<double> first_fall(const Distance& distance, double radius, double t_max, int steps) {
  double before = distance(0.0);
  for (int i = 1; i <= steps; ++i) {
    const double t = t_max * i / steps, now = distance(t);
    if (before > radius && now <= radius) {
      double low = t_max * (i - 1) / steps, high = t;
      for (int k = 0; k < 60; ++k) {
        const double middle = 0.5 * (low + high);
        (distance(middle) > radius ? low : high) = middle;
      }
      return high;
    }
    before = now;
  }
  return std::nullopt;
}

// From some metres away, roughly towards a place, which it reaches after half a second to one and a half.
Parabola random_flight(Dice& dice, const Vec3& towards) {
  const Vec3 gravity(0, 0, -9.81), from = towards + 5 * dice.direction();
  const double t = dice.between(0.5, 1.5);
  const Vec3 goal = towards + dice.in_cube(0.7);
  return {from, (goal - from) / t - 0.5 * t * gravity, gravity};
}

// The minimum distance over a flight, sampled.
template <class Distance>
double closest(const Distance& distance, double t_max, int steps) {
  double least = distance(0.0);
  for (int i = 1; i <= steps; ++i) least = std::min(least, distance(t_max * i / steps));
  return least;
}

TEST(TouchPoint, AgreesWithBruteForce) {
  Dice dice(33);
  int touched = 0;
  for (int i = 0; i < 3000; ++i) {
    const Vec3 q = dice.in_cube(3);
    const Parabola path = random_flight(dice, q);
    const double radius = dice.magnitude(0.01, 2);
    const auto distance = [&](double t) { return (path.at(t) - q).norm(); };
    if (distance(0) <= radius * 1.001) continue;
    const auto expected = first_fall(distance, radius, 2.0, 1000);
    const auto t = touch_point(path, q, radius, {0, 2});
    // Steps of 2 ms can miss a touch that is shallower than the curvature of the path in one.
    if (!expected && t) {
      ASSERT_NEAR(distance(*t), radius, 1e-9);
      ASSERT_GT(closest(distance, 2.0, 1000), radius);
      continue;
    }
    ASSERT_EQ(t.has_value(), expected.has_value());
    if (!t) continue;
    ++touched;
    ASSERT_LE(*t, *expected + 1e-9);
    ASSERT_NEAR(distance(*t), radius, 1e-9);
    ASSERT_LT(distance(*t + 1e-7), radius + 1e-12);
  }
  EXPECT_GT(touched, 500);
}

TEST(TouchEdge, AgreesWithBruteForce) {
  Dice dice(34);
  int touched = 0;
  for (int i = 0; i < 3000; ++i) {
    const Vec3 a = dice.in_cube(3), e = dice.direction();
    const double length = dice.between(0.5, 6), radius = dice.magnitude(0.01, 2);
    const Parabola path = random_flight(dice, a + dice.unit() * length * e);
    const auto distance = [&](double t) { return distance_to_segment(path.at(t), a, e, length); };
    if (distance(0) <= radius * 1.001) continue;
    // The first touch of a segment is on its line or at one of its ends.
    auto t = touch_edge(path, a, e, length, radius, {0, 2});
    for (const Vec3& end : {a, Vec3(a + length * e)}) {
      const auto at_end = touch_point(path, end, radius, {0, 2});
      if (at_end && (!t || *at_end < *t)) t = at_end;
    }
    const auto expected = first_fall(distance, radius, 2.0, 1000);
    if (!expected && t) {
      ASSERT_NEAR(distance(*t), radius, 1e-9);
      ASSERT_GT(closest(distance, 2.0, 1000), radius);
      continue;
    }
    ASSERT_EQ(t.has_value(), expected.has_value());
    if (!t) continue;
    ++touched;
    ASSERT_LE(*t, *expected + 1e-9);
    ASSERT_NEAR(distance(*t), radius, 1e-9);
  }
  EXPECT_GT(touched, 500);
}

TEST(TouchPoint, InAWindowIsThatOfTheWholePath) {
  Dice dice(35);
  int inside = 0;
  for (int i = 0; i < 3000; ++i) {
    const Vec3 q = dice.in_cube(3);
    const Parabola path = random_flight(dice, q);
    const double radius = dice.magnitude(0.01, 2);
    if ((path.p - q).norm() <= radius * 1.001) continue;
    const auto t = touch_point(path, q, radius, {0, 2});
    const TimeWindow window{dice.between(0, 1.5), 2 * dice.unit()};
    const auto in_window = touch_point(path, q, radius, window);
    if (!t || *t > window.leave) {
      ASSERT_FALSE(in_window);
    } else if (*t >= window.enter) {
      ++inside;
      ASSERT_TRUE(in_window);
      ASSERT_NEAR(*in_window, *t, 1e-12);
    }
  }
  EXPECT_GT(inside, 100);
}

TEST(TouchEdge, DoesNotIncludeTheEnds) {
  const Parabola off_the_end{{-0.5, 0, 2}, {0, 0, -1}, {0, 0, -9.81}};
  EXPECT_FALSE(touch_edge(off_the_end, Vec3{}, unit_x, 1, 1, {0, 10}));
  EXPECT_TRUE(touch_point(off_the_end, Vec3{}, 1, {0, 10}));
  const Parabola above{{0.5, 0, 2}, {0, 0, -1}, {0, 0, 0}};
  const auto t = touch_edge(above, Vec3{}, unit_x, 1, 1, {0, 10});
  ASSERT_TRUE(t);
  EXPECT_DOUBLE_EQ(*t, 1);
}

TEST(TouchPoint, AtRestOnItIsATouchAtOnce) {
  const Parabola path{{0, 0, 1}, {0, 0, 0}, {0, 0, -9.81}};
  const auto t = touch_point(path, Vec3{}, 1, {0, 10});
  ASSERT_TRUE(t);
  EXPECT_LT(*t, 1e-12);
}

// Over the top of a sphere, a rock faster than sqrt(g r) takes off; a slower one stays on it.
TEST(TouchPoint, AFastRockTakesOffAtTheTop) {
  const double limit = std::sqrt(9.81 * 1.0);
  const Parabola slow{{0, 0, 1}, {0.99 * limit, 0, 0}, {0, 0, -9.81}};
  EXPECT_TRUE(touch_point(slow, Vec3{}, 1, {0, 10}));
  const Parabola fast{{0, 0, 1}, {1.01 * limit, 0, 0}, {0, 0, -9.81}};
  EXPECT_FALSE(touch_point(fast, Vec3{}, 1, {0, 10}));
}

}  // namespace
}  // namespace talus::touch_test
