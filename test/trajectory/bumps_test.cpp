#include "talus/trajectory/bumps.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "sampling/goodness_of_fit.hpp"
#include "support/dice.hpp"
#include "support/scenes.hpp"

namespace talus {
namespace {

using namespace testing_tools;

// Over a way L the number of bumps is Poisson distributed with mean L/s, however the way is divided.
TEST(Bumps, ArePoissonAlongTheWay) {
  constexpr double spacing = 4, length = 30;
  Dice dice(5);
  double sum = 0, squares = 0;
  constexpr int rocks = 5000;
  for (std::uint64_t rock = 0; rock < rocks; ++rock) {
    const Draws draws(SamplingPlan{}, rock);
    Bumps bumps;
    double gone = 0, met = 0;
    while (gone < length) {
      const double way = std::min(bumps.way(draws, spacing), length - gone), piece = std::min(way, dice.between(0, 3));
      bumps.cover(piece, spacing);
      gone += piece;
      if (piece < way || gone >= length) continue;
      bumps.pass();
      ++met;
    }
    sum += met;
    squares += met * met;
  }
  const double mean = sum / rocks, variance = squares / rocks - mean * mean, due = length / spacing;
  EXPECT_NEAR(mean, due, 4 * std::sqrt(due / rocks));
  EXPECT_NEAR(variance, due, 4 * due * std::sqrt(2.0 / rocks) + 4 * std::sqrt(due / rocks));
}

TEST(Bumps, TheWayToTheFirstIsExponential) {
  std::vector<double> ways;
  for (std::uint64_t rock = 0; rock < 20'000; ++rock) {
    ways.push_back(Bumps().way(Draws(SamplingPlan{}, rock), 2.5));
  }
  const double distance = kolmogorov_distance(ways, [](double way) { return 1 - std::exp(-way / 2.5); });
  EXPECT_GT(kolmogorov_probability(distance, ways.size()), 0.01);
}

// A spacing that changes on the way counts in proportion.
TEST(Bumps, AreCountedInSpacings) {
  const Draws draws(SamplingPlan{}, 3);
  Bumps bumps;
  const double way = bumps.way(draws, 1);
  bumps.cover(0.25 * way, 1);
  EXPECT_NEAR(bumps.way(draws, 4), 4 * 0.75 * way, 1e-15);
}

TEST(ArcLength, OfAStraightLegIsExact) {
  const Vec3 e = Vec3(1, 2, -2) / 3;
  const Parabola leg{Vec3::Zero(), 4 * e, -1.5 * e};
  EXPECT_NEAR(arc_length(leg, 2), 4 * 2 - 0.75 * 4, 1e-14);
  EXPECT_NEAR(time_at_length(leg, 5, 2).value(), 2, 1e-14);
  EXPECT_FALSE(time_at_length(leg, 5.001, 2));
  EXPECT_FALSE(time_at_length({Vec3::Zero(), Vec3::Zero(), Vec3::Zero()}, 1, 2));
  const Parabola from_rest{Vec3::Zero(), Vec3::Zero(), 2 * e};
  EXPECT_NEAR(time_at_length(from_rest, 9, std::numeric_limits<double>::infinity()).value(), 3, 1e-13);
}

// Against the closed form of a parabola's length.
TEST(ArcLength, OfACurvedLeg) {
  const Parabola leg{Vec3::Zero(), Vec3(5, 0, 0), Vec3(0, 6, 0)};
  const double t = 0.1, q = 6 * t / 5, length = 25.0 / 12 * (q * std::sqrt(1 + q * q) + std::asinh(q));
  EXPECT_NEAR(arc_length(leg, t), length, 1e-9);
  EXPECT_NEAR(time_at_length(leg, arc_length(leg, 0.07), t).value(), 0.07, 1e-12);
}

}  // namespace
}  // namespace talus
