#include "talus/trajectory/bumps.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "sampling/goodness_of_fit.hpp"
#include "support/dice.hpp"
#include "support/scenes.hpp"

namespace talus::bumps_test {
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

}  // namespace
}  // namespace talus::bumps_test
