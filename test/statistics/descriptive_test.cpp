#include "talus/statistics/descriptive.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace talus::descriptive_test {
namespace {

// The definitions, term by term, in long double.
struct Direct {
  long double mean = 0, variance = 0, skewness = 0, kurtosis = 0;
};

Direct directly(const std::vector<double>& sample) {
  const auto n = static_cast<long double>(sample.size());
  Direct result;
  for (const double x : sample) result.mean += x / n;
  long double m2 = 0, m3 = 0, m4 = 0;
  for (const double x : sample) {
    const long double d = x - result.mean;
    m2 += d * d;
    m3 += d * d * d;
    m4 += d * d * d * d;
  }
  result.variance = m2 / (n - 1);
  const long double s = std::sqrt(result.variance);
  result.skewness = n / ((n - 1) * (n - 2)) * m3 / (s * s * s);
  result.kurtosis =
      n * (n + 1) / ((n - 1) * (n - 2) * (n - 3)) * m4 / (s * s * s * s) - 3 * (n - 1) * (n - 1) / ((n - 2) * (n - 3));
  return result;
}

void expect_agreement(const std::vector<double>& sample, double tolerance) {
  const Descriptive rows = describe(sample);
  const Direct direct = directly(sample);
  const auto near = [&](double got, long double wanted) {
    const auto expected = static_cast<double>(wanted);
    EXPECT_NEAR(got, expected, tolerance * std::max(1.0, std::abs(expected)));
  };
  near(*rows.mean, direct.mean);
  near(*rows.sample_variance / static_cast<double>(direct.variance), 1);
  near(*rows.skewness, direct.skewness);
  near(*rows.kurtosis, direct.kurtosis);
}

// 2 4 4 4 5 5 7 9: n = 8, mean 5, sum of squares 32, of cubes 42, of fourth powers 356.
TEST(DescriptiveStatistics, OfAHandComputedSample) {
  const Descriptive rows = describe(std::vector<double>{4, 9, 2, 4, 5, 4, 7, 5});
  EXPECT_DOUBLE_EQ(*rows.mean, 5);
  EXPECT_DOUBLE_EQ(*rows.median, 4.5);
  EXPECT_DOUBLE_EQ(*rows.sample_variance, 32.0 / 7);
  EXPECT_DOUBLE_EQ(*rows.standard_deviation, std::sqrt(32.0 / 7));
  EXPECT_DOUBLE_EQ(*rows.standard_error, std::sqrt(32.0 / 7 / 8));
  EXPECT_DOUBLE_EQ(*rows.skewness, 8.0 / (7 * 6) * 42 / std::pow(32.0 / 7, 1.5));
  EXPECT_NEAR(*rows.kurtosis, 8.0 * 9 / (7 * 6 * 5) * 356 / (32.0 / 7 * 32 / 7) - 3.0 * 49 / (6 * 5), 1e-14);
  EXPECT_EQ(*rows.range, 7);
  EXPECT_EQ(*rows.minimum, 2);
  EXPECT_EQ(*rows.maximum, 9);
  EXPECT_EQ(rows.sum, 40);
  EXPECT_EQ(rows.count, 8u);
  // Table of Student's t: 2.3646 for 7 degrees of freedom.
  EXPECT_NEAR(*rows.confidence_half_width_95, 2.36462425 * std::sqrt(4.0 / 7), 1e-8);
}

// The example in the documentation of spreadsheets' SKEW and KURT: 3 4 5 2 3 4 5 6 4 7.
TEST(DescriptiveStatistics, OfTheSpreadsheetsOwnExample) {
  const Descriptive rows = describe(std::vector<double>{3, 4, 5, 2, 3, 4, 5, 6, 4, 7});
  EXPECT_NEAR(*rows.skewness, 0.359543071, 1e-9);
  EXPECT_NEAR(*rows.kurtosis, -0.151799637, 1e-9);
}

TEST(DescriptiveStatistics, AgreeWithTheDefinitionsInLongDouble) {
  std::mt19937_64 bits(1);
  std::normal_distribution<double> bell(15, 4.4);
  std::exponential_distribution<double> tail(0.01);
  std::vector<double> symmetric, skewed, few{1, 2, 3, 10};
  for (int i = 0; i < 5000; ++i) {
    symmetric.push_back(bell(bits));
    skewed.push_back(-tail(bits));
  }
  expect_agreement(few, 1e-15);
  expect_agreement(symmetric, 1e-13);
  expect_agreement(skewed, 1e-13);
}

// Central moments do not change if an offset is added with which every value is still exact.
TEST(DescriptiveStatistics, AreExactFarFromZero) {
  std::mt19937_64 bits(2);
  std::vector<double> near, far;
  for (int i = 0; i < 1000; ++i) {
    const double x = std::ldexp(static_cast<double>(bits() >> 52), -29);  // 12 bits: up to 7.6e-6
    near.push_back(x);
    far.push_back(x + 4'000'000);
  }
  const Descriptive here = describe(near), there = describe(far);
  EXPECT_DOUBLE_EQ(*there.sample_variance, *here.sample_variance);
  EXPECT_DOUBLE_EQ(*there.skewness, *here.skewness);
  EXPECT_DOUBLE_EQ(*there.kurtosis, *here.kurtosis);
  expect_agreement(near, 1e-13);
}

TEST(DescriptiveStatistics, AreEmptyIfTheSampleIsTooSmall) {
  const Descriptive none = describe(std::vector<double>{});
  EXPECT_EQ(none.count, 0u);
  EXPECT_EQ(none.sum, 0);
  EXPECT_FALSE(none.mean || none.median || none.minimum || none.maximum || none.range || none.standard_error);

  const Descriptive one = describe(std::vector<double>{7});
  EXPECT_EQ(one.mean, 7);
  EXPECT_EQ(one.median, 7);
  EXPECT_EQ(one.range, 0);
  EXPECT_FALSE(one.sample_variance || one.standard_deviation || one.standard_error || one.confidence_half_width_95);

  const Descriptive two = describe(std::vector<double>{7, 9});
  EXPECT_EQ(two.sample_variance, 2);
  EXPECT_EQ(two.median, 8);
  EXPECT_FALSE(two.skewness || two.kurtosis);

  const Descriptive three = describe(std::vector<double>{7, 9, 10});
  EXPECT_TRUE(three.skewness);
  EXPECT_FALSE(three.kurtosis);
  EXPECT_TRUE(describe(std::vector<double>{7, 9, 10, 12}).kurtosis);
}

TEST(DescriptiveStatistics, OfEqualValuesHaveNoShape) {
  const Descriptive rows = describe(std::vector<double>(1000, 0.1));
  EXPECT_EQ(rows.mean, 0.1);
  EXPECT_EQ(rows.sample_variance, 0);
  EXPECT_EQ(rows.standard_error, 0);
  EXPECT_EQ(rows.confidence_half_width_95, 0);
  EXPECT_FALSE(rows.skewness || rows.kurtosis) << "a spreadsheet divides by zero here";
}

// Two neighbouring doubles have the smallest possible spread: skewness 0 by symmetry, and the kurtosis of a coin.
TEST(DescriptiveStatistics, ResolveNeighbouringDoubles) {
  const double x = 2'600'000.1;
  const Descriptive rows = describe(std::vector<double>{x, std::nextafter(x, 1e9), x, std::nextafter(x, 1e9)});
  EXPECT_NEAR(*rows.skewness, 0, 1e-9);
  EXPECT_NEAR(*rows.kurtosis, -6, 1e-9);
}

TEST(DescriptiveMoments, HaveTheSameBitsInAnyOrderAndSplit) {
  std::mt19937_64 bits(3);
  std::normal_distribution<double> bell(49.17, 0.25);
  std::vector<double> sample;
  for (int i = 0; i < 4000; ++i) sample.push_back(bell(bits));
  const Descriptive whole = describe(sample);
  for (const std::size_t parts : {1u, 2u, 8u, 64u}) {
    std::shuffle(sample.begin(), sample.end(), bits);
    std::vector<Moments> moments(parts);
    for (const double x : sample) moments[bits() % parts].add(x);
    Moments merged;
    for (const Moments& part : moments) merged.merge(part);
    const Descriptive rows = merged.describe();
    EXPECT_EQ(merged.count(), 4000u);
    EXPECT_EQ(rows.mean, whole.mean);
    EXPECT_EQ(rows.sum, whole.sum);
    EXPECT_EQ(rows.sample_variance, whole.sample_variance);
    EXPECT_EQ(rows.standard_error, whole.standard_error);
    EXPECT_EQ(rows.skewness, whole.skewness);
    EXPECT_EQ(rows.kurtosis, whole.kurtosis);
    EXPECT_EQ(rows.minimum, whole.minimum);
    EXPECT_EQ(rows.maximum, whole.maximum);
    EXPECT_EQ(rows.median, std::nullopt);
    EXPECT_EQ(merged.describe(49.0).median, 49.0);
  }
}

TEST(DescriptiveMoments, MergeWithEmptyOnesEitherWay) {
  Moments some;
  some.add(-3);
  some.add(-5);
  Moments merged;
  merged.merge(some);
  merged.merge(Moments());
  EXPECT_EQ(merged.describe().minimum, -5);
  EXPECT_EQ(merged.describe().maximum, -3);
  EXPECT_EQ(merged.describe().mean, -4);
  EXPECT_EQ(merged.count(), 2u);
}

// The 97.5 % column of any printed table.
TEST(DescriptiveStudentT, AgreesWithPrintedTables) {
  EXPECT_NEAR(student_t_975(1), 12.7062, 5e-5);
  EXPECT_NEAR(student_t_975(2), 4.3027, 5e-5);
  EXPECT_NEAR(student_t_975(10), 2.2281, 5e-5);
  EXPECT_NEAR(student_t_975(49), 2.0096, 5e-5);
  EXPECT_NEAR(student_t_975(1'000'000'000), 1.95996, 5e-6);
}

}  // namespace
}  // namespace talus::descriptive_test
