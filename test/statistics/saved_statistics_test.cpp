// Saves sums, moments and quantiles and merges them again.

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "support/dice.hpp"
#include "support/saved.hpp"
#include "talus/statistics/bin_counts.hpp"
#include "talus/statistics/descriptive.hpp"
#include "talus/statistics/exact_sum.hpp"
#include "talus/statistics/fixed_sum.hpp"
#include "talus/statistics/quantile_sketch.hpp"

namespace talus::saved_statistics_test {
namespace {

using testing_tools::Dice;
using testing_tools::expect_damage_is_survived;
using testing_tools::expect_merged_parts_are_the_whole;
using testing_tools::saved;
using testing_tools::takes;

constexpr std::size_t part_count = 5;

/// Adds `count` values of `draw` to a whole, and each to one of five parts.
template <class T>
void fill(Dice& dice, std::size_t count, T& whole, std::vector<T>& parts, const auto& draw) {
  for (std::size_t k = 0; k < count; ++k) {
    const auto value = draw();
    whole.add(value);
    parts[dice.below(parts.size())].add(value);
  }
}

double anything(Dice& dice) {
  if (dice.chance(0.05)) return dice.chance(0.5) ? 0.0 : -0.0;
  return (dice.chance(0.3) ? -1 : 1) * dice.magnitude(1e-30, 1e30);
}

TEST(SavedStatistics, ExactSums) {
  Dice dice(1);
  ExactSum whole;
  std::vector<ExactSum> parts(part_count);
  fill(dice, 2000, whole, parts, [&] { return anything(dice); });
  const std::function<ExactSum()> empty = [] { return ExactSum(); };
  expect_merged_parts_are_the_whole(dice, whole, parts, empty);
  expect_damage_is_survived<ExactSum>(dice, saved(whole), empty, [](ExactSum& sum) { (void)sum.value(); });
}

TEST(SavedStatistics, EqualSumsOfDifferentTermsHaveEqualBytes) {
  ExactSum one, many;
  one.add(-3);
  for (int k = 0; k < 3000; ++k) many.add(-0.001953125);  // 2^-9
  many.add(-3 + 3000 * 0.001953125);
  EXPECT_EQ(saved(one), saved(many));
}

TEST(SavedStatistics, FixedSums) {
  Dice dice(2);
  FixedSum whole;
  std::vector<FixedSum> parts(part_count);
  fill(dice, 500, whole, parts, [&] { return dice.magnitude(1e-6, 1e21); });
  expect_merged_parts_are_the_whole<FixedSum>(dice, whole, parts, [] { return FixedSum(); });
}

/// Counts at one place, with the same add() as the others.
struct Bins {
  BinCounts counts{4};
  Bins() { counts.new_place(); }
  void add(float value) { counts.at(0).add(static_cast<std::uint32_t>(value) % 4, value); }
  void save(ByteWriter& out) {
    counts.settle();
    counts.save(0, out);
  }
  std::array<std::uint64_t, 4> merge_saved(ByteReader& in) { return counts.merge_saved(0, in); }
};

TEST(SavedStatistics, Bins) {
  Dice dice(3);
  Bins whole;
  std::vector<Bins> parts(part_count);
  fill(dice, 3000, whole, parts, [&] { return static_cast<float>(dice.magnitude(1e-4, 1e9)); });
  fill(dice, 200'000, whole, parts, [&] { return 5.0f; });  // a count of many digits
  const std::function<Bins()> empty = [] { return Bins(); };
  expect_merged_parts_are_the_whole(dice, whole, parts, empty);
  expect_damage_is_survived<Bins>(dice, saved(whole), empty, [](Bins& bins) {
    bins.counts.settle();
    double median = 0;
    bins.counts.quantiles(0, 1, 1000, std::array{0.5}, {&median, 1});
  });
}

TEST(SavedStatistics, BinsReturnTheirNumberOfValues) {
  Bins bins;
  for (int k = 0; k < 70'000; ++k) bins.counts.at(0).add(1, 12);
  bins.counts.at(0).add(3, 0);  // in no bin
  const std::string bytes = saved(bins);
  ByteReader in(bytes);
  EXPECT_EQ(Bins().merge_saved(in), (std::array<std::uint64_t, 4>{0, 70'000, 0, 0}));
}

TEST(SavedStatistics, Moments) {
  Dice dice(4);
  Moments whole;
  std::vector<Moments> parts(part_count);
  fill(dice, 500, whole, parts, [&] { return dice.chance(0.1) ? anything(dice) * 1e-20 : 2.6e6 + dice.unit(); });
  const std::function<Moments()> empty = [] { return Moments(); };
  expect_merged_parts_are_the_whole(dice, whole, parts, empty);
  expect_damage_is_survived<Moments>(dice, saved(whole), empty, [](Moments& m) { (void)m.describe(); });
}

void use_sketch(QuantileSketch& sketch) {
  for (const double p : {0.0, 0.25, 0.5, 0.999, 1.0}) (void)sketch.quantile(p);
  (void)sketch.ascending();
}

TEST(SavedStatistics, QuantilesOfFewValues) {
  Dice dice(5);
  constexpr std::uint64_t planned = 1000;
  QuantileSketch whole(planned);
  std::vector<QuantileSketch> parts(part_count, QuantileSketch(planned));
  fill(dice, 300, whole, parts, [&] { return anything(dice); });
  ASSERT_TRUE(whole.is_exact());
  const std::function<QuantileSketch()> empty = [] { return QuantileSketch(planned); };
  expect_merged_parts_are_the_whole(dice, whole, parts, empty);
  expect_damage_is_survived<QuantileSketch>(dice, saved(whole), empty, use_sketch);
}

TEST(SavedStatistics, QuantilesOfManyValues) {
  Dice dice(6);
  constexpr std::uint64_t planned = 10'000'000;
  QuantileSketch whole(planned);
  std::vector<QuantileSketch> parts(part_count, QuantileSketch(planned));
  fill(dice, 3000, whole, parts, [&] { return anything(dice); });
  ASSERT_FALSE(whole.is_exact());
  const std::function<QuantileSketch()> empty = [] { return QuantileSketch(planned); };
  expect_merged_parts_are_the_whole(dice, whole, parts, empty);
  expect_damage_is_survived<QuantileSketch>(dice, saved(whole), empty, use_sketch);
}

// More hits on a barrier than rocks: each part keeps its values, the whole is counted in bins.
TEST(SavedStatistics, QuantilesOfMoreValuesThanPlanned) {
  Dice dice(7);
  constexpr std::uint64_t planned = 50'000;
  QuantileSketch whole(planned);
  std::vector<QuantileSketch> parts(part_count, QuantileSketch(planned));
  fill(dice, 120'000, whole, parts, [&] { return dice.magnitude(1, 1e6); });
  ASSERT_FALSE(whole.is_exact());
  ASSERT_TRUE(parts[0].is_exact());
  expect_merged_parts_are_the_whole<QuantileSketch>(dice, whole, parts, [] { return QuantileSketch(planned); });
}

TEST(SavedStatistics, QuantilesOfAnotherPlanAreRefused) {
  QuantileSketch ten(10), eleven(11);
  ten.add(1);
  EXPECT_FALSE(takes(eleven, saved(ten)));
}

// The sign of the first zero must not show in the result.
TEST(SavedStatistics, TheSignOfAZeroIsNotKept) {
  for (const std::uint64_t planned : {10U, 1'000'000U}) {
    QuantileSketch one(planned), other(planned);
    Moments one_moments, other_moments;
    for (const double x : {0.0, -0.0, -0.0}) {
      one.add(x);
      one_moments.add(x);
      other.add(-x);
      other_moments.add(-x);
    }
    EXPECT_EQ(saved(one), saved(other));
    EXPECT_EQ(saved(one_moments), saved(other_moments));
    EXPECT_FALSE(std::signbit(*other.quantile(0.5)));
  }
}

}  // namespace
}  // namespace talus::saved_statistics_test
