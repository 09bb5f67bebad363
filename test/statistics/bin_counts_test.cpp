#include "talus/statistics/bin_counts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "support/dice.hpp"
#include "talus/statistics/quantile.hpp"

namespace talus::bin_counts_test {
namespace {

using testing_tools::Dice;

double exact_quantile(std::vector<float> values, double p) {
  std::sort(values.begin(), values.end());
  const auto [rank, fraction] = quantile_place(p, values.size());
  const double low = values[rank];
  return fraction > 0 ? between(low, values[rank + 1], fraction) : low;
}

double quantile(const BinCounts& counts, std::uint32_t place, std::uint32_t which, double p, std::uint64_t count) {
  double value = -1;
  counts.quantiles(place, which, count, {&p, 1}, {&value, 1});
  return value;
}

BinCounts one_place() {
  BinCounts counts(4);
  counts.new_place();
  return counts;
}

bool are_same(BinCounts& a, BinCounts& b) {
  a.settle();
  b.settle();
  return BinCounts::are_same(a, 0, b, 0);
}

TEST(LogBins, TheMiddleOfABinIsWithinOnePercentOfItsValues) {
  Dice dice(15);
  for (int trial = 0; trial < 100'000; ++trial) {
    const auto value = static_cast<float>(dice.magnitude(0x1p-10, 0x1p80));
    const double middle = log_bins::middle_of(log_bins::bin_of(value));
    ASSERT_NEAR(middle, value, 0.00991 * value);
  }
}

TEST(LogBins, AreInTheOrderOfTheirValues) {
  std::uint32_t before = log_bins::bin_of(log_bins::least);
  EXPECT_EQ(before, 0U);
  for (float value = log_bins::least; value < 3; value *= 1.0005F) {
    const std::uint32_t bin = log_bins::bin_of(value);
    ASSERT_TRUE(bin == before || bin == before + 1) << value;
    before = bin;
  }
  EXPECT_EQ(log_bins::bin_of(1e30F), log_bins::count - 1);
  EXPECT_EQ(log_bins::bin_of(log_bins::most), log_bins::count - 1);
}

TEST(BinCounts, QuantilesAreWithinOnePercent) {
  Dice dice(17);
  for (int trial = 0; trial < 200; ++trial) {
    BinCounts counts = one_place();
    std::vector<float> values(1 + dice.below(300));
    const double low = dice.magnitude(2e-3, 1e6), high = low * dice.magnitude(1, 1e6);
    for (float& value : values) {
      value = static_cast<float>(dice.magnitude(low, high));
      counts.at(0).add(2, value);
    }
    counts.settle();
    for (const double p : {0.0, 0.05, 0.5, 0.95, 0.99, 1.0}) {
      const double exact = exact_quantile(values, p);
      EXPECT_NEAR(quantile(counts, 0, 2, p, values.size()), exact, 0.00991 * exact) << p << " of " << values.size();
    }
  }
}

TEST(BinCounts, QuantitiesAndPlacesDoNotMix) {
  BinCounts counts(4);
  for (std::uint32_t place = 0; place < 100; ++place) {
    ASSERT_EQ(counts.new_place(), place);
    for (std::uint32_t which = 0; which < 4; ++which) {
      const auto value = static_cast<float>(place + 1) * std::pow(10.0F, static_cast<float>(which));
      for (int k = 0; k < 10; ++k) counts.at(place).add(which, value);
    }
    if (place % 7 == 0) counts.settle();
  }
  counts.settle();
  for (std::uint32_t place = 0; place < 100; ++place) {
    for (std::uint32_t which = 0; which < 4; ++which) {
      EXPECT_NEAR(quantile(counts, place, which, 0.5, 10) / ((place + 1) * std::pow(10.0, which)), 1, 0.01);
    }
  }
}

TEST(BinCounts, SmallValuesAreZeroAndLargeOnesStayInTheLastBin) {
  BinCounts counts = one_place();
  counts.at(0).add(0, 0);
  counts.at(0).add(0, 0.0009F);
  counts.at(0).add(3, 1e30F);
  counts.settle();
  EXPECT_EQ(quantile(counts, 0, 0, 1, 2), 0);
  EXPECT_NEAR(quantile(counts, 0, 3, 0.5, 1) / 0x1p80, 1, 0.01);
  counts.at(0).add(0, 4);
  counts.settle();
  EXPECT_EQ(quantile(counts, 0, 0, 0.5, 3), 0);
  EXPECT_NEAR(quantile(counts, 0, 0, 0.75, 3), 2, 0.02);
  EXPECT_NEAR(quantile(counts, 0, 0, 1, 3), 4, 0.04);
}

// Values close together and far apart, few and many, settled at different times: the results are equal to the last bit.
TEST(BinCounts, DoNotDependOnWhenTheyAreSettled) {
  Dice dice(18);
  for (int trial = 0; trial < 300; ++trial) {
    BinCounts now_and_then = one_place(), once = one_place();
    std::array<std::vector<float>, 4> values;
    for (int run = 0; run < 4; ++run) {
      const double low = dice.magnitude(1e-2, 1e6), high = low * dice.magnitude(1, dice.chance(0.3) ? 1e6 : 4);
      for (std::size_t k = dice.below(dice.chance(0.5) ? 12 : 1000); k > 0; --k) {
        const auto which = static_cast<std::uint32_t>(dice.below(4));
        const auto value = static_cast<float>(dice.magnitude(low, high));
        values[which].push_back(value);
        now_and_then.at(0).add(which, value);
        once.at(0).add(which, value);
      }
      now_and_then.settle();
    }
    ASSERT_TRUE(are_same(now_and_then, once));
    for (std::uint32_t which = 0; which < 4; ++which) {
      if (values[which].empty()) continue;
      const double exact = exact_quantile(values[which], 0.9);
      ASSERT_NEAR(quantile(once, 0, which, 0.9, values[which].size()), exact, 0.00991 * exact);
    }
  }
}

// Counts of many digits, added one by one and by merging, have the same bits.
TEST(BinCounts, CountsMillionsInOneBin) {
  BinCounts one_by_one = one_place(), merged = one_place(), part = one_place();
  for (int k = 0; k < 200'000; ++k) one_by_one.at(0).add(1, 5);
  for (int k = 0; k < 40'000; ++k) part.at(0).add(1, 5);
  part.settle();
  for (int k = 0; k < 5; ++k) merged.merge(0, part, 0);
  EXPECT_TRUE(are_same(merged, one_by_one));
  merged.at(0).add(1, 80);
  EXPECT_FALSE(are_same(merged, one_by_one));
  EXPECT_NEAR(quantile(merged, 0, 1, 0.5, 200'001), 5, 0.05);
  EXPECT_NEAR(quantile(merged, 0, 1, 0.999994, 200'001), 5, 0.05);
  EXPECT_NEAR(quantile(merged, 0, 1, 1, 200'001), 80, 0.8);
}

TEST(BinCounts, MergesToTheSameCountsFromAnySplit) {
  Dice dice(19);
  BinCounts whole = one_place();
  std::vector<BinCounts> parts(5);
  for (BinCounts& part : parts) part.new_place();
  for (int k = 0; k < 3000; ++k) {
    const auto which = static_cast<std::uint32_t>(dice.below(4));
    const auto value = static_cast<float>(dice.magnitude(1e-4, 1e7));
    whole.at(0).add(which, value);
    parts[dice.below(5)].at(0).add(which, value);
  }
  BinCounts forwards = one_place(), backwards = one_place();
  for (BinCounts& part : parts) part.settle();
  for (std::size_t k = 0; k < 5; ++k) {
    forwards.merge(0, parts[k], 0);
    backwards.merge(0, parts[4 - k], 0);
  }
  EXPECT_TRUE(are_same(forwards, whole));
  EXPECT_TRUE(are_same(backwards, whole));
}

// A few hundred values of four quantities within a factor of about ten: a typical map cell.
TEST(BinCounts, TakesLittleMemory) {
  Dice dice(20);
  BinCounts counts(4);
  constexpr std::uint32_t places = 1000;
  for (std::uint32_t place = 0; place < places; ++place) {
    counts.new_place();
    for (int k = 0; k < 200; ++k) {
      for (std::uint32_t which = 0; which < 4; ++which) {
        const double spread = 1 + 9 * dice.unit() * dice.unit();
        counts.at(place).add(which, static_cast<float>(std::pow(1e2, which) * spread));
      }
    }
  }
  counts.settle();
  EXPECT_LT(counts.bytes(), places * std::size_t{300});
}

}  // namespace
}  // namespace talus::bin_counts_test
