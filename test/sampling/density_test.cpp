#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "talus/sampling/distribution.hpp"

namespace talus::density_test {
namespace {

double total(const std::vector<Density>& list) {
  double sum = 0;
  for (const Density& each : list) sum += each.density;
  return sum * (list[1].value - list[0].value);
}

TEST(Density, OfANormalIsItsClosedForm) {
  const Distribution normal{10, DistributionKind::normal, 2, {}, {}};
  const auto list = density_of(normal, Bounds{}, 400);
  ASSERT_EQ(list.size(), 400U);
  for (const Density& each : list) {
    const double z = (each.value - 10) / 2;
    EXPECT_NEAR(each.density, std::exp(-0.5 * z * z) / (2 * std::sqrt(2 * std::numbers::pi)), 2e-5);
  }
  EXPECT_NEAR(total(list), 0.998, 1e-9);  // without a thousandth at either end
}

TEST(Density, OfATruncatedDistributionIsRenormalized) {
  // From the mean to one standard deviation above it: 0.3413 of the whole.
  const Distribution cut{0, DistributionKind::normal, 1, 0, 1};
  const auto list = density_of(cut, Bounds{}, 200);
  EXPECT_NEAR(list.front().value, 0.0025, 1e-12);
  EXPECT_NEAR(list.back().value, 0.9975, 1e-12);
  EXPECT_NEAR(list.front().density, 0.39894 / 0.34134, 1e-4);
  EXPECT_NEAR(total(list), 1, 1e-12);
  const auto bounded = density_of(Distribution{0, DistributionKind::normal, 1, {}, 1}, Bounds{0, 5}, 200);
  EXPECT_NEAR(bounded.front().density, list.front().density, 1e-12);
}

TEST(Density, OfEveryKindAddsUpToTheShareShown) {
  const std::vector<Distribution> all{
      {5, DistributionKind::uniform, {}, 2, 3},    {5, DistributionKind::triangular, {}, 2, 3},
      {5, DistributionKind::beta, 1, 2, 3},        {5, DistributionKind::exponential, {}, {}, {}},
      {5, DistributionKind::lognormal, 3, {}, {}}, {5, DistributionKind::gamma, 3, {}, {}}};
  for (const Distribution& each : all) {
    const auto list = density_of(each, Bounds{}, 300);
    EXPECT_LE(total(list), 1 + 1e-9);
    EXPECT_GE(total(list), 0.998 - 1e-9);
    // Half of the draws are below the median.
    const double median = Sampler(each, Bounds{}).draw(0.5), width = list[1].value - list[0].value;
    double below = 0;
    for (const Density& part : list) below += part.density * std::clamp(median - (part.value - width / 2), 0.0, width);
    EXPECT_NEAR(below, 0.5, 0.003) << static_cast<int>(each.kind);
  }
}

TEST(Density, OfAConstantIsEmpty) { EXPECT_TRUE(density_of(Distribution{5}, Bounds{}, 100).empty()); }

}  // namespace
}  // namespace talus::density_test
