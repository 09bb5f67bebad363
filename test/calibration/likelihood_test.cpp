// Likelihoods against closed forms, and draws of rocks as they were observed.

#include "talus/calibration/likelihood.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>
#include <vector>

#include "talus/core/random.hpp"

namespace talus::calibration {
namespace {

Eigen::VectorXd shares(std::initializer_list<double> values) {
  Eigen::VectorXd list(static_cast<Eigen::Index>(values.size()));
  std::copy(values.begin(), values.end(), list.begin());
  return list;
}

TEST(ShareLikelihood, IsBinomialIfTheSimulationIsLarge) {
  // 3 of 10 where 2 of 10 are expected: C(10, 3) 0.2^3 0.8^7.
  const double exact = std::log(120 * std::pow(0.2, 3) * std::pow(0.8, 7));
  EXPECT_NEAR(share_log_density(shares({0.3, 0.7}), 10, shares({0.2, 0.8}), 1e7).value, exact, 1e-5);
}

TEST(ShareLikelihood, ExpectsWhatWasNotSimulatedAsRarelyAsTheSimulationIsLarge) {
  // One rock, in a category that none of n simulated rocks is in: (1/2) / (n + 1).
  const LogDensity density = share_log_density(shares({1, 0}), 1, shares({0, 1}), 99);
  EXPECT_NEAR(density.value, std::log(0.5 / 100), 1e-9);
  EXPECT_GT(density.squared_distance, 9);
}

TEST(ShareLikelihood, HasNoDistanceFromItself) {
  EXPECT_EQ(share_log_density(shares({0.25, 0.75}), 20, shares({0.25, 0.75}), 100).squared_distance, 0);
}

TEST(Summaries, OfAFewRocksFarOffHaveASmallRatioOfDeviations) {
  Eigen::MatrixXd peak = Eigen::MatrixXd::Zero(10, 1), two_places(10, 1);
  peak(3, 0) = 5;
  two_places << 1, 3, 1, 3, 1, 3, 1, 3, 1, 3;
  // Mean, logarithm of the standard deviation, median less mean, mean over root mean square deviation.
  const Eigen::VectorXd of_peak = summaries_of(peak), of_places = summaries_of(two_places);
  ASSERT_EQ(of_peak.size(), 4);
  EXPECT_NEAR(of_peak[1], std::log(5 / std::sqrt(10.0)), 1e-12);
  EXPECT_NEAR(of_peak[2], -0.5, 1e-12);
  EXPECT_NEAR(of_peak[3], 0.6, 1e-12);  // 2 sqrt(n - 1) / n
  EXPECT_NEAR(of_places[3], 1, 1e-12);
  EXPECT_EQ(summaries_of(Eigen::MatrixXd::Constant(10, 1, 2.0))[3], 1);
  EXPECT_EQ(summaries_of(peak.topRows(7)).size(), 2);
}

/// Rocks of two releases, normally distributed about 10 and 50 m.
Sample two_releases(int rocks) {
  Sample sample;
  sample.rows.resize(2 * rocks, 1);
  for (int k = 0; k < 2 * rocks; ++k) {
    const auto [a, b] = uniform_pair(3, static_cast<std::uint64_t>(k), static_cast<Stream>(6100), 0);
    sample.rows(k, 0) = (k % 2 == 0 ? 10 : 50) + 2 * std::sqrt(-2 * std::log(a)) * std::cos(2 * std::numbers::pi * b);
    sample.strata.push_back(static_cast<std::uint32_t>(k % 2));
  }
  return sample;
}

TEST(MatchedLikelihood, IsTheSumOverReleases) {
  const Sample simulated = two_releases(20000);
  Sample observed;
  observed.rows = Eigen::MatrixXd(2, 1);
  observed.rows << 11, 47;
  observed.strata = {0, 1};
  const LogDensity density = matched_log_density(simulated, observed, {{"runout", "m", 1.0}}, 1);
  // Each release with the variance 4 + 1 of the rocks and their observation.
  const double exact = -0.5 * (1.0 / 5 + 9.0 / 5) - std::log(2 * std::numbers::pi * 5);
  EXPECT_NEAR(density.value, exact, 0.1);
  EXPECT_NEAR(density.squared_distance, 2, 0.15);
  EXPECT_EQ(matched_summary_count(observed), 2U);
  // Exchanged releases are as far away as they are from each other.
  observed.strata = {1, 0};
  EXPECT_GT(matched_log_density(simulated, observed, {{"runout", "m", 1.0}}, 1).squared_distance, 300);
}

TEST(Redraw, TakesWholeRocksOfTheirReleases) {
  Sample simulated;  // rock 0 has 3 marks, rocks 1 to 3 have 1, 4 and 2
  simulated.rows = Eigen::VectorXd::LinSpaced(10, 0, 9);
  simulated.rocks = {0, 0, 0, 1, 2, 2, 2, 2, 3, 3};
  simulated.strata = {0, 0, 0, 1, 0, 0, 0, 0, 1, 1};
  Sample observed;
  observed.rows = Eigen::MatrixXd::Zero(5, 1);
  observed.rocks = {7, 7, 7, 9, 9};
  observed.strata = {0, 0, 0, 1, 1};
  const Redraw redraw(simulated, observed);
  EXPECT_EQ(redraw.observed_rocks(), 2U);
  EXPECT_EQ(redraw.simulated_rocks(), 4U);
  EXPECT_TRUE(redraw.has_at_least(2));
  EXPECT_FALSE(redraw.has_at_least(3));
  std::vector<Eigen::Index> rows;
  std::set<std::uint32_t> seen;
  for (std::uint32_t replica = 0; replica < 100; ++replica) {
    redraw.rows(1, replica, rows);
    const std::uint32_t first = simulated.rocks[static_cast<std::size_t>(rows[0])];
    const std::uint32_t second = simulated.rocks[static_cast<std::size_t>(rows.back())];
    seen.insert({first, second});
    EXPECT_TRUE(first == 0 || first == 2);
    EXPECT_TRUE(second == 1 || second == 3);
    // As many marks as were observed of the rock, or all that it has, and each once.
    EXPECT_EQ(rows.size(), second == 1 ? 4U : 5U);
    EXPECT_EQ(std::set<Eigen::Index>(rows.begin(), rows.end()).size(), rows.size());
  }
  EXPECT_EQ(seen.size(), 4U);
}

TEST(ExpectedSummaries, VaryMoreIfMarksAreOfFewRocks) {
  // Marks of a rock lie close together: twenty of two rocks say as much of the mean as two.
  Sample simulated;
  simulated.rows.resize(2000, 1);
  for (int rock = 0; rock < 200; ++rock) {
    const double place = uniform_pair(5, static_cast<std::uint64_t>(rock), static_cast<Stream>(6101), 0)[0];
    for (int mark = 0; mark < 10; ++mark) {
      simulated.rows(10 * rock + mark, 0) = place + 1e-3 * mark;
      simulated.rocks.push_back(static_cast<std::uint32_t>(rock));
    }
  }
  Sample marks;
  marks.rows = Eigen::MatrixXd::Zero(20, 1);
  for (int k = 0; k < 20; ++k) marks.rocks.push_back(k < 10 ? 0 : 1);
  const double by_rock = expected_summaries(simulated, marks, {{"runout", "m", 0}}, 1).covariance(0, 0);
  simulated.rocks.clear();
  marks.rocks.clear();
  const double independent = expected_summaries(simulated, marks, {{"runout", "m", 0}}, 1).covariance(0, 0);
  EXPECT_NEAR(by_rock / independent, 10, 3);
}

}  // namespace
}  // namespace talus::calibration
