// Draws from a sample.

#include "talus/sampling/empirical.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "sampling/goodness_of_fit.hpp"
#include "talus/sampling/distribution.hpp"
#include "talus/sampling/draws.hpp"

namespace talus::empirical_test {
namespace {

using ::testing::ElementsAre;

Distribution of(std::vector<EmpiricalSample::Value> values) {
  Distribution distribution;
  distribution.kind = DistributionKind::empirical;
  distribution.sample = std::make_shared<const EmpiricalSample>(std::move(values));
  return distribution;
}

// Hyndman and Fan 1996, definition 1: the k-th of n values from (k - 1)/n to k/n.
TEST(EmpiricalSample, IsTheInverseOfItsDistributionFunction) {
  const EmpiricalSample sample({{30}, {10}, {20}, {20}});
  EXPECT_THAT(sample.values(), ElementsAre(10, 20, 20, 30));
  EXPECT_EQ(sample.quantile(0x1p-53), 10);
  EXPECT_EQ(sample.quantile(0.2499), 10);
  EXPECT_EQ(sample.quantile(0.2501), 20);
  EXPECT_EQ(sample.quantile(0.7499), 20);
  EXPECT_EQ(sample.quantile(0.7501), 30);
  EXPECT_EQ(sample.quantile(1 - 0x1p-53), 30);
  EXPECT_EQ(sample.mean(), 20);
}

TEST(EmpiricalSample, HasWeightsOfAnySum) {
  const EmpiricalSample sample({{1, 6}, {2, 0}, {3, 2}});
  EXPECT_EQ(sample.count(), 2U);
  EXPECT_EQ(sample.quantile(0.7499), 1);
  EXPECT_EQ(sample.quantile(0.7501), 3);
  EXPECT_EQ(sample.quantile(1 - 0x1p-53), 3);
  EXPECT_EQ(sample.mean(), 1.5);
}

TEST(EmpiricalSample, WithEqualWeightsIsAsWithout) {
  const EmpiricalSample equal({{1, 0.1}, {2, 0.1}, {3, 0.1}}), none({{1}, {2}, {3}});
  for (double u = 0.01; u < 1; u += 0.01) EXPECT_EQ(equal.quantile(u), none.quantile(u));
}

TEST(EmpiricalSampler, ScalesAndDrawsOnlyMeasuredValues) {
  const Sampler sampler(of({{1}, {2}, {4}}), {0, 10}, 10);
  EXPECT_FALSE(sampler.is_constant());
  for (double u = 0.001; u < 1; u += 0.001) {
    const double x = sampler.draw(u);
    EXPECT_TRUE(x == 10 || x == 20 || x == 40);
  }
}

// With a Latin hypercube of k n rocks, each of n values is drawn exactly k times.
TEST(EmpiricalSampler, UsesEachValueEquallyOftenInALatinHypercube) {
  const Sampler sampler(of({{1}, {2}, {3}, {4}, {5}}), {});
  std::map<double, int> counts;
  for (std::uint64_t rock = 0; rock < 35; ++rock)
    ++counts[sampler.draw(Draws({7, SamplingMethod::latin_hypercube, 0, 35}, rock).one(Stream::size))];
  ASSERT_EQ(counts.size(), 5U);
  for (const auto& [value, count] : counts) EXPECT_EQ(count, 7) << value;
}

// The counts of draws agree with the weights, by chi squared with 3 degrees of freedom; they do not with other weights.
TEST(EmpiricalSampler, DrawsValuesByTheirWeights) {
  constexpr int draws = 20000;
  const std::vector<double> weights{0.1, 0.2, 0.3, 0.4};
  const Sampler sampler(of({{1, 0.1}, {2, 0.2}, {3, 0.3}, {4, 0.4}}), {});
  std::vector<double> counts(4);
  for (std::uint64_t rock = 0; rock < draws; ++rock)
    ++counts[static_cast<std::size_t>(sampler.draw(Draws({3, {}, 0, draws}, rock).one(Stream::size))) - 1];
  const auto chi_squared = [&](const std::vector<double>& shares) {
    double sum = 0;
    for (std::size_t k = 0; k < 4; ++k) sum += std::pow(counts[k] - draws * shares[k], 2) / (draws * shares[k]);
    return sum;
  };
  constexpr double at_one_in_a_thousand = 16.27;
  EXPECT_LT(chi_squared(weights), at_one_in_a_thousand);
  EXPECT_GT(chi_squared({0.12, 0.19, 0.3, 0.39}), at_one_in_a_thousand);
}

TEST(EmpiricalDistribution, MustHaveASampleWithinTheBounds) {
  Distribution unread;
  unread.kind = DistributionKind::empirical;
  EXPECT_EQ(why_unusable(unread, {}), "has no sample (its values are in a file)");
  EXPECT_EQ(why_unusable(of({{0.5}, {2}}), {0, 1}), "has values from 0.5 to 2 (expected 0 to 1)");
  EXPECT_EQ(why_unusable(of({{0.5}}), {0, 1}), std::nullopt);
  EXPECT_TRUE(density_of(of({{0.5}}), {0, 1}, 10).empty());
}

}  // namespace
}  // namespace talus::empirical_test
