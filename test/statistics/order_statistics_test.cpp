#include "talus/statistics/order_statistics.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/dice.hpp"

namespace talus::order_statistics_test {
namespace {

using testing_tools::Dice;

void expect_ranks(double p, std::uint64_t count, double confidence, std::optional<std::uint64_t> low,
                  std::optional<std::uint64_t> high) {
  const RankBounds bounds = quantile_rank_bounds(p, count, confidence);
  EXPECT_EQ(bounds.low, low) << p << ' ' << count << ' ' << confidence;
  EXPECT_EQ(bounds.high, high) << p << ' ' << count << ' ' << confidence;
}

// Tables of the sign test: the median is between the 2nd and the 9th of 10 values, between the 6th and the 15th of 20,
// and between the 40th and the 61st of 100.
TEST(QuantileRankBounds, OfTheMedianAgreeWithPrintedTables) {
  expect_ranks(0.5, 10, 0.95, 1, 8);
  expect_ranks(0.5, 20, 0.95, 5, 14);
  expect_ranks(0.5, 100, 0.95, 39, 60);
  expect_ranks(0.5, 6, 0.95, 0, 5);
  expect_ranks(0.5, 5, 0.95, {}, {});  // 2 / 2^5 = 6 %
}

// The maximum of n values is above the quantile p unless all n are below it: p^n.
TEST(QuantileRankBounds, HaveAnUpperEndFromTheRequiredNumberOfValues) {
  expect_ranks(0.95, 71, 0.95, 62, {});
  expect_ranks(0.95, 72, 0.95, 63, 71);
  EXPECT_FALSE(quantile_rank_bounds(0.99, 367, 0.95).high);
  EXPECT_EQ(quantile_rank_bounds(0.99, 368, 0.95).high, 367u);
  expect_ranks(0.5, 0, 0.95, {}, {});
  expect_ranks(0.5, 1, 0.95, {}, {});
}

TEST(QuantileRankBounds, OfTheMinimumAndMaximumAreTheirRanks) {
  expect_ranks(0, 50, 0.95, {}, 0);
  expect_ranks(1, 50, 0.95, 49, {});
}

/// P(B = 0), ..., P(B = n) of the binomial distribution, by its recurrence.
std::vector<double> binomial(std::uint64_t n, double p) {
  std::vector<double> probabilities{1};
  for (std::uint64_t trial = 0; trial < n; ++trial) {
    probabilities.push_back(0);
    for (std::size_t k = probabilities.size() - 1; k > 0; --k) {
      probabilities[k] = probabilities[k] * (1 - p) + probabilities[k - 1] * p;
    }
    probabilities[0] *= 1 - p;
  }
  return probabilities;
}

TEST(QuantileRankBounds, AreTheNarrowestWithHalfTheErrorAtEachEnd) {
  for (const std::uint64_t n : {1U, 2U, 7U, 40U, 173U, 400U}) {
    for (const double p : {0.01, 0.3, 0.5, 0.95, 0.99}) {
      const std::vector<double> probability = binomial(n, p);
      for (const double confidence : {0.5, 0.9, 0.95, 0.999}) {
        const double tail = (1 - confidence) / 2;
        std::optional<std::uint64_t> low, high;
        double below = 0;  // P(B <= rank)
        for (std::uint64_t rank = 0; rank < n; ++rank) {
          below += probability[rank];
          if (below <= tail) low = rank;
        }
        double above = 0;  // P(B > rank)
        for (std::uint64_t rank = n; rank-- > 0;) {
          above += probability[rank + 1];
          if (above <= tail) high = rank;
        }
        expect_ranks(p, n, confidence, low, high);
      }
    }
  }
}

/// How often the interval contains the 95th percentile of an exponential distribution.
double coverage(std::size_t values, double confidence, int trials) {
  Dice dice(5);
  const double truth = -std::log(0.05);
  int held = 0;
  for (int trial = 0; trial < trials; ++trial) {
    QuantileSketch sketch(values);
    for (std::size_t k = 0; k < values; ++k) sketch.add(-std::log(1 - dice.unit()));
    const Estimate estimate = RankedValues(sketch).estimate(0.95, confidence);
    held += estimate.low && estimate.high && *estimate.low <= truth && truth <= *estimate.high ? 1 : 0;
  }
  return static_cast<double>(held) / trials;
}

TEST(QuantileEstimate, HasItsNominalCoverage) {
  constexpr std::size_t values = 200;
  constexpr int trials = 4000;
  const RankBounds ranks = quantile_rank_bounds(0.95, values, 0.9);
  const std::vector<double> probability = binomial(values, 0.95);
  double expected = 0;
  for (std::uint64_t below = *ranks.low + 1; below <= *ranks.high; ++below) expected += probability[below];
  EXPECT_GE(expected, 0.9);
  const double error = std::sqrt(expected * (1 - expected) / trials);
  EXPECT_NEAR(coverage(values, 0.9, trials), expected, 4 * error);
  EXPECT_LT(coverage(values, 0.8, trials), expected - 4 * error) << "the comparison can fail";
}

void expect_share(std::uint64_t hits, std::uint64_t trials, double low, double high) {
  const ShareBounds bounds = share_bounds(hits, trials, 0.95);
  EXPECT_NEAR(bounds.low, low, 5e-5) << hits << " of " << trials;
  EXPECT_NEAR(bounds.high, high, 5e-5) << hits << " of " << trials;
}

TEST(ShareBounds, AgreeWithClopperAndPearson) {
  expect_share(0, 10, 0, 0.3085);
  expect_share(5, 10, 0.1871, 0.8129);
  expect_share(10, 10, 0.6915, 1);
  expect_share(10, 100, 0.0490, 0.1762);
  // Without a hit: (1 - high)^n equals the tail probability.
  EXPECT_DOUBLE_EQ(share_bounds(0, 300, 0.9).high, 1 - std::pow(0.05, 1.0 / 300));
  EXPECT_EQ(share_bounds(0, 300, 0.9).low, 0);
  EXPECT_EQ(share_bounds(300, 300, 0.9).high, 1);
}

TEST(RankedValues, AreTheOrderStatisticsAndQuantilesOfTheirSketch) {
  Dice dice(7);
  for (const std::uint64_t planned : {5'000U, 5'000'000U}) {
    QuantileSketch sketch(planned);
    std::vector<double> values;
    for (int k = 0; k < 5'000; ++k) values.push_back(dice.chance(0.1) ? 0 : dice.magnitude(1e-3, 1e6));
    for (const double x : values) sketch.add(x);
    std::ranges::sort(values);
    const RankedValues ranked(sketch);
    const double error = sketch.is_exact() ? 0 : 0.0005;
    for (std::uint64_t rank = 0; rank < values.size(); rank += 7) {
      EXPECT_NEAR(ranked.at(rank), values[rank], error * values[rank]);
    }
    EXPECT_EQ(ranked.at(0), values.front());
    EXPECT_EQ(ranked.at(values.size() - 1), values.back());
    for (const double p : {0.0, 0.1, 0.5, 0.77, 0.95, 0.999, 1.0}) EXPECT_EQ(ranked.quantile(p), sketch.quantile(p));
    const Estimate estimate = ranked.estimate(0.5, 0.95);
    const RankBounds ranks = quantile_rank_bounds(0.5, values.size(), 0.95);
    EXPECT_EQ(estimate.value, sketch.quantile(0.5));
    EXPECT_EQ(estimate.low, ranked.at(*ranks.low));
    EXPECT_EQ(estimate.high, ranked.at(*ranks.high));
  }
}

TEST(QuantileEstimate, IsWithinItsInterval) {
  for (std::uint64_t n = 1; n <= 40; ++n) {
    QuantileSketch sketch(n);
    for (std::uint64_t k = 1; k <= n; ++k) sketch.add(static_cast<double>(k * k));
    const RankedValues ranked(sketch);
    for (const double p : {0.0, 0.001, 0.01, 0.05, 0.3, 0.5, 0.77, 0.95, 0.99, 0.999, 1.0}) {
      for (const double confidence : {0.1, 0.5, 0.9, 0.95, 0.99}) {
        const Estimate estimate = ranked.estimate(p, confidence);
        EXPECT_GE(estimate.value, estimate.low.value_or(0)) << n << ' ' << p << ' ' << confidence;
        EXPECT_LE(estimate.value, estimate.high.value_or(1e9)) << n << ' ' << p << ' ' << confidence;
        if (estimate.value == ranked.quantile(p) || confidence < 0.9) continue;
        const double edge = p > 0.5 ? static_cast<double>(n * n) : 1;
        EXPECT_EQ(estimate.value, edge) << n << ' ' << p << ' ' << confidence << ": only beyond all values";
      }
    }
  }
}

// Two values are both below the 99th percentile with a probability of 98 %, three with 97 %.
TEST(QuantileEstimate, BeyondAllValuesIsTheMaximum) {
  QuantileSketch two(2), three(3);
  for (const double x : {1.0, 3.0}) two.add(x);
  for (const double x : {1.0, 2.0, 3.0}) three.add(x);
  EXPECT_EQ(RankedValues(two).estimate(0.99, 0.95), (Estimate{3, 3, {}}));
  EXPECT_EQ(RankedValues(two).estimate(0.01, 0.95), (Estimate{1, {}, 1}));
  EXPECT_DOUBLE_EQ(RankedValues(three).estimate(0.99, 0.95).value, 2.98);
}

TEST(RankedValues, OfASingleValueHaveNoInterval) {
  QuantileSketch sketch(1);
  sketch.add(3);
  EXPECT_EQ(RankedValues(sketch).estimate(0.95, 0.95), (Estimate{3, {}, {}}));
}

}  // namespace
}  // namespace talus::order_statistics_test
