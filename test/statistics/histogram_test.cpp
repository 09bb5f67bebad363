#include "talus/statistics/histogram.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace talus::histogram_test {
namespace {

std::vector<double> all_edges(const BinEdges& edges) {
  std::vector<double> list;
  for (std::uint64_t i = 0; i <= edges.bins; ++i) list.push_back(edges.edge(i));
  return list;
}

TEST(HistogramNiceBins, HaveRoundEdges) {
  EXPECT_EQ(all_edges(nice_bins(0, 10, 10)), (std::vector<double>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10}));
  EXPECT_EQ(all_edges(nice_bins(0, 10, 9)), (std::vector<double>{0, 2, 4, 6, 8, 10}));
  EXPECT_EQ(all_edges(nice_bins(4.93, 18.64, 5)), (std::vector<double>{0, 5, 10, 15, 20}));
  EXPECT_EQ(all_edges(nice_bins(-0.15, 0.42, 10)), (std::vector<double>{-0.2, -0.1, 0, 0.1, 0.2, 0.3, 0.4, 0.5}))
      << "each edge is the double nearest to its decimal";
  EXPECT_EQ(all_edges(nice_bins(-3e6, 2.5e6, 3)), (std::vector<double>{-5e6, 0, 5e6}));
}

TEST(HistogramNiceBins, CoverTheRangeWithTheNarrowestStepThatFits) {
  std::mt19937_64 bits(1);
  std::uniform_real_distribution<double> exponent(-6, 7), part(-1, 1);
  for (int i = 0; i < 5000; ++i) {
    double least = part(bits) * std::pow(10, exponent(bits)), most = part(bits) * std::pow(10, exponent(bits));
    if (least > most) std::swap(least, most);
    const std::uint64_t most_bins = 2 + bits() % 60;
    const BinEdges edges = nice_bins(least, most, most_bins);
    ASSERT_LE(edges.bins, most_bins);
    ASSERT_LE(edges.edge(0), least);
    ASSERT_GT(edges.edge(1), least) << "no bin is empty for nothing";
    ASSERT_GE(edges.edge(edges.bins), most);
    if (edges.bins > 1) {
      ASSERT_LT(edges.edge(edges.bins - 1), most);
    }
    // The next narrower step would need more bins.
    BinEdges narrower = edges;
    narrower.step_digit = edges.step_digit == 1 ? 5 : edges.step_digit == 2 ? 1 : 2;
    narrower.step_exponent -= edges.step_digit == 1 ? 1 : 0;
    const double step = narrower.step_digit * std::pow(10, narrower.step_exponent);
    ASSERT_GT(std::ceil(most / step - 1e-6) - std::floor(least / step + 1e-6), static_cast<double>(most_bins) - 1e-6);
  }
}

TEST(HistogramNiceBins, AreDistinctForARangeWithoutWidth) {
  for (const double x : {0.0, 3.0, -3.0, 2'600'000.1, 1e-9, 1e90}) {
    for (const double wider : {x, std::nextafter(x, 1e99)}) {
      const BinEdges edges = nice_bins(x, wider, 20);
      EXPECT_LE(edges.edge(0), x);
      EXPECT_GE(edges.edge(edges.bins), wider);
      for (std::uint64_t i = 0; i < edges.bins; ++i) EXPECT_LT(edges.edge(i), edges.edge(i + 1)) << x;
    }
  }
}

TEST(HistogramCounts, CountAnEdgeInTheBinAboveItAndTheLastEdgeInTheLastBin) {
  Histogram histogram(nice_bins(0, 1, 10));
  for (int i = 0; i <= 10; ++i) histogram.add(i / 10.0);
  EXPECT_EQ(histogram.counts(), (std::vector<std::uint64_t>{1, 1, 1, 1, 1, 1, 1, 1, 1, 2}));
  EXPECT_EQ(histogram.underflow() + histogram.overflow(), 0u);
}

TEST(HistogramCounts, CountValuesOutside) {
  Histogram histogram(nice_bins(0, 1, 10));
  for (const double x : {-1e-300, -5.0, 0.5, std::nextafter(1.0, 2.0), 7.0, 8.0}) histogram.add(x);
  EXPECT_EQ(histogram.underflow(), 2u);
  EXPECT_EQ(histogram.overflow(), 3u);
  EXPECT_EQ(histogram.total(), 6u);
}

TEST(HistogramCounts, AreExactAtTheEdges) {
  for (const BinEdges& edges :
       {nice_bins(-0.15, 0.42, 50), nice_bins(2'600'000, 2'600'007, 70), nice_bins(1e-7, 9e-7, 33)}) {
    for (std::uint64_t i = 0; i < edges.bins; ++i) {
      for (const double x : {edges.edge(i), std::nextafter(edges.edge(i + 1), -1e300)}) {
        Histogram histogram(edges);
        histogram.add(x);
        ASSERT_EQ(histogram.counts()[i], 1u) << x;
      }
    }
  }
}

TEST(HistogramMerge, IsTheSameForAnySplit) {
  const BinEdges edges = nice_bins(-3, 3, 30);
  std::mt19937_64 bits(2);
  std::normal_distribution<double> bell(0, 1.5);
  Histogram whole(edges), left(edges), right(edges);
  for (int i = 0; i < 10'000; ++i) {
    const double x = bell(bits);
    whole.add(x);
    (i % 3 == 0 ? left : right).add(x);
  }
  right.merge(left);
  EXPECT_EQ(right.counts(), whole.counts());
  EXPECT_EQ(right.underflow(), whole.underflow());
  EXPECT_EQ(right.overflow(), whole.overflow());
  EXPECT_GT(whole.underflow(), 0u);
  EXPECT_GT(whole.overflow(), 0u);
  EXPECT_EQ(whole.total(), 10'000u);
  EXPECT_EQ(right.edges(), edges);
}

/// Random numbers in about 40 bins.
Histogram of(const std::vector<double>& numbers) {
  const auto [least, most] = std::minmax_element(numbers.begin(), numbers.end());
  Histogram histogram(nice_bins(*least, *most, 40));
  for (const double x : numbers) histogram.add(x);
  return histogram;
}

TEST(HistogramCommonBins, HaveTheWiderStepOrTheNarrowestMadeOfWholeBinsOfBoth) {
  // Steps of 2 and 5 give steps of 10.
  EXPECT_EQ(all_edges(common_bins({3, 2, 0, 5}, {0, 5, 0, 4}, 50)), (std::vector<double>{0, 10, 20}));
  EXPECT_EQ(all_edges(common_bins({-3, 1, -1, 9}, {0, 5, -1, 1}, 50)), (std::vector<double>{-0.5, 0, 0.5, 1}));
  EXPECT_EQ(common_bins({0, 1, 0, 10}, {0, 1, 0, 10}, 50), (BinEdges{0, 1, 0, 10})) << "equal ones stay";
}

TEST(HistogramCommonBins, CountEveryValueInItsBin) {
  std::mt19937_64 bits(7);
  std::uniform_real_distribution<double> exponent(-4, 6), part(-1, 1);
  for (int i = 0; i < 500; ++i) {
    const auto numbers = [&] {
      const double middle = part(bits) * std::pow(10, exponent(bits)), width = std::pow(10, exponent(bits));
      std::vector<double> list(1 + bits() % 50);
      for (double& x : list) x = middle + part(bits) * width;
      return list;
    };
    const std::vector<double> first = numbers(), second = numbers();
    const Histogram a = of(first), b = of(second);
    const BinEdges edges = common_bins(a.edges(), b.edges(), 50);
    ASSERT_LE(edges.bins, 50u);
    const auto expect_counted = [&](const Histogram& histogram, const std::vector<double>& list) {
      const Histogram wide = histogram.regrouped(edges);
      ASSERT_EQ(wide.total(), list.size());
      for (std::uint64_t k = 0; k < edges.bins; ++k) {
        const auto inside =
            std::ranges::count_if(list, [&](double x) { return x >= edges.edge(k) && (x < edges.edge(k + 1)); });
        ASSERT_EQ(wide.counts()[k], static_cast<std::uint64_t>(inside)) << k;
      }
    };
    // A value on its histogram's last edge is counted below it: none of these is.
    expect_counted(a, first);
    expect_counted(b, second);
  }
}

TEST(HistogramCommonBins, AreFewForSingleValuesFarApart) {
  const Histogram a = of({50.0, 50.0}), b = of({1e6});
  const BinEdges edges = common_bins(a.edges(), b.edges(), 50);
  EXPECT_LE(edges.bins, 50u);
  EXPECT_GE(edges.bins, 20u);
  EXPECT_EQ(a.regrouped(edges).counts().front(), 2u);
  EXPECT_EQ(b.regrouped(edges).total(), 1u);
}

TEST(HistogramBinsFrom, FindsTheEdgesThatNiceBinsGave) {
  std::mt19937_64 bits(3);
  std::uniform_real_distribution<double> exponent(-6, 7), part(-1, 1);
  for (int i = 0; i < 5000; ++i) {
    double least = part(bits) * std::pow(10, exponent(bits)), most = part(bits) * std::pow(10, exponent(bits));
    if (least > most) std::swap(least, most);
    const BinEdges edges = nice_bins(least, most, 40);
    const double low = edges.edge(0), width = (edges.edge(edges.bins) - low) / static_cast<double>(edges.bins);
    ASSERT_EQ(bins_from(low, width, edges.bins), edges);
  }
  EXPECT_EQ(bins_from(0, 3, 5), std::nullopt);
  EXPECT_EQ(bins_from(0, 0, 5), std::nullopt);
  EXPECT_EQ(bins_from(std::nan(""), 1, 5), std::nullopt);
}

}  // namespace
}  // namespace talus::histogram_test
