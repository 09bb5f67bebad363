#include "talus/statistics/quantile_sketch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "talus/statistics/quantile.hpp"

namespace talus::quantile_sketch_test {
namespace {

constexpr std::uint64_t many = 1'000'000;

QuantileSketch sketch_of(const std::vector<double>& values, std::uint64_t planned) {
  QuantileSketch sketch(planned);
  for (const double x : values) sketch.add(x);
  return sketch;
}

double exact_quantile(std::vector<double> values, double p) {
  std::sort(values.begin(), values.end());
  const auto place = p * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(std::floor(place));
  const auto above = std::min(below + 1, values.size() - 1);
  return values[below] + (place - static_cast<double>(below)) * (values[above] - values[below]);
}

std::vector<double> mixed_values(std::size_t count) {
  std::mt19937_64 bits(1);
  std::normal_distribution<double> bell(0, 1);
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i) {
    values.push_back(i % 10 == 0 ? 0.0 : bell(bits) * std::exp(3 * bell(bits)));
  }
  return values;
}

TEST(QuantileSketchOfFew, IsTheSpreadsheetsPercentile) {
  // PERCENTILE of 15 20 35 40 50: at 0.4 it is 20 + 0.6 x 15.
  const QuantileSketch sketch = sketch_of({50, 15, 40, 20, 35}, 5);
  EXPECT_TRUE(sketch.is_exact());
  EXPECT_EQ(sketch.count(), 5u);
  EXPECT_EQ(sketch.quantile(0), 15);
  EXPECT_EQ(sketch.quantile(0.25), 20);
  EXPECT_DOUBLE_EQ(*sketch.quantile(0.4), 29);
  EXPECT_EQ(sketch.quantile(0.5), 35);
  EXPECT_DOUBLE_EQ(*sketch.quantile(0.95), 48);
  EXPECT_EQ(sketch.quantile(1), 50);
}

TEST(QuantileSketchOfFew, HasNoQuantilesWithoutValues) {
  EXPECT_EQ(QuantileSketch(10).quantile(0.5), std::nullopt);
  EXPECT_EQ(QuantileSketch(many).quantile(0.5), std::nullopt);
  EXPECT_EQ(sketch_of({3}, 1).quantile(0.7), 3);
  EXPECT_EQ(sketch_of({3}, many).quantile(0.7), 3);
}

TEST(QuantileSketchOfMany, IsWithinItsErrorForValuesOfAnySignAndSize) {
  const std::vector<double> values = mixed_values(120'001);
  const QuantileSketch sketch = sketch_of(values, many);
  EXPECT_FALSE(sketch.is_exact());
  for (const double p : {0.001, 0.01, 0.05, 0.25, 0.4, 0.5, 0.6, 0.75, 0.95, 0.99, 0.999}) {
    const double expected = exact_quantile(values, p);
    EXPECT_NEAR(*sketch.quantile(p), expected, 0.0005 * std::abs(expected)) << p;
  }
  EXPECT_EQ(sketch.quantile(0), *std::min_element(values.begin(), values.end()));
  EXPECT_EQ(sketch.quantile(1), *std::max_element(values.begin(), values.end()));
}

TEST(QuantileSketchOfMany, KeepsItsErrorBoundForEveryValue) {
  for (double x = 1e-12; x < 1e24; x *= 1.0173) {
    for (const double value : {x, -x}) {
      // Between two distant values, so that the exact extremes do not help.
      const QuantileSketch sketch = sketch_of({-1e25, value, 1e25}, many);
      ASSERT_NEAR(*sketch.quantile(0.5), value, 0.0005 * x);
    }
  }
}

TEST(QuantileSketchOfMany, ResolvesPositionsNearItsOrigin) {
  QuantileSketch sketch(many, 652288);
  std::vector<double> values;
  for (int k = 0; k <= 2000; ++k) values.push_back(652100 + 0.1 * k);
  for (const double x : values) sketch.add(x);
  for (const double p : {0.01, 0.25, 0.5, 0.75, 0.99}) {
    const double expected = exact_quantile(values, p);
    EXPECT_NEAR(*sketch.quantile(p), expected, 0.0005 * std::abs(expected - 652288)) << p;
  }
  EXPECT_EQ(sketch.quantile(0), 652100);
  EXPECT_EQ(sketch.quantile(1), 652300);
  const auto counted = sketch.ascending();
  EXPECT_GT(counted.size(), 1000U);
  EXPECT_TRUE(std::is_sorted(counted.begin(), counted.end(), [](auto a, auto b) { return a.value < b.value; }));
}

TEST(QuantileSketchOfFew, IsTheSameWithAnyOrigin) {
  const std::vector<double> values = mixed_values(1000);
  QuantileSketch with_origin(1000, 652288);
  for (const double x : values) with_origin.add(x);
  for (const double p : {0.0, 0.01, 0.5, 0.99}) {
    EXPECT_EQ(with_origin.quantile(p), sketch_of(values, 1000).quantile(p));
  }
}

TEST(QuantileSketchOfMany, CountsTinyValuesAsZeroAndHugeOnesInTheLastBin) {
  EXPECT_EQ(sketch_of({-1, 1e-13, 1}, many).quantile(0.5), 0);
  EXPECT_EQ(sketch_of({-1, -1e-13, 1}, many).quantile(0.5), 0);
  const QuantileSketch huge = sketch_of({1, 1e30, 1e40}, many);
  EXPECT_GE(*huge.quantile(0.5), 1e24);
  EXPECT_EQ(huge.quantile(1), 1e40);
}

TEST(QuantileSketchOfMany, InterpolatesBetweenTheTwoMiddleValues) {
  const QuantileSketch sketch = sketch_of({-100, 10, 20, 100}, many);
  EXPECT_NEAR(*sketch.quantile(0.5), 15, 0.0005 * 15);
}

// Compares the quantiles, and the ascending counts behind them.
void expect_same(const QuantileSketch& a, const QuantileSketch& b) {
  ASSERT_EQ(a.is_exact(), b.is_exact());
  ASSERT_EQ(a.count(), b.count());
  const auto left = a.ascending(), right = b.ascending();
  ASSERT_EQ(left.size(), right.size());
  for (std::size_t i = 0; i < left.size(); ++i) {
    ASSERT_EQ(left[i].value, right[i].value);
    ASSERT_EQ(left[i].count, right[i].count);
  }
  for (const double p : {0.0, 0.1, 0.5, 0.95, 1.0}) ASSERT_EQ(a.quantile(p), b.quantile(p));
}

TEST(QuantileSketchMerge, IsTheSameForAnySplitAndOrder) {
  std::mt19937_64 bits(2);
  // Exact; in bins from the start; in bins because more values came than planned; and exactly at the limit.
  for (const auto& [count, planned] : {std::pair<std::size_t, std::uint64_t>{20'000, 20'000},
                                       {20'000, many},
                                       {300, many},
                                       {2000, many},
                                       {150'000, 50'000},
                                       {QuantileSketch::most_exact, QuantileSketch::most_exact},
                                       {QuantileSketch::most_exact + 1, QuantileSketch::most_exact}}) {
    std::vector<double> values = mixed_values(count);
    const QuantileSketch whole = sketch_of(values, planned);
    EXPECT_EQ(whole.is_exact(), count <= QuantileSketch::most_exact && planned <= QuantileSketch::most_exact);
    for (const std::size_t parts : {2u, 7u}) {
      std::shuffle(values.begin(), values.end(), bits);
      std::vector<QuantileSketch> sketches(parts, QuantileSketch(planned));
      // Uneven, so that some parts are in bins while others are not.
      for (const double x : values) sketches[bits() % 10 == 0 ? bits() % parts : 0].add(x);
      QuantileSketch forwards(planned), backwards(planned);
      for (std::size_t i = 0; i < parts; ++i) {
        forwards.merge(sketches[i]);
        backwards.merge(sketches[parts - 1 - i]);
      }
      expect_same(forwards, whole);
      expect_same(backwards, whole);
    }
  }
}

// The first few values wait before they are put into bins; answers must not depend on that.
TEST(QuantileSketchOfMany, AnswersTheSameBeforeAndAfterBinning) {
  for (const std::size_t count : {1U, 2U, 300U, 512U, 513U}) {
    const QuantileSketch few = sketch_of(mixed_values(count), many);
    EXPECT_FALSE(few.is_exact());
    ByteWriter out;
    few.save(out);
    const std::string bytes = out.take();
    ByteReader in(bytes);
    QuantileSketch in_bins(many);
    in_bins.merge_saved(in);
    expect_same(few, in_bins);
    ByteWriter again;
    in_bins.save(again);
    EXPECT_EQ(again.take(), bytes);
  }
}

TEST(QuantileSketchAscending, CountsEachValueOnceInOrder) {
  for (const std::uint64_t planned : {std::uint64_t{5}, many}) {
    const auto counted = sketch_of({2, -2, 0, 2, -4}, planned).ascending();
    ASSERT_EQ(counted.size(), 4u);
    const std::vector<std::pair<double, std::uint64_t>> expected{{-4, 1}, {-2, 1}, {0, 1}, {2, 2}};
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_NEAR(counted[i].value, expected[i].first, 0.0005 * std::abs(expected[i].first));
      EXPECT_EQ(counted[i].count, expected[i].second);
    }
  }
}

TEST(QuantilePlaceInASample, IsDefinition7) {
  EXPECT_EQ(quantile_place(0.5, 4).rank, 1u);
  EXPECT_EQ(quantile_place(0.5, 4).fraction, 0.5);
  EXPECT_EQ(quantile_place(1, 4).rank, 3u);
  EXPECT_EQ(quantile_place(1, 4).fraction, 0);
  EXPECT_EQ(quantile_place(0.3, 1).rank, 0u);
  EXPECT_EQ(quantile_place(0.3, 1).fraction, 0);
  EXPECT_EQ(between(0.1, 0.1, 0.7), 0.1);
}

}  // namespace
}  // namespace talus::quantile_sketch_test
