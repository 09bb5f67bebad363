#include "talus/statistics/morris.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "statistics/test_functions.hpp"

namespace talus::morris_test {
namespace {

using testing_tools::results_of;
using testing_tools::SobolG;

TEST(MorrisDesign, ChangesEachInputOnceInATrajectoryByTwoThirds) {
  constexpr std::size_t k = 5;
  const MorrisDesign design({.inputs = k, .trajectories = 8, .seed = 4});
  ASSERT_EQ(design.points().size(), 8 * (k + 1));
  for (std::size_t trajectory = 0; trajectory < 8; ++trajectory) {
    std::vector<int> changes(k, 0);
    for (std::size_t step = 0; step < k; ++step) {
      const auto &from = design.points()[trajectory * (k + 1) + step], &to = (&from)[1];
      for (std::size_t i = 0; i < k; ++i) {
        EXPECT_NEAR(3 * from[i], std::round(3 * from[i]), 1e-12);
        if (from[i] == to[i]) continue;
        EXPECT_NEAR(std::abs(to[i] - from[i]), 2.0 / 3, 1e-12);
        ++changes[i];
      }
    }
    EXPECT_EQ(changes, std::vector<int>(k, 1));
  }
}

// Of a linear function every effect is its coefficient; with a product, the effect of one input depends on the other.
TEST(ElementaryEffects, AreTheSlopesOfTheFunction) {
  const MorrisDesign design({.inputs = 4, .trajectories = 12, .seed = 7});
  const auto effects = design.effects(
      results_of(design.points(), [](const auto& u) { return 10 - 3 * u[0] + 8 * (u[1] - 0.5) * (u[2] - 0.5); }), {});
  ASSERT_EQ(effects.size(), 4u);
  EXPECT_NEAR(effects[0]->mean, -3, 1e-12);
  EXPECT_NEAR(effects[0]->magnitude.value, 3, 1e-12);
  EXPECT_NEAR(*effects[0]->magnitude.high, 3, 1e-12);
  EXPECT_NEAR(effects[0]->standard_deviation, 0, 1e-12);
  for (const std::size_t i : {1u, 2u}) {
    // The other factor is one of -1/2, -1/6, 1/6, 1/2.
    EXPECT_GE(effects[i]->magnitude.value, 8.0 / 6 - 1e-12);
    EXPECT_LE(effects[i]->magnitude.value, 4 + 1e-12);
    EXPECT_LT(std::abs(effects[i]->mean), effects[i]->magnitude.value);
    EXPECT_GT(effects[i]->standard_deviation, 1);
    EXPECT_LT(*effects[i]->magnitude.low, effects[i]->magnitude.value);
    EXPECT_GT(*effects[i]->magnitude.high, effects[i]->magnitude.value);
  }
  EXPECT_EQ(effects[3]->magnitude.value, 0);
  EXPECT_EQ(effects[3]->count, 12u);
}

// A sum in another order differs in its last digits.
TEST(ElementaryEffects, AreZeroWhereResultsDifferByRounding) {
  const MorrisDesign design({.inputs = 2, .trajectories = 12, .seed = 7});
  const auto effects = design.effects(
      results_of(design.points(), [](const auto& u) { return 80 + u[0] + 1e-12 * std::sin(9 * u[1]); }), {});
  EXPECT_NEAR(effects[0]->magnitude.value, 1, 1e-9);
  EXPECT_EQ(effects[1]->magnitude.value, 0);
  EXPECT_EQ(*effects[1]->magnitude.low, 0);
  EXPECT_EQ(*effects[1]->magnitude.high, 0);
}

TEST(ElementaryEffects, RankInputsAsTheTotalIndices) {
  const SobolG f{.a = {0, 1, 9, 99}};
  const MorrisDesign design({.inputs = 4, .trajectories = 100, .seed = 1});
  const auto effects = design.effects(results_of(design.points(), f), {});
  for (std::size_t i = 0; i + 1 < 4; ++i) {
    EXPECT_GT(f.total(i), f.total(i + 1));
    EXPECT_GT(effects[i]->magnitude.value, effects[i + 1]->magnitude.value) << i;
  }
}

TEST(ElementaryEffects, LeaveOutUndefinedResults) {
  const MorrisDesign design({.inputs = 2, .trajectories = 3, .seed = 1});
  auto results = results_of(design.points(), [](const auto& u) { return 2 * u[0] + u[1]; });
  results[1].reset();  // both effects of the first trajectory
  const auto effects = design.effects(results, {});
  EXPECT_EQ(effects[0]->count, 2u);
  EXPECT_NEAR(effects[0]->mean, 2, 1e-12);
  std::ranges::fill(results, std::nullopt);
  EXPECT_FALSE(design.effects(results, {})[0]);
}

TEST(MorrisDesign, DependsOnTheSeedAlone) {
  const MorrisPlan plan{.inputs = 3, .trajectories = 5, .levels = 4, .seed = 11};
  EXPECT_EQ(MorrisDesign(plan).points(), MorrisDesign(plan).points());
  EXPECT_NE(MorrisDesign(plan).points(), MorrisDesign({.inputs = 3, .trajectories = 5, .seed = 12}).points());
}

}  // namespace
}  // namespace talus::morris_test
