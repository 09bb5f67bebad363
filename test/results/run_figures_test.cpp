#include "talus/results/run_figures.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace talus::run_figures_test {
namespace {

TEST(RunFigure, HasAText) {
  EXPECT_EQ((RunFigure{FigureOf::runout, 95}).text(), "95th percentile of the runout on plan");
  EXPECT_EQ((RunFigure{FigureOf::energy, 99.5}).text(), "99.5th percentile of the total kinetic energy at the line");
  EXPECT_EQ((RunFigure{FigureOf::height, 1}).text(), "1st percentile of the height of the block's top at the line");
  EXPECT_EQ((RunFigure{FigureOf::height, 12}).text(), "12th percentile of the height of the block's top at the line");
  EXPECT_EQ((RunFigure{FigureOf::share}).text(), "share of rocks that reach the line");
}

TEST(FigureQuantities, AreInTheOrderOfTheirEnumeration) {
  for (const FigureQuantity& each : figure_quantities) EXPECT_EQ(quantity_of(each.of).word, each.word);
}

FigureTally hundred_rocks() {
  FigureTally tally(2, 100);
  for (int i = 0; i <= 100; ++i) tally.add(RockValues{.runout = i * 1.0, .max_energy = i * 10.0, .max_bounce = 1});
  for (int i = 0; i < 25; ++i) tally.add(1, {.energy = i * 1000.0, .velocity = 3, .height = 0.5});
  return tally;
}

TEST(FigureTally, EstimatesPercentilesAndShares) {
  const FigureTally tally = hundred_rocks();
  EXPECT_EQ(tally.estimate({FigureOf::runout, 50}, 0.95)->value, 50);
  EXPECT_EQ(tally.estimate({FigureOf::max_energy, 95}, 0.95)->value, 950);
  EXPECT_NEAR(tally.estimate({FigureOf::share, 0, 1}, 0.95)->value, 25.0 / 101, 1e-12);
  EXPECT_NEAR(tally.estimate({FigureOf::share, 0, 1}, 0.95, 50)->value, 0.5, 1e-12);
  EXPECT_EQ(tally.estimate({FigureOf::energy, 50, 1}, 0.95)->value, 12000);
  EXPECT_FALSE(tally.estimate({FigureOf::energy, 95, 1}, 0.95)->high);  // takes 72 values
  EXPECT_EQ(tally.estimate({FigureOf::share, 0, 0}, 0.95)->value, 0);
  EXPECT_FALSE(tally.estimate({FigureOf::velocity, 95, 0}, 0.95));
}

TEST(RocksNeeded, FallsWithTheSquareOfThePrecision) {
  const RunFigure figure{FigureOf::runout, 95};
  const Estimate twenty{.value = 100, .low = 85, .high = 120}, five{.value = 100, .low = 96, .high = 105};
  EXPECT_EQ(rocks_needed(figure, twenty, 1000, 1000, 0.95, 0.1), 4000u);
  EXPECT_EQ(rocks_needed(figure, five, 1000, 1000, 0.95, 0.1), 250u);
  // Without an upper end: 72 values, of which one rock in ten gives one.
  const Estimate open{.value = 100, .low = 95, .high = {}};
  EXPECT_EQ(rocks_needed(figure, open, 200, 20, 0.95, 0.1), 720u);
  EXPECT_FALSE(rocks_needed(figure, {.value = 0, .low = 0, .high = 0}, 1000, 1000, 0.95, 0.1));
}

// The variance of a median of n exponential values is p (1 - p) / (n f^2) = 1/n for large n.
TEST(SamplingVariance, IsThatOfRepeatedSamples) {
  std::mt19937_64 engine(5);
  const auto exponential = [&] { return -std::log((static_cast<double>(engine() >> 11) + 0.5) * 0x1p-53); };
  constexpr int samples = 400, n = 200;
  double mean = 0, square = 0, estimated = 0;
  for (int k = 0; k < samples; ++k) {
    FigureTally tally(0, n);
    for (int i = 0; i < n; ++i) tally.add(RockValues{exponential(), 0, 0});
    const double median = tally.estimate({FigureOf::runout, 50}, 0.95)->value;
    mean += median / samples;
    square += median * median / samples;
    estimated += *tally.sampling_variance({FigureOf::runout, 50}) / samples;
  }
  EXPECT_NEAR(estimated, 1.0 / n, 0.15 / n);
  EXPECT_NEAR(square - mean * mean, estimated, 0.2 / n);
}

TEST(SamplingVariance, OfAShareIsBinomial) {
  const FigureTally tally = hundred_rocks();
  const double p = 25.0 / 101;
  EXPECT_NEAR(*tally.sampling_variance({FigureOf::share, 0, 1}), p * (1 - p) / 100, 1e-15);
  EXPECT_EQ(*tally.sampling_variance({FigureOf::velocity, 95, 1}), 0);
  EXPECT_FALSE(tally.sampling_variance({FigureOf::velocity, 95, 0}));
}

}  // namespace
}  // namespace talus::run_figures_test
