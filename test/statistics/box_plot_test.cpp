#include "talus/statistics/box_plot.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace talus::box_plot_test {
namespace {

// 1 ... 9 and 30, -20: quartiles 2.5 and 7.5 of the eleven, fences at -5 and 15.
const std::vector<double> sample{5, 30, 3, 8, 1, -20, 9, 2, 6, 4, 7};

void expect_the_sample(const BoxPlot& plot) {
  EXPECT_EQ(plot.lower_quartile, 2.5);
  EXPECT_EQ(plot.median, 5);
  EXPECT_EQ(plot.upper_quartile, 7.5);
  EXPECT_EQ(plot.lower_whisker, 1);
  EXPECT_EQ(plot.upper_whisker, 9);
  EXPECT_EQ(plot.outlier_count, 2u);
  EXPECT_EQ(plot.outliers, (std::vector<double>{-20, 30}));
}

TEST(BoxPlotOfASample, IsTukeys) { expect_the_sample(*box_plot(sample)); }

TEST(BoxPlotOfASketch, EqualsThatOfTheSampleWhileValuesAreKept) {
  QuantileSketch sketch(sample.size());
  for (const double x : sample) sketch.add(x);
  expect_the_sample(*box_plot(sketch));
}

TEST(BoxPlotOfASketch, IsCloseOnceValuesAreInBins) {
  std::mt19937_64 bits(1);
  std::normal_distribution<double> bell(10, 3);
  std::vector<double> values;
  QuantileSketch sketch(1'000'000);
  for (int i = 0; i < 50'000; ++i) {
    values.push_back(bell(bits));
    sketch.add(values.back());
  }
  const BoxPlot exact = *box_plot(values), near = *box_plot(sketch);
  const auto expect_near = [](double got, double expected) {
    EXPECT_NEAR(got, expected, 0.001 * std::abs(expected) + 0.01);
  };
  expect_near(near.lower_whisker, exact.lower_whisker);
  expect_near(near.lower_quartile, exact.lower_quartile);
  expect_near(near.median, exact.median);
  expect_near(near.upper_quartile, exact.upper_quartile);
  expect_near(near.upper_whisker, exact.upper_whisker);
  // 0.7 % of a normal distribution is beyond the fences.
  EXPECT_NEAR(static_cast<double>(exact.outlier_count), 350, 60);
  EXPECT_NEAR(static_cast<double>(near.outlier_count), static_cast<double>(exact.outlier_count), 10);
  EXPECT_EQ(exact.outliers.size(), exact.outlier_count);
  EXPECT_TRUE(near.outliers.empty());
}

TEST(BoxPlotOfASample, DoesNotCountAValueOnTheFenceAsAnOutlier) {
  // Quartiles 0 and 2, fence at 5.
  const BoxPlot plot = *box_plot(std::vector<double>{0, 0, 1, 2, 5});
  EXPECT_EQ(plot.upper_quartile, 2);
  EXPECT_EQ(plot.upper_whisker, 5);
  EXPECT_EQ(plot.outlier_count, 0u);
}

TEST(BoxPlotOfASample, OfOneOrEqualValuesIsALine) {
  EXPECT_EQ(box_plot(std::vector<double>{}), std::nullopt);
  EXPECT_EQ(box_plot(QuantileSketch(1)), std::nullopt);
  for (const std::vector<double>& values : {std::vector<double>{4}, std::vector<double>(9, 4.0)}) {
    const BoxPlot plot = *box_plot(values);
    EXPECT_EQ(plot.lower_whisker, 4);
    EXPECT_EQ(plot.median, 4);
    EXPECT_EQ(plot.upper_whisker, 4);
    EXPECT_EQ(plot.outlier_count, 0u);
  }
}

// For 0 0 0 10 the upper quartile is between the last value inside the fence and the outlier.
TEST(BoxPlotOfASample, NeverDrawsAWhiskerInsideItsBox) {
  const BoxPlot plot = *box_plot(std::vector<double>{0, 0, 0, 0, 100});
  EXPECT_EQ(plot.upper_quartile, 0);
  EXPECT_EQ(plot.upper_whisker, 0);
  EXPECT_EQ(plot.outliers, (std::vector<double>{100}));
  const BoxPlot wide = *box_plot(std::vector<double>{0, 0, 0, 10});
  EXPECT_EQ(wide.upper_quartile, 2.5);
  EXPECT_EQ(wide.upper_whisker, 2.5);
  EXPECT_EQ(wide.outliers, (std::vector<double>{10}));
}

}  // namespace
}  // namespace talus::box_plot_test
