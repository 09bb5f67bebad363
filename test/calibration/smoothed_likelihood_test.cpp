// Values without noise stay as they are; with noise, the smoothed ones are near the true ones.

#include "talus/calibration/smoothed_likelihood.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "talus/core/random.hpp"

namespace talus::calibration {
namespace {

double normal_number(std::uint64_t item) {
  const auto [a, b] = uniform_pair(11, item, static_cast<Stream>(5200), 0);
  return std::sqrt(-2 * std::log(a)) * std::cos(2 * std::numbers::pi * b);
}

std::vector<Place> sobol(std::size_t dimensions, std::size_t count) { return Sampler(dimensions, 3).next_round(count); }

std::vector<double> values_of(const std::vector<Place>& places, const std::function<double(const Place&)>& f) {
  std::vector<double> values;
  for (const Place& place : places) values.push_back(f(place));
  return values;
}

/// A curved ridge, steeper on one side: no parabola.
double ridge(const Place& at) {
  const double x = 6 * (at[0] - 0.4), y = 6 * (at[1] - 0.6) - 0.5 * x * x;
  return -x * x / 2 - (y > 0 ? 2 : 1) * y * y;
}

double greatest_difference_near_top(const std::vector<double>& a, const std::vector<double>& truth) {
  double most = 0;
  for (std::size_t k = 0; k < a.size(); ++k)
    if (truth[k] > -4) most = std::max(most, std::abs(a[k] - truth[k]));
  return most;
}

TEST(SmoothedLikelihood, LeavesValuesWithoutNoise) {
  const std::vector<Place> places = sobol(2, 600);
  const std::vector<double> truth = values_of(places, ridge);
  const SmoothedLikelihoods smoothed = smoothed_likelihoods(places, truth);
  EXPECT_LT(greatest_difference_near_top(smoothed.values, truth), 0.05);
  EXPECT_LT(smoothed.noise, 0.1);
}

TEST(SmoothedLikelihood, TakesNoiseOutAndMeasuresIt) {
  const std::vector<Place> places = sobol(2, 600);
  const std::vector<double> truth = values_of(places, ridge);
  std::vector<double> noisy = truth;
  constexpr double noise = 3;
  for (std::size_t k = 0; k < noisy.size(); ++k) noisy[k] += noise * normal_number(k);
  const SmoothedLikelihoods smoothed = smoothed_likelihoods(places, noisy);
  EXPECT_NEAR(smoothed.noise, noise, 0.4);
  double sum = 0, count = 0;
  for (std::size_t k = 0; k < truth.size(); ++k) {
    if (truth[k] < -4) continue;
    sum += (smoothed.values[k] - truth[k]) * (smoothed.values[k] - truth[k]);
    ++count;
  }
  EXPECT_LT(std::sqrt(sum / count), 0.25 * noise);
}

TEST(SmoothedLikelihood, SpreadsThePosteriorThatNoiseCollapsed) {
  const std::size_t dimensions = 4;
  Sampler sampler(dimensions, 7);
  const std::vector<Place> places = sampler.next_round(800);
  const std::vector<double> truth = values_of(places, [](const Place& at) {
    double sum = 0;
    for (const double x : at) sum -= 8 * (x - 0.45) * (x - 0.45);
    return sum;
  });
  std::vector<double> noisy = truth;
  for (std::size_t k = 0; k < noisy.size(); ++k) noisy[k] += 4 * normal_number(k);
  sampler.set(noisy);
  const double exact = effective_size(sampler.weights(truth));
  EXPECT_LT(effective_size(sampler.weights(noisy)), 0.1 * exact);
  EXPECT_NEAR(effective_size(sampler.weights(smoothed_likelihoods(places, noisy).values)) / exact, 1, 0.35);
}

TEST(SmoothedLikelihood, LeavesImpossibleAndTooFewValues) {
  const std::vector<Place> places = sobol(2, 200);
  std::vector<double> values = values_of(places, ridge);
  constexpr double impossible = -std::numeric_limits<double>::infinity();
  values[7] = impossible;
  EXPECT_EQ(smoothed_likelihoods(places, values).values[7], impossible);
  const std::vector<Place> few = sobol(2, 20);
  const std::vector<double> kept = values_of(few, [](const Place& at) { return std::sin(40 * at[0]); });
  EXPECT_EQ(smoothed_likelihoods(few, kept).values, kept);
  EXPECT_EQ(smoothed_likelihoods(few, std::vector<double>(20, impossible)).values, std::vector<double>(20, impossible));
}

}  // namespace
}  // namespace talus::calibration
