#include "talus/statistics/sobol.hpp"

#include <gtest/gtest.h>

#include <set>

#include "statistics/test_functions.hpp"

namespace talus::sobol_test {
namespace {

using testing_tools::Ishigami;
using testing_tools::results_of;
using testing_tools::SobolG;

TEST(Ishigami, HasThePublishedIndices) {
  const Ishigami f;
  EXPECT_NEAR(f.first()[0], 0.3139, 5e-5);
  EXPECT_NEAR(f.first()[1], 0.4424, 5e-5);
  EXPECT_NEAR(f.total()[0], 0.5576, 5e-5);
  EXPECT_NEAR(f.total()[2], 0.2437, 5e-5);
}

TEST(SobolDesign, IsEvenInEveryCoordinate) {
  const SobolDesign design({.inputs = 5, .rows = 64, .seed = 9});
  ASSERT_EQ(design.points().size(), 64u * 7);
  for (std::size_t input = 0; input < 5; ++input) {
    std::set<int> cells_of_a, cells_of_b;
    for (std::size_t row = 0; row < 64; ++row) {
      cells_of_a.insert(static_cast<int>(64 * design.points()[row * 7][input]));
      cells_of_b.insert(static_cast<int>(64 * design.points()[row * 7 + 1][input]));
    }
    EXPECT_EQ(cells_of_a.size(), 64u) << input;
    EXPECT_EQ(cells_of_b.size(), 64u) << input;
  }
}

TEST(SobolDesign, ExchangesOneInputAtATime) {
  const SobolDesign design({.inputs = 3, .rows = 4, .seed = 2});
  for (std::size_t row = 0; row < 4; ++row) {
    const auto* points = &design.points()[row * 5];
    for (std::size_t exchanged = 0; exchanged < 3; ++exchanged)
      for (std::size_t input = 0; input < 3; ++input)
        EXPECT_EQ(points[2 + exchanged][input], points[input == exchanged ? 1 : 0][input]);
  }
}

TEST(SobolDesign, BeginsWithThePointsOfASmallerOne) {
  const SobolDesign small({.inputs = 4, .rows = 16, .seed = 3}), large({.inputs = 4, .rows = 32, .seed = 3});
  EXPECT_TRUE(std::equal(small.points().begin(), small.points().end(), large.points().begin()));
  const SobolDesign other({.inputs = 4, .rows = 16, .seed = 4});
  EXPECT_NE(small.points(), other.points());
}

TEST(SobolIndices, OfTheIshigamiFunctionAgreeWithTheClosedForm) {
  const Ishigami f;
  const SobolDesign design({.inputs = 3, .rows = 4096, .seed = 1});
  const auto found = design.indices(results_of(design.points(), f), {.replicas = 100});
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->mean, 3.5, 0.01);
  EXPECT_NEAR(found->variance, f.variance(), 0.01 * f.variance());
  ASSERT_EQ(found->inputs.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(found->inputs[i].first.value, f.first()[i], 0.01) << i;
    EXPECT_NEAR(found->inputs[i].total.value, f.total()[i], 0.01) << i;
  }
}

TEST(SobolIndices, OfTheGFunctionAgreeWithTheClosedForm) {
  const SobolG f;
  const SobolDesign design({.inputs = 8, .rows = 4096, .seed = 5});
  const auto found = design.indices(results_of(design.points(), f), {.replicas = 50});
  ASSERT_TRUE(found);
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_NEAR(found->inputs[i].first.value, f.first(i), 0.015) << i;
    EXPECT_NEAR(found->inputs[i].total.value, f.total(i), 0.015) << i;
  }
}

// How many of all intervals contain what they should, and how many contain the indices of another function.
TEST(SobolIndices, HaveIntervalsThatContainTheTruthAsOftenAsTheyClaim) {
  const Ishigami f, other{.a = 5, .b = 0.1};
  constexpr int designs = 60;
  int right = 0, wrong = 0, all = 0;
  for (int seed = 1; seed <= designs; ++seed) {
    const SobolDesign design({.inputs = 3, .rows = 256, .seed = static_cast<std::uint64_t>(seed)});
    const auto found =
        design.indices(results_of(design.points(), f), {.replicas = 200, .seed = static_cast<std::uint64_t>(seed)});
    ASSERT_TRUE(found);
    const auto contains = [](const Estimate& estimate, double truth) {
      return *estimate.low <= truth && truth <= *estimate.high;
    };
    for (std::size_t i = 0; i < 3; ++i) {
      right += contains(found->inputs[i].first, f.first()[i]) + contains(found->inputs[i].total, f.total()[i]);
      wrong += contains(found->inputs[i].first, other.first()[i]) + contains(found->inputs[i].total, other.total()[i]);
      all += 2;
    }
  }
  EXPECT_GE(right, 0.95 * all);
  EXPECT_LT(wrong, 0.8 * all);
}

TEST(SobolIndices, AreTheSameEveryTime) {
  const SobolDesign design({.inputs = 3, .rows = 64, .seed = 1});
  const auto results = results_of(design.points(), Ishigami{});
  const auto once = design.indices(results, {}), again = design.indices(results, {});
  EXPECT_EQ(once->inputs[0].first, again->inputs[0].first);
  EXPECT_EQ(once->inputs[2].total, again->inputs[2].total);
}

TEST(SobolIndices, AreEmptyForAResultThatDoesNotVary) {
  const SobolDesign design({.inputs = 2, .rows = 16});
  const auto found = design.indices(results_of(design.points(), [](const auto&) { return 0.1; }), {});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->variance, 0);
  EXPECT_TRUE(found->inputs.empty());
}

TEST(SobolIndices, LeaveOutRowsWithAnUndefinedResult) {
  const SobolDesign design({.inputs = 2, .rows = 64});
  auto results = results_of(design.points(), [](const auto& u) { return u[0]; });
  results[1].reset();
  results[4 * 10 + 3].reset();
  const auto found = design.indices(results, {});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->rows, 62u);
  EXPECT_NEAR(found->inputs[0].first.value, 1, 0.1);
  EXPECT_EQ(found->inputs[1].total.value, 0);
  for (std::size_t row = 0; row < 61; ++row) results[4 * row].reset();
  EXPECT_FALSE(design.indices(results, {}));
}

}  // namespace
}  // namespace talus::sobol_test
