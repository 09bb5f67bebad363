// Compares arcs with the closed forms of a parabola and of a flight with linear drag.

#include "talus/archive/path_arcs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/dice.hpp"
#include "talus/core/vec.hpp"

namespace talus {
namespace {

using testing_tools::Dice;
using enum PathState;

constexpr double gravity = 9.80665, mass = 1200;

std::array<double, 3> numbers(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

PathEventRow row(PathState state, double time, const Vec3& p, const Vec3& v, double rotational = 0) {
  return {.state = state,
          .time_s = time,
          .position_m = numbers(p),
          .velocity_m_s = numbers(v),
          .ke_translational_J = 0.5 * mass * v.squared_norm(),
          .ke_rotational_J = rotational};
}

std::vector<PathPoint> points_of(const Path& path, double tolerance) {
  std::vector<PathPoint> points;
  for_points_along(path, tolerance, [&](const PathPoint& point) { points.push_back(point); });
  return points;
}

TEST(PathArcs, OfAFreeFlightAreAParabola) {
  Dice dice(3);
  for (int trial = 0; trial < 300; ++trial) {
    const Vec3 p = dice.in_cube(500) + Vec3(2'600'000, 1'200'000, 800), v = dice.in_cube(20), g(0, 0, -gravity);
    const double begin = dice.between(0, 60), duration = dice.magnitude(1e-3, 8), rotational = dice.between(0, 1e4);
    const Vec3 v_end = v + duration * g;
    const Path path{.rows = {row(projectile, begin, p, v, rotational),
                             row(impact, begin + duration, p + duration * (v + duration / 2 * g), v_end, rotational)}};
    const double tolerance = dice.magnitude(0.01, 1);
    const auto points = points_of(path, tolerance);
    const auto pieces = points.size() - 1;
    for (const PathPoint& point : points) {
      const double t = point.time_s - begin;
      EXPECT_LT((vector(point.position_m) - (p + t * (v + t / 2 * g))).norm(), 1e-7);
      EXPECT_LT((vector(point.velocity_m_s) - (v + t * g)).norm(), 1e-5);
      const double energy = 0.5 * mass * (v + t * g).squared_norm() + rotational;
      EXPECT_NEAR(point.ke_total_J, energy, 1e-6 * energy);
      EXPECT_EQ(point.state, &point == &points.back() ? impact : projectile);
    }
    // A chord is furthest from the arc at its middle, by g t^2/8: within the tolerance, but not with one piece less.
    const double piece = duration / static_cast<double>(pieces);
    EXPECT_LE(gravity * piece * piece / 8, tolerance * (1 + 1e-6));
    if (pieces > 1) {
      const double longer = duration / static_cast<double>(pieces - 1);
      EXPECT_GT(gravity * longer * longer / 8, tolerance * (1 - 1e-6));
    }
  }
}

// v = v0 e^(-kt) + (g/k)(1 - e^(-kt)): two seconds among trees with k = 0.2 1/s.
TEST(PathArcs, OfAFlightThroughTreesAreCloseToIt) {
  constexpr double k = 0.2, duration = 2;
  const Vec3 g(0, 0, -gravity), v(8, 3, 4), fall = g / k;
  const auto velocity = [&](double t) { return v * std::exp(-k * t) + fall * (1 - std::exp(-k * t)); };
  const auto place = [&](double t) { return (v - fall) * (1 - std::exp(-k * t)) / k + t * fall; };
  const Path path{.rows = {row(projectile, 0, Vec3{}, v), row(impact, duration, place(duration), velocity(duration))}};
  const auto points = points_of(path, 0.05);
  EXPECT_GT(points.size(), 5U);
  // Hermite's remainder: T^4/384 of the fourth derivative, here k^2 (g - k v) e^(-kt).
  const double greatest_error = std::pow(duration, 4) / 384 * k * k * (g - k * v).norm();
  EXPECT_LT(greatest_error, 0.02);
  for (const PathPoint& point : points) {
    EXPECT_LT((vector(point.position_m) - place(point.time_s)).norm(), greatest_error);
    EXPECT_LT((vector(point.velocity_m_s) - velocity(point.time_s)).norm(), 0.05);
  }
}

// Between the same two rows a free flight at first, then among trees.
TEST(PathArcs, OfAFlightPartlyThroughTreesAreWithinTheStatedError) {
  constexpr double k = 0.2, duration = 2;
  const Vec3 g(0, 0, -gravity), v(15, 3, 4), fall = g / k;
  for (const double forest : {0.0, 0.2, 0.46, 1.0, 1.54, 1.9}) {
    const Vec3 v_there = v + forest * g, p_there = forest * (v + forest / 2 * g);
    const auto velocity = [&](double t) {
      const double braked = std::exp(-k * (t - forest));
      return t < forest ? v + t * g : v_there * braked + fall * (1 - braked);
    };
    const auto place = [&](double t) {
      const double braked = std::exp(-k * (t - forest));
      return t < forest ? Vec3(t * (v + t / 2 * g))
                        : p_there + (v_there - fall) * (1 - braked) / k + (t - forest) * fall;
    };
    const double smooth = std::pow(duration, 4) / 384 * k * k * (g - k * v_there).norm();
    const double jump = forest > 0 ? k * v_there.norm() * duration * duration / 60 : 0;
    const Path path{
        .rows = {row(projectile, 0, Vec3{}, v), row(impact, duration, place(duration), velocity(duration))}};
    double greatest = 0;
    for (const PathPoint& point : points_of(path, 0.005)) {
      greatest = std::max(greatest, (vector(point.position_m) - place(point.time_s)).norm());
    }
    EXPECT_LE(greatest, smooth + jump) << forest;
    EXPECT_GT(greatest, 0.001) << forest;
  }
}

TEST(PathArcs, KeepRowsAndAreStraightExceptInFlight) {
  const Path path{.rows = {row(projectile, 0, {0, 0, 10}, {0, 0, 0}), row(impact, 1, {0, 0, 5}, {0, 0, -10}, 7),
                           row(sliding, 1, {0, 0, 5}, {3, 0, 0}, 9), row(impact, 9, {20, 0, 1}, {2, 0, 0}, 9),
                           row(projectile, 9, {20, 0, 1}, {2, 0, 0}, 9), row(barrier, 9, {20, 0, 1}, {2, 0, 0}, 9),
                           row(ended, 9, {20, 0, 1}, {0, 0, 0})}};
  const auto points = points_of(path, 1e6);
  ASSERT_EQ(points.size(), path.rows.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    EXPECT_EQ(points[k].state, path.rows[k].state);
    EXPECT_EQ(points[k].time_s, path.rows[k].time_s);
    EXPECT_EQ(points[k].position_m, path.rows[k].position_m);
    EXPECT_EQ(points[k].velocity_m_s, path.rows[k].velocity_m_s);
    EXPECT_EQ(points[k].ke_total_J, path.rows[k].ke_translational_J + path.rows[k].ke_rotational_J);
  }
  // From rest, where the mass follows from the end of the flight only.
  const auto fine = points_of(path, 0.01);
  EXPECT_EQ(fine.size(), path.rows.size() + 11);  // sqrt(10/0.08) = 11.2 pieces of the only flight with a duration
  EXPECT_NEAR(fine[6].ke_total_J, 0.5 * mass * 25, 1);
}

TEST(PathArcs, LimitTheNumberOfPointsOfAVeryLongFlight) {
  const Path path{.rows = {row(projectile, 0, {0, 0, 0}, {0, 0, 0}),
                           row(ended, 600, {0, 0, -gravity * 180'000}, {0, 0, -gravity * 600})}};
  EXPECT_EQ(points_of(path, 0.05).size(), std::size_t{most_pieces_of_a_flight} + 1);
}

}  // namespace
}  // namespace talus
