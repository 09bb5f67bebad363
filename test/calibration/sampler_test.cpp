// Places and weights that represent a posterior, against posteriors in closed form.

#include "talus/calibration/sampler.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace talus::calibration {
namespace {

/// A normal likelihood in each dimension, with the two dimensions correlated.
double log_normal(const Place& at, double mean, double sd, double correlation) {
  const double x = (at[0] - mean) / sd, y = (at[1] - mean) / sd;
  return -0.5 * (x * x - 2 * correlation * x * y + y * y) / (1 - correlation * correlation);
}

struct PriorMoments {
  double mean = 0, sd = 0;
};

PriorMoments prior_moments(const Sampler& sampler, std::size_t dimension) {
  const std::vector<double> weights = sampler.weights();
  PriorMoments moments;
  double square = 0;
  for (std::size_t k = 0; k < weights.size(); ++k) {
    moments.mean += weights[k] * sampler.places()[k][dimension];
    square += weights[k] * sampler.places()[k][dimension] * sampler.places()[k][dimension];
  }
  moments.sd = std::sqrt(square - moments.mean * moments.mean);
  return moments;
}

template <class Likelihood>
Sampler sampled(std::size_t dimensions, const std::vector<std::size_t>& rounds, const Likelihood& likelihood,
                std::uint64_t seed = 1) {
  Sampler sampler(dimensions, seed);
  for (const std::size_t count : rounds) {
    static_cast<void>(sampler.next_round(count));
    std::vector<double> values;
    for (const Place& place : sampler.places()) values.push_back(likelihood(place));
    sampler.set(values);
  }
  return sampler;
}

TEST(Sampler, FirstRoundIsEvenOverThePrior) {
  const Sampler sampler = sampled(3, {512}, [](const Place&) { return 0.0; });
  for (std::size_t d = 0; d < 3; ++d) {
    std::vector<double> values;
    for (const Place& place : sampler.places()) values.push_back(place[d]);
    std::ranges::sort(values);
    for (std::size_t k = 0; k < values.size(); ++k) {
      EXPECT_NEAR(values[k], (static_cast<double>(k) + 0.5) / 512, 0.01);
    }
  }
  EXPECT_NEAR(effective_size(sampler.weights()), 512, 1e-6);
}

TEST(Sampler, FindsANarrowPosterior) {
  const auto likelihood = [](const Place& at) { return log_normal(at, 0.4, 0.01, 0.8); };
  const Sampler sampler = sampled(2, {600, 300, 300, 300}, likelihood);
  EXPECT_GT(effective_size(sampler.weights()), 80);
  for (std::size_t d = 0; d < 2; ++d) {
    EXPECT_NEAR(prior_moments(sampler, d).mean, 0.4, 0.002);
    EXPECT_NEAR(prior_moments(sampler, d).sd, 0.01, 0.0015);
  }
}

TEST(Sampler, IsNotBiasedAtTheEndsOfThePrior) {
  // Half of a normal distribution: mean sd sqrt(2 / pi).
  const auto likelihood = [](const Place& at) { return -0.5 * at[0] * at[0] / (0.05 * 0.05); };
  const Sampler sampler = sampled(1, {300, 300, 300}, likelihood);
  EXPECT_NEAR(prior_moments(sampler, 0).mean, 0.05 * std::sqrt(2 / std::numbers::pi), 0.002);
}

TEST(Sampler, LeavesThePriorWhereTheDataSayNothing) {
  const auto likelihood = [](const Place& at) { return -0.5 * std::pow((at[0] - 0.5) / 0.05, 2); };
  const Sampler sampler = sampled(2, {600, 300, 300}, likelihood);
  EXPECT_NEAR(prior_moments(sampler, 1).mean, 0.5, 0.03);
  EXPECT_NEAR(prior_moments(sampler, 1).sd, std::sqrt(1.0 / 12), 0.02);
}

TEST(Sampler, DependsOnlyOnSeedAndLikelihood) {
  const auto likelihood = [](const Place& at) { return log_normal(at, 0.5, 0.1, 0); };
  EXPECT_EQ(sampled(2, {100, 100}, likelihood).places(), sampled(2, {100, 100}, likelihood).places());
  EXPECT_NE(sampled(2, {100, 100}, likelihood, 2).places(), sampled(2, {100, 100}, likelihood).places());
}

TEST(Sampler, HasNoPosteriorIfEverythingIsImpossible) {
  const Sampler sampler = sampled(1, {50}, [](const Place&) { return -INFINITY; });
  EXPECT_EQ(effective_size(sampler.weights()), 0);
}

TEST(WeightedQuantile, SkipsValuesWithoutWeight) {
  const std::vector<double> values{1, 2, 3, 4}, weights{0, 0.5, 0.5, 0};
  EXPECT_EQ(weighted_quantile(values, weights, 0), 2);
  EXPECT_EQ(weighted_quantile(values, weights, 0.5), 2);
  EXPECT_EQ(weighted_quantile(values, weights, 0.6), 3);
  EXPECT_EQ(weighted_quantile(values, weights, 1), 3);
}

}  // namespace
}  // namespace talus::calibration
