// Differences of the same members without and with a change.

#include "talus/statistics/paired_differences.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "talus/statistics/counted_draws.hpp"
#include "talus/statistics/quantile.hpp"

namespace talus::paired_differences_test {
namespace {

/// The example of ci.prop.ps in the R package statpsych, which implements Bonett and Price (2012): of 48 members 26
/// gain and 4 lose; estimate 0.44 (adjusted), from 0.2548067 to 0.6251933.
TEST(PairedShareDifference, HasTheIntervalOfBonettAndPrice) {
  const Estimate estimate = paired_share_difference(26, 4, 48, 0.95);
  EXPECT_DOUBLE_EQ(estimate.value, 22.0 / 48);
  EXPECT_NEAR(*estimate.low, 0.2548067, 1e-7);
  EXPECT_NEAR(*estimate.high, 0.6251933, 1e-7);
}

TEST(PairedShareDifference, StaysBetweenMinusOneAndOne) {
  const Estimate all = paired_share_difference(3, 0, 3, 0.99), none = paired_share_difference(0, 3, 3, 0.99);
  EXPECT_EQ(*all.high, 1);
  EXPECT_EQ(*none.low, -1);
  EXPECT_LE(*all.low, all.value);
  const Estimate nothing = paired_share_difference(0, 0, 100, 0.95);
  EXPECT_EQ(nothing.value, 0);
  EXPECT_DOUBLE_EQ(*nothing.low, -*nothing.high);
  EXPECT_LT(*nothing.high, 0.03);
}

/// The probability that an interval, narrowed by `factor`, covers the true difference: summed over all outcomes of 60
/// members, of which each gains with probability 0.15 and loses with 0.05.
double coverage(double factor) {
  constexpr int n = 60;
  constexpr double gain = 0.15, lose = 0.05;
  double covered = 0;
  for (int b = 0; b <= n; ++b) {
    for (int c = 0; b + c <= n; ++c) {
      const double log_probability = std::lgamma(n + 1) - std::lgamma(b + 1) - std::lgamma(c + 1) -
                                     std::lgamma(n - b - c + 1) + b * std::log(gain) + c * std::log(lose) +
                                     (n - b - c) * std::log(1 - gain - lose);
      const Estimate estimate =
          paired_share_difference(static_cast<std::uint64_t>(b), static_cast<std::uint64_t>(c), n, 0.95);
      const double middle = (*estimate.low + *estimate.high) / 2, half = factor * (*estimate.high - *estimate.low) / 2;
      if (std::abs(gain - lose - middle) <= half) covered += std::exp(log_probability);
    }
  }
  return covered;
}

TEST(PairedShareDifference, CoversTheTruthAsOftenAsItSays) {
  EXPECT_NEAR(coverage(1), 0.95, 0.015);
  EXPECT_LT(coverage(0.8), 0.91);  // the test can fail
}

std::vector<MemberValues> members(std::size_t count, double shift, std::size_t every = 1) {
  const CountedDraws draws(7, CountedDraws::Purpose::bootstrap);
  std::vector<MemberValues> all;
  for (std::size_t k = 0; k < count; k += every) {
    const auto value = static_cast<double>(draws.below(1'000'000, k, 0));
    all.push_back({k, {value + shift, 2 * value, value * value}});
  }
  return all;
}

double quantile_of(const std::vector<MemberValues>& all, double p) {
  std::vector<double> values;
  for (const MemberValues& member : all) values.push_back(member.values[0]);
  std::ranges::sort(values);
  const QuantilePlace place = quantile_place(p, values.size());
  return between(values[place.rank], values[std::min<std::size_t>(place.rank + 1, values.size() - 1)], place.fraction);
}

TEST(PairedQuantileDifferences, OfAShiftAreTheShiftWithoutDoubt) {
  for (const double p : {0.5, 0.95}) {
    const auto found = paired_quantile_differences(members(500, 0), members(500, 25), p, {});
    ASSERT_TRUE(found);
    EXPECT_EQ((*found)[0], (Estimate{25, 25, 25}));
    EXPECT_EQ((*found)[1], (Estimate{0, 0, 0}));
    EXPECT_EQ((*found)[2], (Estimate{0, 0, 0}));
  }
}

TEST(PairedQuantileDifferences, AreThoseOfTheQuantiles) {
  const auto without = members(700, 0, 3), with = members(900, 1000, 2);
  for (const double p : {0.1, 0.5, 0.9}) {
    const auto found = paired_quantile_differences(without, with, p, {.replicas = 200});
    ASSERT_TRUE(found);
    EXPECT_NEAR((*found)[0].value, quantile_of(with, p) - quantile_of(without, p), 1e-6);
    ASSERT_TRUE((*found)[0].low && (*found)[0].high);
    EXPECT_LT(*(*found)[0].low, (*found)[0].value);
    EXPECT_GT(*(*found)[0].high, (*found)[0].value);
  }
}

TEST(PairedQuantileDifferences, OfFewMembersHaveNoInterval) {
  const auto found = paired_quantile_differences(members(60, 0), members(60, 25), 0.95, {});
  ASSERT_TRUE(found);
  EXPECT_EQ((*found)[0], (Estimate{25, {}, {}}));
  EXPECT_FALSE(paired_quantile_differences({}, members(60, 0), 0.95, {}));
}

/// Half of the values of one sample differ from those of the other by a noise that is small beside their spread: the
/// interval is much narrower than that of either quantile.
TEST(PairedQuantileDifferences, AreKnownBetterThanTheQuantiles) {
  const auto without = members(2000, 0);
  auto with = without;
  for (MemberValues& member : with) member.values[0] += static_cast<double>(member.member % 2) * 1000;
  const auto found = paired_quantile_differences(without, with, 0.9, {});
  ASSERT_TRUE(found);
  QuantileSketch sketch(without.size());
  for (const MemberValues& member : without) sketch.add(member.values[0]);
  const Estimate alone = RankedValues(sketch).estimate(0.9, 0.95);
  EXPECT_LT(*(*found)[0].high - *(*found)[0].low, 0.1 * (*alone.high - *alone.low));
}

}  // namespace
}  // namespace talus::paired_differences_test
