#include "talus/statistics/proper_scores.hpp"

#include <gtest/gtest.h>

#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "support/dice.hpp"

namespace talus::proper_scores_test {
namespace {

using testing_tools::Dice;

/// The sample of n equally spaced quantiles of the standard normal distribution.
LineSample normal_quantiles(std::size_t n, double mean = 0) {
  std::vector<double> values;
  for (std::size_t i = 0; i < n; ++i) {
    const double p = (static_cast<double>(i) + 0.5) / static_cast<double>(n);
    values.push_back(mean + boost::math::quantile(boost::math::normal(), p));
  }
  return LineSample(values);
}

double draw_normal(Dice& dice) {
  return std::sqrt(-2 * std::log(1 - dice.unit())) * std::cos(2 * std::numbers::pi * dice.unit());
}

/// Definitions by double sums.
double mean_distance(const std::vector<double>& a, const std::vector<double>& weights_a, const std::vector<double>& b,
                     const std::vector<double>& weights_b) {
  double sum = 0, all = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      sum += weights_a[i] * weights_b[j] * std::abs(a[i] - b[j]);
      all += weights_a[i] * weights_b[j];
    }
  }
  return sum / all;
}

TEST(Crps, OfOneValueIsItsDistance) {
  const LineSample sample(std::vector{3.0});
  EXPECT_EQ(crps(sample, 3), 0);
  EXPECT_EQ(crps(sample, 5.5), 2.5);
  EXPECT_EQ(crps(sample, -1), 4);
}

// E|X - y| - E|X - X'| / 2 of the values 0 and 1, whose mean distance is 1/2.
TEST(Crps, OfTwoValuesAgreesWithItsDefinition) {
  const LineSample sample(std::vector{1.0, 0.0});
  EXPECT_DOUBLE_EQ(crps(sample, 0.5), 0.25);
  EXPECT_DOUBLE_EQ(crps(sample, 0), 0.25);
  EXPECT_DOUBLE_EQ(crps(sample, 3), 2.25);
  EXPECT_DOUBLE_EQ(crps(sample, -2), 2.25);
  EXPECT_DOUBLE_EQ(crps(sample, 0.5, SpreadOf::population), 0);  // their mean distance as different values is 1
}

// Gneiting and Raftery 2007, equation 21: the CRPS of a normal distribution.
TEST(Crps, OfANormalDistributionAgreesWithItsClosedForm) {
  const LineSample sample = normal_quantiles(20001);
  const boost::math::normal normal;
  for (const double z : {-3.0, -1.0, 0.0, 0.3, 2.5}) {
    const double expected = z * (2 * cdf(normal, z) - 1) + 2 * pdf(normal, z) - 1 / std::sqrt(std::numbers::pi);
    EXPECT_NEAR(crps(sample, z), expected, 2e-5) << z;
  }
  EXPECT_NEAR(sample.spread(), 2 / std::sqrt(std::numbers::pi), 2e-4);
}

TEST(LineSample, AgreesWithDoubleSums) {
  Dice dice(7);
  for (int round = 0; round < 50; ++round) {
    std::vector<double> a, b, weights_a, weights_b;
    const std::size_t n = 1 + dice.below(12), m = 1 + dice.below(12);
    for (std::size_t i = 0; i < n; ++i) {
      a.push_back(static_cast<double>(dice.below(9)));  // with ties
      weights_a.push_back(i == 0 ? 1.0 : static_cast<double>(dice.below(4)));
    }
    for (std::size_t i = 0; i < m; ++i) {
      b.push_back(dice.between(-2, 9));
      weights_b.push_back(dice.between(0.1, 2));
    }
    const LineSample x(a, weights_a), y(b, weights_b);
    const double spread_a = mean_distance(a, weights_a, a, weights_a);
    EXPECT_NEAR(x.spread(), spread_a, 1e-13);
    EXPECT_NEAR(crps(x, b[0]), mean_distance(a, weights_a, {b[0]}, {1}) - 0.5 * spread_a, 1e-13);
    EXPECT_NEAR(crps(x, 4), mean_distance(a, weights_a, {4}, {1}) - 0.5 * spread_a, 1e-13);
    EXPECT_NEAR(energy_distance(x, y),
                2 * mean_distance(a, weights_a, b, weights_b) - spread_a - mean_distance(b, weights_b, b, weights_b),
                1e-13);
    EXPECT_EQ(energy_distance(x, y), energy_distance(y, x));
    EXPECT_EQ(energy_distance(x, x), 0);

    std::vector<Vec2> on_a_line, others;
    for (const double value : a) on_a_line.emplace_back(100 + 0.6 * value, 0.8 * value);
    for (const double value : b) others.emplace_back(100 + 0.6 * value, 0.8 * value);
    const PlaneSample p(on_a_line, weights_a), q(others, weights_b);
    EXPECT_NEAR(p.spread(), x.spread(), 1e-12);
    EXPECT_NEAR(energy_score(p, others[0]), crps(x, b[0]), 1e-12);
    EXPECT_NEAR(energy_distance(p, q), energy_distance(x, y), 1e-12);
    if (n > 1 && weights_a[1] > 0) {
      EXPECT_NEAR(energy_score(p, others[0], SpreadOf::population), crps(x, b[0], SpreadOf::population), 1e-11);
    }
  }
}

TEST(LineSample, HasTheSharesUpToItsValues) {
  const LineSample sample(std::vector{2.0, 1.0, 2.0, 4.0});
  EXPECT_EQ(sample.share_up_to_value(0.9), 0);
  EXPECT_EQ(sample.share_up_to_value(1), 0.25);
  EXPECT_EQ(sample.share_up_to_value(2), 0.75);
  EXPECT_EQ(sample.share_up_to_value(9), 1);
}

TEST(LineSample, WithWeightsEqualsRepeatedValues) {
  const LineSample weighted(std::vector{1.0, 5.0, 2.0}, std::vector{2.0, 1.0, 3.0});
  const LineSample repeated(std::vector{1.0, 1.0, 5.0, 2.0, 2.0, 2.0});
  EXPECT_NEAR(energy_distance(weighted, repeated), 0, 1e-30);
  EXPECT_NEAR(crps(weighted, 1.7), crps(repeated, 1.7), 1e-15);
  EXPECT_NEAR(weighted.spread(), repeated.spread(), 1e-15);
}

// Runouts and coordinates of national grids: nothing may be lost far from zero.
TEST(LineSample, KeepsItsDigitsFarFromZero) {
  const std::vector<double> values{0, 0.25, 1.5, 8};
  std::vector<double> far;
  for (const double value : values) far.push_back(value + 2'600'000);
  EXPECT_DOUBLE_EQ(crps(LineSample(far), 2'600'001), crps(LineSample(values), 1));
  EXPECT_DOUBLE_EQ(LineSample(far).spread(), LineSample(values).spread());
}

TEST(EnergyDistance, OfTwoSinglePointsIsTwiceTheirDistance) {
  EXPECT_EQ(energy_distance(LineSample(std::vector{1.0}), LineSample(std::vector{4.0})), 6);
  EXPECT_DOUBLE_EQ(energy_distance(PlaneSample({{0, 0}}), PlaneSample({{3, 4}})), 10);
}

// Of two normal distributions with variance 1 whose means are d apart: X - Y is normal with mean d and variance 2, so
// E|X - Y| = 2/sqrt(pi) exp(-d^2/4) + d erf(d/2), and E|X - X'| = 2/sqrt(pi).
TEST(EnergyDistance, OfTwoNormalDistributionsAgreesWithItsClosedForm) {
  const LineSample zero = normal_quantiles(5001);
  for (const double d : {0.1, 1.0, 3.0}) {
    const double expected = 4 / std::sqrt(std::numbers::pi) * (std::exp(-d * d / 4) - 1) + 2 * d * std::erf(d / 2);
    EXPECT_NEAR(energy_distance(zero, normal_quantiles(5001, d)), expected, 1e-3 * expected + 1e-6) << d;
  }
}

TEST(EnergyDistance, DoesNotChangeWhenThePlaneIsTurnedOrMoved) {
  Dice dice(3);
  std::vector<Vec2> a, b, turned_a, turned_b;
  const auto moved = [](const Vec2& p) {
    return Vec2(2.6e6 + 0.28 * p.x() - 0.96 * p.y(), 0.96 * p.x() + 0.28 * p.y());
  };
  for (int i = 0; i < 20; ++i) {
    a.emplace_back(dice.between(0, 10), dice.between(0, 10));
    b.emplace_back(dice.between(5, 20), dice.between(0, 10));
    turned_a.push_back(moved(a.back()));
    turned_b.push_back(moved(b.back()));
  }
  const double distance = energy_distance(PlaneSample(a), PlaneSample(b));
  EXPECT_GT(distance, 1);
  EXPECT_NEAR(energy_distance(PlaneSample(turned_a), PlaneSample(turned_b)), distance, 1e-8);
}

// The mean distance of two points of the standard normal distribution of the plane is sqrt(pi). The spread of small
// samples themselves is too small; the estimate for the population is right within three standard errors.
TEST(PlaneSample, EstimatesTheSpreadOfThePopulationWithoutBias) {
  Dice dice(11);
  double of_sample = 0, of_population = 0, squares = 0;
  constexpr int rounds = 4000;
  for (int round = 0; round < rounds; ++round) {
    std::vector<Vec2> points;
    for (int i = 0; i < 5; ++i) points.emplace_back(draw_normal(dice), draw_normal(dice));
    const PlaneSample sample(points);
    of_sample += sample.spread();
    of_population += sample.spread(SpreadOf::population);
    squares += sample.spread(SpreadOf::population) * sample.spread(SpreadOf::population);
  }
  const double truth = std::sqrt(std::numbers::pi), mean = of_population / rounds;
  const double standard_error = std::sqrt((squares / rounds - mean * mean) / rounds);
  EXPECT_NEAR(mean, truth, 3 * standard_error);
  EXPECT_NEAR(of_sample / rounds, 0.8 * truth, 3 * standard_error);
  EXPECT_GT(std::abs(of_sample / rounds - truth), 10 * standard_error);
}

// Proper: forecasts that are shifted, too narrow or too wide score worse, on average over observations from the truth.
TEST(ProperScores, AreLowestForTheTrueDistribution) {
  Dice dice(5);
  std::vector<double> truth, shifted, narrow, wide;
  std::vector<Vec2> truth_2d, shifted_2d, narrow_2d, wide_2d;
  for (int i = 0; i < 400; ++i) {
    const Vec2 p(draw_normal(dice), draw_normal(dice));
    truth.push_back(p.x()), shifted.push_back(p.x() + 0.7), narrow.push_back(0.3 * p.x()), wide.push_back(2.5 * p.x());
    truth_2d.push_back(p), shifted_2d.emplace_back(p.x() + 0.7, p.y()), narrow_2d.emplace_back(0.3 * p);
    wide_2d.emplace_back(2.5 * p);
  }
  std::vector<Vec2> observed;
  for (int i = 0; i < 400; ++i) observed.emplace_back(draw_normal(dice), draw_normal(dice));
  const auto on_a_line = [&](const std::vector<double>& values) {
    const LineSample sample(values);
    double sum = 0;
    for (const Vec2& each : observed) sum += crps(sample, each.x());
    return sum / static_cast<double>(observed.size());
  };
  const auto in_the_plane = [&](const std::vector<Vec2>& values) {
    const PlaneSample sample(values);
    double sum = 0;
    for (const Vec2& each : observed) sum += energy_score(sample, each);
    return sum / static_cast<double>(observed.size());
  };
  for (const auto* other : {&shifted, &narrow, &wide}) EXPECT_LT(on_a_line(truth), on_a_line(*other) - 0.05);
  for (const auto* other : {&shifted_2d, &narrow_2d, &wide_2d}) {
    EXPECT_LT(in_the_plane(truth_2d), in_the_plane(*other) - 0.05);
  }
}

TEST(KolmogorovSmirnov, IsTheMaximumDifferenceOfTheShares) {
  const LineSample a(std::vector{1.0, 2.0, 3.0, 4.0}), b(std::vector{3.0, 3.5});
  EXPECT_EQ(kolmogorov_smirnov(a, b), 0.5);
  EXPECT_EQ(kolmogorov_smirnov(b, a), 0.5);
  EXPECT_EQ(kolmogorov_smirnov(a, a), 0);
  EXPECT_EQ(kolmogorov_smirnov(a, LineSample(std::vector{9.0})), 1);
  EXPECT_EQ(kolmogorov_smirnov(LineSample(std::vector{9.0}), a), 1);
}

}  // namespace
}  // namespace talus::proper_scores_test
