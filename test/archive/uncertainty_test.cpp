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
  UncertaintyCount count({.rocks = ensembles * rocks_each, .ensembles = ensembles}, {"Road"});
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
  UncertaintyCount count({.rocks = 20 * 30, .ensembles = 20}, {"Road"});
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

/// Runouts of rocks from the same places in each ensemble: normal shifts of the place, the ensemble and the rock.
Uncertainty from_the_same_places(double of_place, double of_ensemble, double of_rock, EnsembleRocks run) {
  testing_tools::Dice dice(23);
  std::vector<double> shift;
  for (std::uint64_t k = 0; k < run.ensembles; ++k) shift.push_back(of_ensemble * normal_draw(dice));
  UncertaintyCount count(run, {"Road"});
  double place = 0;
  for (std::uint64_t rock = 0, seeder = 0; rock < run.rocks; ++rock) {
    if (seeder + 1 < run.seeders_begin.size() && run.seeders_begin[seeder + 1] == rock) ++seeder;
    if ((rock - run.seeders_begin[seeder]) % run.ensembles == 0) place = of_place * normal_draw(dice);
    const double runout = 100 + place + shift[rock % run.ensembles] + of_rock * normal_draw(dice);
    count.add_end(rock, {runout, 1, 1});
    if (runout > 100) count.add_arrival(rock, "Road", {runout, 5, 1});
  }
  return count.result();
}

// The part of the rocks is known in closed form. Two rocks from one place have the correlation r = p^2 / (p^2 + o^2),
// for standard deviations p of places and o of a rock's own shift; they are on different sides of the median with
// probability acos(r) / pi, so the median of n rocks has the variance acos(r) (p^2 + o^2) / n for given places.
TEST(Uncertainty, SeparatesParametersFromRocksOfTheSamePlaces) {
  const Uncertainty all =
      from_the_same_places(20, 2, 10, {.rocks = 400 * 100, .ensembles = 400, .seeders_begin = {0, 130 * 100 + 50}});
  const double of_rocks = std::acos(0.8) * 500 / 100, expected = 4 / (4 + of_rocks);
  const FigureUncertainty& median = figure_in(all, FigureOf::runout);
  EXPECT_NEAR(median.parameter_share, expected, 0.06);
  const auto half_width = [](const Estimate& e) { return (*e.high - *e.low) / 2 / 1.645; };
  EXPECT_NEAR(half_width(median.rocks), std::sqrt(of_rocks), 0.15);
  EXPECT_NEAR(half_width(median.parameters), 2, 0.25);
  // The share at the line: 100 is the median, where its density is 1 / sqrt(2 pi (p^2 + o^2)).
  const double density = 1 / std::sqrt(2 * std::numbers::pi * 504);
  EXPECT_NEAR(half_width(figure_in(all, FigureOf::share).parameters), 2 * density, 0.25 * density);
}

TEST(Uncertainty, IsOfTheParametersAloneIfRocksDifferByPlaceAlone) {
  const Uncertainty all = from_the_same_places(20, 2, 0, {.rocks = 50 * 20, .ensembles = 50});
  EXPECT_GT(figure_in(all, FigureOf::runout).parameter_share, 0.95);
}

TEST(Uncertainty, IsNotOfTheParametersIfAllSetsAreTheSame) {
  const Uncertainty all = from_the_same_places(20, 0, 10, {.rocks = 50 * 80, .ensembles = 50, .parameter_sets = 1});
  ASSERT_GT(all.figures.size(), 5u);
  for (const FigureUncertainty& each : all.figures) EXPECT_EQ(each.parameter_share, 0) << each.figure.text();
}

// Two sets of parameters that give the same runouts: chance alone, on average and within its spread for 50 ensembles.
TEST(Uncertainty, IsHardlyOfParametersThatChangeNothing) {
  EXPECT_LT(
      figure_in(from_the_same_places(20, 0, 10, {.rocks = 50 * 80, .ensembles = 50}), FigureOf::runout).parameter_share,
      0.3);
}

TEST(Uncertainty, NeedsFiveEnsembles) {
  EXPECT_TRUE(ensembles_with(5, 4, 50).figures.empty());
  EXPECT_FALSE(ensembles_with(5, 5, 50).figures.empty());
}

}  // namespace
}  // namespace talus
