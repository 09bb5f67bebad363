#include "talus/statistics/log_bins.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "support/dice.hpp"
#include "talus/statistics/quantile.hpp"

namespace talus {
namespace {

using testing_tools::Dice;

double exact_quantile(std::vector<float> values, double p) {
  std::sort(values.begin(), values.end());
  const auto [rank, fraction] = quantile_place(p, values.size());
  const double low = values[rank];
  return fraction > 0 ? between(low, values[rank + 1], fraction) : low;
}

TEST(LogBins, QuantilesAreWithinOnePercent) {
  Dice dice(17);
  for (int trial = 0; trial < 200; ++trial) {
    LogBins bins;
    std::vector<float> values(1 + dice.below(300));
    const double low = dice.magnitude(2e-3, 1e6), high = low * dice.magnitude(1, 1e6);
    for (float& value : values) {
      value = static_cast<float>(dice.magnitude(low, high));
      bins.add(2, value);
    }
    for (const double p : {0.0, 0.05, 0.5, 0.95, 0.99, 1.0}) {
      const double exact = exact_quantile(values, p);
      EXPECT_NEAR(bins.quantile(2, p, values.size()), exact, 0.0079 * exact) << p << " of " << values.size();
    }
  }
}

TEST(LogBins, TheFourQuantitiesDoNotMix) {
  LogBins bins;
  for (std::uint32_t which = 0; which < 4; ++which) {
    for (int k = 0; k < 10; ++k) bins.add(which, std::pow(10.0F, static_cast<float>(which)));
  }
  for (std::uint32_t which = 0; which < 4; ++which) {
    EXPECT_NEAR(bins.quantile(which, 0.5, 10) / std::pow(10.0, which), 1, 0.008);
  }
}

TEST(LogBins, SmallValuesAreZeroAndLargeOnesStayInTheLastBin) {
  LogBins bins;
  bins.add(0, 0);
  bins.add(0, 0.0009F);
  bins.add(3, 1e30F);
  EXPECT_EQ(bins.quantile(0, 1, 2), 0);
  EXPECT_NEAR(bins.quantile(3, 0.5, 1) / 0x1p80, 1, 0.008);
}

// Near each other and far from each other, few and many, settled now and then: what is asked gives the same.
TEST(LogBins, WhenTheyAreSettledMakesNoDifference) {
  Dice dice(18);
  for (int trial = 0; trial < 300; ++trial) {
    LogBins now_and_then, never;
    std::array<std::vector<float>, 4> values;
    for (int run = 0; run < 4; ++run) {
      const double low = dice.magnitude(1e-3, 1e6), high = low * dice.magnitude(1, dice.chance(0.3) ? 1e6 : 4);
      for (std::size_t k = dice.below(dice.chance(0.5) ? 12 : 1000); k > 0; --k) {
        const auto which = static_cast<std::uint32_t>(dice.below(4));
        const auto value = static_cast<float>(dice.magnitude(low, high));
        values[which].push_back(value);
        now_and_then.add(which, value);
        never.add(which, value);
      }
      now_and_then.settle();
      ASSERT_EQ(now_and_then, never);
    }
    for (std::uint32_t which = 0; which < 4; ++which) {
      if (values[which].empty()) continue;
      const double exact = exact_quantile(values[which], 0.9);
      ASSERT_NEAR(now_and_then.quantile(which, 0.9, values[which].size()), exact, 0.0079 * exact);
      ASSERT_EQ(never.quantile(which, 0.9, values[which].size()),
                now_and_then.quantile(which, 0.9, values[which].size()));
    }
  }
}

// More values in a bin than one entry can count, added one by one and by merging: the same bits.
TEST(LogBins, CountsFarInOneBin) {
  LogBins one_by_one, merged, part;
  for (int k = 0; k < 200'000; ++k) one_by_one.add(1, 5);
  for (int k = 0; k < 40'000; ++k) part.add(1, 5);
  for (int k = 0; k < 5; ++k) merged.merge(part);
  EXPECT_TRUE(merged == one_by_one);
  merged.add(1, 80);
  EXPECT_FALSE(merged == one_by_one);
  EXPECT_NEAR(merged.quantile(1, 0.5, 200'001), 5, 0.04);
  EXPECT_NEAR(merged.quantile(1, 0.999994, 200'001), 5, 0.04);
  EXPECT_NEAR(merged.quantile(1, 1, 200'001), 80, 0.7);
  one_by_one.settle();
  EXPECT_LE(one_by_one.bytes(), 4 * 128U);  // what waits until it is settled, and no more
}

TEST(LogBins, MergeToTheSameCountsWhateverTheSplit) {
  Dice dice(19);
  LogBins whole;
  std::vector<LogBins> parts(5);
  for (int k = 0; k < 3000; ++k) {
    const auto which = static_cast<std::uint32_t>(dice.below(4));
    const auto value = static_cast<float>(dice.magnitude(1e-4, 1e7));
    whole.add(which, value);
    parts[dice.below(5)].add(which, value);
  }
  LogBins forwards, backwards;
  for (std::size_t k = 0; k < 5; ++k) {
    forwards.merge(parts[k]);
    backwards.merge(parts[4 - k]);
  }
  EXPECT_TRUE(forwards == whole);
  EXPECT_TRUE(backwards == whole);
}

}  // namespace
}  // namespace talus
