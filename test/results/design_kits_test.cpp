// Kits on the market, free ends, clearances and directions, from hand-made crossings.

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "results/crossing_rocks.hpp"
#include "talus/results/design_result.hpp"

namespace talus::design_kits_test {
namespace {

using test::crossing_rock;
using test::result_of;
using test::Seen;

/// A line of 100 m along y in ten sections, crossed in the direction of x.
DesignPlan plan_of_one_line() {
  DesignPlan plan;
  plan.lines = {
      {.name = "Line", .barrier = 0, .length = 100, .section_length = 10, .sections = 10, .pieces = {{0, 0, 1}}}};
  plan.percentiles = {50};
  plan.heights = {2, 4};
  plan.energies = {10e3, 20e3};
  plan.catch_share = 0.75;
  plan.cost = {1, 1};
  return plan;
}

/// Rocks of 200 kg: two with 10 kJ, 1 m high; one with 10 kJ, 2.5 m high; one with 22.5 kJ, 1 m high.
std::vector<Seen> four_rocks() {
  return {crossing_rock({{0, 1, 10, 1, 50}}), crossing_rock({{0, 1, 10, 1, 50}}), crossing_rock({{0, 1, 10, 2.5, 50}}),
          crossing_rock({{0, 1, 15, 1, 50}})};
}

// Worked by hand: A catches the two low ones (2 m) or also the high one (4 m); B, twice as strong and dearer, all.
TEST(DesignKits, AreRankedAsTheyAre) {
  DesignPlan plan = plan_of_one_line();
  plan.heights = {1, 1.2, 2, 2.5, 4, 5};
  plan.energies = {10e3, 30e3};
  plan.kits = {{.name = "A", .heights = {2, 4}, .maximum_energy = 10e3, .checked_energy = 10e3, .residual_share = 0.5},
               {.name = "B", .heights = {4}, .maximum_energy = 30e3, .checked_energy = 30e3, .residual_share = 0.3}};
  plan.kits[0].cost_per_metre = 100;
  plan.kits[1].cost_per_metre = 250;
  const DesignResult result = result_of(plan, four_rocks());
  ASSERT_EQ(result.ranking.size(), 3u);
  const KitChoice &a4 = result.ranking[0], &b4 = result.ranking[1], &a2 = result.ranking[2];
  EXPECT_EQ(a4.kit, 0u);
  EXPECT_EQ(a4.height, 4);
  EXPECT_EQ(a4.caught->rocks, 3u);
  EXPECT_EQ(a4.through, 1u);
  EXPECT_TRUE(a4.suffices);
  EXPECT_EQ(a4.cost, 100 * 100);
  EXPECT_EQ(b4.kit, 1u);
  EXPECT_EQ(b4.caught->rocks, 4u);
  EXPECT_EQ(b4.cost, 100 * 250);
  EXPECT_FALSE(a2.suffices);
  EXPECT_EQ(a2.caught->rocks, 2u);
  EXPECT_EQ(a2.limit, KitLimit::energy) << "without the energy, 2 m would catch three of four";
  // What remains: 2 m of A at 4 m, with the three low ones below; 1.2 m of B; 1 m of A at 2 m.
  EXPECT_EQ(a4.residual_height, 2);
  EXPECT_EQ(a4.below_residual->rocks, 3u);
  EXPECT_EQ(b4.residual_height, 4 * 0.3);
  EXPECT_EQ(b4.below_residual->rocks, 3u);
  EXPECT_EQ(a2.residual_height, 1);
  EXPECT_EQ(a2.below_residual->rocks, 3u);
}

TEST(DesignKits, NoHeightRemainsOfCategoryC) {
  DesignPlan plan = plan_of_one_line();
  plan.kits = {{.name = "C", .heights = {4}, .maximum_energy = 20e3, .checked_energy = 20e3, .residual_share = 0}};
  const KitChoice kit = result_of(plan, four_rocks()).ranking.front();
  EXPECT_EQ(kit.residual_height, 0);
  EXPECT_EQ(kit.below_residual->rocks, 0u) << "not even those that roll";
}

// 5 m in the test, times 1.3, are 6.5 m. The narrowest section has 6.4 m.
TEST(DesignKits, MayNotReachWhatIsProtected) {
  DesignPlan plan = plan_of_one_line();
  plan.lines[0].clearances = {12, 11, 10, 9, 8, 7, 6.4, 7, 8, 9};
  plan.factors.elongation = 1.3;
  plan.energies = {10e3, 30e3};
  plan.kits = {{.name = "Slack", .heights = {4}, .maximum_energy = 30e3, .checked_energy = 30e3, .elongation = 5},
               {.name = "Taut", .heights = {4}, .maximum_energy = 30e3, .checked_energy = 30e3, .elongation = 4}};
  plan.kits[0].cost_per_metre = 1;
  plan.kits[1].cost_per_metre = 2;
  DesignResult result = result_of(plan, four_rocks());
  EXPECT_EQ(result.lines[0].sections[6].clearance, 6.4);
  EXPECT_DOUBLE_EQ(*result.lines[0].sections[6].most_elongation, 6.4 / 1.3);
  EXPECT_EQ(result.lines[0].whole.clearance, 6.4);
  ASSERT_EQ(result.ranking.size(), 2u);
  EXPECT_EQ(result.ranking[0].kit, 1u) << "the other is cheaper";
  EXPECT_TRUE(result.ranking[0].suffices);
  EXPECT_EQ(result.ranking[0].needed_clearance, 4 * 1.3);
  EXPECT_FALSE(result.ranking[1].suffices);
  EXPECT_EQ(result.ranking[1].limit, KitLimit::clearance);
  EXPECT_EQ(result.ranking[1].needed_clearance, 6.5);
  EXPECT_EQ(result.ranking[1].clearance, 6.4);
  plan.lines[0].clearances[6] = 6.5;
  result = result_of(plan, four_rocks());
  EXPECT_EQ(result.ranking[0].kit, 0u) << "D_A = D_d is enough";
  plan.factors.elongation.reset();
  EXPECT_FALSE(result_of(plan, four_rocks()).ranking[0].needed_clearance) << "the factor is unknown";
}

TEST(DesignKits, ServeTheLevelOfTheCheck) {
  DesignPlan plan = plan_of_one_line();
  plan.factors.level = KitLevel::service;
  // The rocks with 10 kJ ask for a SEL of 10 kJ. A kit with a MEL of 40 kJ whose SEL is only 9 kJ does not have it.
  plan.energies = {27e3, 40e3};
  plan.kits = {{.name = "Weak", .heights = {4}, .maximum_energy = 40e3, .checked_energy = 27e3},
               {.name = "Usual", .heights = {4}, .maximum_energy = 40e3, .checked_energy = 40e3}};
  const DesignResult result = result_of(plan, four_rocks());
  EXPECT_EQ(result.ranking[0].kit, 1u);
  EXPECT_EQ(result.ranking[0].caught->rocks, 3u);
  EXPECT_EQ(result.ranking[1].caught->rocks, 0u);
  EXPECT_EQ(result.ranking[1].through, 4u);
}

TEST(DesignFreeEnds, CatchNothing) {
  DesignPlan plan = plan_of_one_line();
  std::vector<Seen> rocks;
  for (const double station : {0.0, 4.9, 5.0, 50.0, 95.0, 95.1, 100.0}) {
    rocks.push_back(crossing_rock({{0, 1, 10, 1, station}}));
  }
  EXPECT_EQ(result_of(plan, rocks).ranking[0].caught->rocks, 7u);
  plan.free_end = 5;
  const DesignResult result = result_of(plan, rocks);
  EXPECT_EQ(result.ranking[0].caught->rocks, 3u);
  EXPECT_EQ(result.ranking[0].caught->of, 7u);
  EXPECT_EQ(result.ranking[0].beside, 4u);
  EXPECT_EQ(result.ranking[0].limit, KitLimit::ends);
  EXPECT_EQ(result.lines[0].whole.rocks, 7u) << "figures along a line are of all rocks that cross it";
}

TEST(DesignFreeEnds, CountFromWhereTheLineStands) {
  const DesignLine line{.name = "Line", .length = 20, .section_length = 10, .sections = 2, .start = 100};
  EXPECT_TRUE(line.is_at_free_end(103.9, 4));
  EXPECT_FALSE(line.is_at_free_end(104, 4));
  EXPECT_FALSE(line.is_at_free_end(116, 4));
  EXPECT_TRUE(line.is_at_free_end(116.1, 4));
  EXPECT_FALSE((DesignLine{.name = "In 2D"}.is_at_free_end(0, 4)));
}

TEST(DesignLine, MeasuresDirectionsAcrossItself) {
  const DesignLine line{.name = "Bent", .length = 20, .section_length = 20, .pieces = {{0, 0, 1}, {10, 0.6, 0.8}}};
  EXPECT_DOUBLE_EQ(line.lateral_of(5, Vec3(4, 3, -9)), 0.75);
  EXPECT_DOUBLE_EQ(line.lateral_of(5, Vec3(-4, -3, 0)), 0.75);
  EXPECT_DOUBLE_EQ(line.lateral_of(-1, Vec3(4, 3, 0)), 0.75) << "before the first piece, as at its beginning";
  EXPECT_NEAR(line.lateral_of(15, Vec3(0.8, -0.6, 0)), 0, 1e-15) << "straight across the second piece";
  EXPECT_EQ(line.lateral_of(5, Vec3(0, 3, 0)), 1e6) << "along it";
  EXPECT_EQ(line.lateral_of(5, Vec3(0, 0, -3)), 1e6);
  EXPECT_EQ((DesignLine{.name = "In 2D"}.lateral_of(0, Vec3(1, 1, 0))), 0);
}

}  // namespace
}  // namespace talus::design_kits_test
