#include "talus/archive/convergence.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace talus {
namespace {

/// Rocks of two seeders: the first thousand stop at 10 to 20 m, the others at 100 to 200 m, where every second arrives
/// at a line.
Convergence of_two_seeders() {
  ConvergenceCount count(2000, {"Fence", "Road"});
  for (std::uint64_t rock = 0; rock < 2000; ++rock) {
    const double part = static_cast<double>(rock % 1000) / 1000;
    const double runout = rock < 1000 ? 10 + 10 * part : 100 + 100 * part;
    count.add_end(rock, {runout, 1000 * runout, 1});
  }
  for (std::uint64_t rock = 1000; rock < 2000; rock += 2) {
    const double energy = 1000 + static_cast<double>(rock);
    count.add_arrival(rock, "Road", {energy, 5, 1});
    count.add_arrival(rock, "Road", {9e9, 99, 99});  // it returns
    count.add_arrival(rock, "other", {9e9, 99, 99});
  }
  return count.result();
}

TEST(Convergence, FollowsEveryFigureFromFewRocksToAll) {
  const Convergence all = of_two_seeders();
  ASSERT_EQ(all.figures.size(), 4u + 2 * 4);
  const FigureConvergence& runout = all.figures[1];
  EXPECT_EQ(runout.figure, (RunFigure{FigureOf::runout, 95}));
  ASSERT_EQ(runout.steps.size(), 6u);
  for (std::size_t k = 0; k < 6; ++k) EXPECT_EQ(runout.steps[k].rocks, 2000u >> (5 - k));
  EXPECT_NEAR(runout.steps.back().estimate->value, 189.9, 0.1);
  // Choices are of both seeders, although their rocks follow each other.
  for (const ConvergenceStep& step : runout.steps) {
    ASSERT_TRUE(step.estimate);
    EXPECT_NEAR(step.estimate->value, 190, 20);
  }
  const auto width = [](const ConvergenceStep& step) { return *step.estimate->high - *step.estimate->low; };
  EXPECT_LT(width(runout.steps.back()), width(runout.steps[2]) / 1.5);
  ASSERT_TRUE(runout.rocks_needed);
  EXPECT_LT(*runout.rocks_needed, 2000u);
}

TEST(Convergence, CountsTheFirstArrivalAtEachLine) {
  const Convergence all = of_two_seeders();
  const FigureConvergence &share = all.figures[8], &energy = all.figures[9], &nothing = all.figures[5];
  EXPECT_EQ(share.line, "Road");
  EXPECT_EQ(share.steps.back().estimate->value, 0.25);
  EXPECT_NEAR(energy.steps.back().estimate->value, 2949, 1);
  EXPECT_EQ(energy.line, "Road");
  EXPECT_EQ(nothing.line, "Fence");
  EXPECT_FALSE(nothing.steps.back().estimate);
  EXPECT_FALSE(nothing.rocks_needed);
}

TEST(Convergence, IsEmptyForFewRocks) {
  ConvergenceCount count(60, {});
  for (std::uint64_t rock = 0; rock < 60; ++rock) count.add_end(rock, {1, 1, 1});
  EXPECT_TRUE(count.result().figures.empty());
}

}  // namespace
}  // namespace talus
