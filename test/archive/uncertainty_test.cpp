#include "talus/archive/uncertainty.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/dice.hpp"

namespace talus {
namespace {

double normal_draw(testing_tools::Dice& dice) {
  return std::sqrt(-2 * std::log(1 - dice.unit())) * std::cos(2 * std::numbers::pi * dice.unit());
}

/// Runouts normal about 100 m + a shift of each ensemble (standard deviation `of_parameters`), with one of 10 m.
Uncertainty ensembles_with(double of_parameters, std::uint64_t ensembles = 200, std::uint64_t rocks_each = 50) {
  testing_tools::Dice dice(7);
  std::vector<double> shift;
  for (std::uint64_t k = 0; k < ensembles; ++k) shift.push_back(of_parameters * normal_draw(dice));
  UncertaintyCount count(ensembles * rocks_each, ensembles, {"Road"});
  for (std::uint64_t rock = 0; rock < ensembles * rocks_each; ++rock) {
    const double runout = 100 + shift[rock % ensembles] + 10 * normal_draw(dice);
    count.add_end(rock, {runout, 1, 1});
    if (runout > 100) count.add_arrival(rock, "Road", {1000, 5, 1});
    count.add_arrival(rock, "other", {1000, 5, 1});
  }
  return count.result();
}

const FigureUncertainty& figure_in(const Uncertainty& all, FigureOf of) {
  for (const FigureUncertainty& each : all.figures)
    if (each.figure.of == of) return each;
  throw std::runtime_error("no such figure");
}

// The median of n normal values has the variance pi/2 sigma^2 / n: with 50 rocks (1.77 m)^2. Between ensembles it adds
// to that of the parameters.
TEST(Uncertainty, SeparatesParametersFromRocks) {
  const Uncertainty all = ensembles_with(5);
  EXPECT_EQ(all.ensembles, 200u);
  const FigureUncertainty& median = figure_in(all, FigureOf::runout);
  const double of_rocks = std::numbers::pi / 2 * 100 / 50, expected = 25 / (25 + of_rocks);
  EXPECT_NEAR(median.parameter_share, expected, 0.03);
  const auto half_width = [](const Estimate& e) { return (*e.high - *e.low) / 2 / 1.645; };
  EXPECT_NEAR(half_width(median.total), std::sqrt(25 + of_rocks), 0.6);
  EXPECT_NEAR(half_width(median.parameters), 5, 0.6);
  EXPECT_NEAR(half_width(median.rocks), std::sqrt(of_rocks), 0.15);
  EXPECT_NEAR(median.total.value, 100, 1);
}

TEST(Uncertainty, IsOfTheRocksAloneIfParametersAreKnown) {
  const Uncertainty all = ensembles_with(0);
  for (const FigureOf of : {FigureOf::runout, FigureOf::share}) {
    const FigureUncertainty& figure = figure_in(all, of);
    EXPECT_LT(figure.parameter_share, 0.2) << static_cast<int>(of);
    EXPECT_LT(*figure.parameters.high - *figure.parameters.low, 0.5 * (*figure.total.high - *figure.total.low));
  }
}

TEST(Uncertainty, OfAShareIsBetweenItsEnsembles) {
  const Uncertainty all = ensembles_with(20);
  const FigureUncertainty& share = figure_in(all, FigureOf::share);
  EXPECT_EQ(share.line, "Road");
  EXPECT_NEAR(share.total.value, 0.5, 0.06);
  EXPECT_GE(*share.total.low, 0);
  EXPECT_LE(*share.total.high, 1);
  EXPECT_GT(share.parameter_share, 0.9);
}

// Heights of many small values and few large ones: a normal range about their percentile would begin below 0.
TEST(Uncertainty, OfRocksIsNotBelowZero) {
  testing_tools::Dice dice(11);
  UncertaintyCount count(20 * 30, 20, {"Road"});
  for (std::uint64_t rock = 0; rock < 20 * 30; ++rock) {
    count.add_end(rock, {10, 1, dice.chance(0.04) ? 5.0 : 0.01});
    if (dice.chance(0.03)) count.add_arrival(rock, "Road", {1000, 5, 1});
  }
  const Uncertainty all = count.result();
  const FigureUncertainty& bounce = figure_in(all, FigureOf::max_bounce);
  EXPECT_EQ(*bounce.rocks.low, 0);
  EXPECT_GT(*bounce.rocks.high, bounce.rocks.value);
  EXPECT_EQ(*figure_in(all, FigureOf::share).rocks.low, 0);
}

TEST(Uncertainty, NeedsFiveEnsembles) {
  EXPECT_TRUE(ensembles_with(5, 4, 50).figures.empty());
  EXPECT_FALSE(ensembles_with(5, 5, 50).figures.empty());
}

}  // namespace
}  // namespace talus
