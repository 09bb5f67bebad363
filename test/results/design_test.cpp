// The design of barriers, from hand-made crossings to the best kit.

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <vector>

#include "results/crossing_rocks.hpp"
#include "support/dice.hpp"
#include "support/saved.hpp"
#include "talus/results/design_result.hpp"

namespace talus::design_test {
namespace {

using test::Crosses;
using test::crossing_rock;
using test::result_of;
using test::Seen;
using test::show;
using testing_tools::Dice;
using testing_tools::expect_damage_is_survived;
using testing_tools::saved;
using testing_tools::takes;

/// Two lines, 0 of 25 m in sections of 10 m, 2 of 8 m; kits of 2 and 4 m, 10 and 20 kJ.
DesignPlan plan_without_factors() {
  DesignPlan plan;
  plan.lines = {{"Upper", 0, 25, 10, 3}, {"Lower", 2, 8, 10, 1}};
  plan.percentiles = {50, 100};
  plan.heights = {2, 4};
  plan.energies = {10e3, 20e3};
  plan.catch_share = 0.75;
  plan.cost = {1, 1};
  return plan;
}

TEST(DesignLine, IsCutIntoSections) {
  const DesignLine line{"Upper", 0, 25, 10, 3};
  EXPECT_EQ(line.section_at(-1e-9), 0u);
  EXPECT_EQ(line.section_at(0), 0u);
  EXPECT_EQ(line.section_at(9.99), 0u);
  EXPECT_EQ(line.section_at(10), 1u);
  EXPECT_EQ(line.section_at(24.9), 2u);
  EXPECT_EQ(line.section_at(25 + 1e-9), 2u);
  EXPECT_EQ(line.section_at(1e9), 2u);
  EXPECT_EQ(line.section_begin(0), 0);
  EXPECT_EQ(line.section_begin(2), 20);
  EXPECT_EQ(line.section_begin(3), 25);
  EXPECT_EQ((DesignLine{"Place in 2D", 0}.section_at(1)), 0u);
}

TEST(DesignLine, BeginsAtItsFirstPointOnTheTerrain) {
  const DesignLine line{"Upper", 0, 25, 10, 3, 100};
  EXPECT_EQ(line.section_at(90), 0u);
  EXPECT_EQ(line.section_at(109.9), 0u);
  EXPECT_EQ(line.section_at(110), 1u);
  EXPECT_EQ(line.section_begin(0), 100);
  EXPECT_EQ(line.section_begin(3), 125);
}

TEST(Design, TakesTheFirstCrossingOfEachRockAtAnyHeight) {
  const DesignResult result = result_of(
      plan_without_factors(),
      {crossing_rock({{0, 1.0, 10, 1.5, 5}}),
       crossing_rock({{0, 3.0, 4, 0.5, 15}, {0, 2.0, 6, 2.5, 5, true}}),                // above, and back into it
       crossing_rock({{0, 1.0, 12, 1.0, 22}, {1, 1.5, 90, 9, 5}, {2, 2.0, 14, 3, 4}}),  // a line without a design
       crossing_rock({})});
  const DesignResult::Line& upper = result.lines[0];
  EXPECT_EQ(upper.whole.rocks, 3u);
  EXPECT_EQ(upper.whole.from, 0);
  EXPECT_EQ(upper.whole.to, 25);
  EXPECT_EQ(upper.whole.share->value, 0.75);
  ASSERT_EQ(upper.sections.size(), 3u);
  EXPECT_EQ(upper.sections[0].rocks, 2u);
  EXPECT_EQ(upper.sections[1].rocks, 0u);
  EXPECT_EQ(upper.sections[2].rocks, 1u);
  EXPECT_EQ(upper.sections[2].from, 20);
  EXPECT_EQ(upper.sections[2].to, 25);
  EXPECT_EQ(result.lines[1].whole.rocks, 1u);
  const auto& [translational, total, velocity, height] = upper.whole.percentiles;
  ASSERT_EQ(translational.size(), 2u);
  EXPECT_DOUBLE_EQ(translational[0].value, 0.5 * 200 * 10 * 10);
  EXPECT_DOUBLE_EQ(translational[1].value, 0.5 * 200 * 12 * 12);
  EXPECT_DOUBLE_EQ(total[0].value, 1.1 * 0.5 * 200 * 10 * 10);
  EXPECT_DOUBLE_EQ(velocity[0].value, 10);
  EXPECT_DOUBLE_EQ(velocity[1].value, 12);
  EXPECT_DOUBLE_EQ(height[0].value, 1.5);
  EXPECT_DOUBLE_EQ(height[1].value, 2.5);
  EXPECT_TRUE(upper.sections[1].percentiles[0].empty());
  EXPECT_FALSE(upper.sections[1].demand);
}

TEST(Design, AppliesTheCheck) {
  DesignPlan plan = plan_without_factors();
  plan.design_percentile = 50;
  plan.factors.velocity = plan.factors.height = 1.1;
  plan.factors.mass = 1.05;
  plan.factors.capacity = 1.2;
  plan.factors.clearance = 0.2;
  plan.factors.clears_half_the_block = true;
  std::vector<Seen> rocks;
  for (int k = 1; k <= 9; ++k) rocks.push_back(crossing_rock({{0, 1, k * 10.0, k * 1.0, 5}}));
  const DesignFigures whole = result_of(plan, rocks).lines[0].whole;
  // The median: 50 m/s, 250 kJ, 4.7 m of the centre; the radius of 0.3 m is more than the clearance.
  EXPECT_DOUBLE_EQ(whole.demand->maximum_energy, 250e3 * 1.05 * 1.1 * 1.1 * 1.2);
  EXPECT_EQ(whole.demand->kit_class, 2);
  EXPECT_DOUBLE_EQ(whole.demand->height, 4.7 * 1.1 + 0.3);
  // The median of nine values is below the eighth with 98 %: 80 m/s, 640 kJ.
  EXPECT_DOUBLE_EQ(whole.demand_at_upper_end->maximum_energy, 640e3 * 1.05 * 1.1 * 1.1 * 1.2);
  EXPECT_DOUBLE_EQ(whole.demand_at_upper_end->height, 7.7 * 1.1 + 0.3);
  plan.factors.block_mass = 1000;
  EXPECT_DOUBLE_EQ(result_of(plan, rocks).lines[0].whole.demand->maximum_energy,
                   0.5 * 1000 * 50 * 50 * 1.05 * 1.1 * 1.1 * 1.2);
  plan.design_percentile = 95;
  EXPECT_FALSE(result_of(plan, rocks).lines[0].whole.demand_at_upper_end) << "nine values say too little of it";
}

/// Eight rocks at the upper line: seven with up to 10 kJ (10 m/s), one of them 3 m high; one with 14.4 kJ and 1 m. Four
/// of them at the lower line, all with 14.4 kJ and below 2 m.
std::vector<Seen> eight_rocks() {
  std::vector<Seen> rocks;
  for (int k = 0; k < 6; ++k) rocks.push_back(crossing_rock({{0, 1, 10, 1, 5}}));
  rocks.push_back(crossing_rock({{0, 1, 10, 3, 15, true}}));
  rocks.push_back(crossing_rock({{0, 1, 12, 1, 15}}));
  for (int k = 0; k < 4; ++k) {
    const Seen below = crossing_rock({{2, 2, 12, 1.5, 4}});
    rocks[static_cast<std::size_t>(2 * k)].log.hits.push_back(below.log.hits.front());
  }
  return rocks;
}

void expect_kit(const KitChoice& kit, std::size_t line, double height, double energy, bool suffices,
                std::uint64_t caught, std::uint64_t above, std::uint64_t through, double cost) {
  EXPECT_EQ(kit.line, line);
  EXPECT_EQ(kit.height, height);
  EXPECT_EQ(kit.maximum_energy, energy);
  EXPECT_EQ(kit.suffices, suffices);
  EXPECT_EQ(kit.caught->rocks, caught);
  EXPECT_EQ(kit.above, above);
  EXPECT_EQ(kit.through, through);
  EXPECT_DOUBLE_EQ(kit.cost, cost);
}

TEST(Design, RanksKitsByWhatTheyCatchAndCost) {
  const DesignResult result = result_of(plan_without_factors(), eight_rocks());
  // The target is three of four. Lower: all four need 20 kJ; 8 m long. Upper: 6 of 8 with 2 m and 10 kJ; 25 m long. A
  // height of 4 m catches one more at the upper line, and none at the lower.
  ASSERT_EQ(result.ranking.size(), 3u);
  expect_kit(result.ranking[0], 1, 2, 20e3, true, 4, 0, 0, 8 * 2 * 20);
  expect_kit(result.ranking[1], 0, 2, 10e3, true, 6, 1, 1, 25 * 2 * 10);
  expect_kit(result.ranking[2], 0, 4, 10e3, true, 7, 0, 1, 25 * 4 * 10);
  EXPECT_EQ(result.ranking[1].caught->of, 8u);
  EXPECT_EQ(result.ranking[1].kit_class, std::nullopt) << "10 kJ are less than any class has";
  EXPECT_NEAR(result.ranking[1].caught->low, 0.3491, 5e-5);  // Clopper and Pearson, 6 of 8
  EXPECT_NEAR(result.ranking[1].caught->high, 0.9681, 5e-5);
}

// The interval of 6 of 8 is 0.349 to 0.968, that of 7 of 8 is 0.473 to 0.997.
TEST(Design, IsSureIfTheWholeIntervalAgrees) {
  DesignPlan plan = plan_without_factors();
  plan.lines.resize(1);
  plan.energies = {10e3};
  const auto sure_of = [&](double wanted) {
    plan.catch_share = wanted;
    std::vector<std::pair<bool, bool>> found;
    for (const KitChoice& kit : result_of(plan, eight_rocks()).ranking) found.emplace_back(kit.suffices, kit.is_sure);
    return found;
  };
  using Found = std::vector<std::pair<bool, bool>>;
  EXPECT_EQ(sure_of(0.3), (Found{{true, true}, {true, true}}));
  EXPECT_EQ(sure_of(0.4), (Found{{true, false}, {true, true}}));
  EXPECT_EQ(sure_of(0.75), (Found{{true, false}, {true, false}}));
  EXPECT_EQ(sure_of(0.96), (Found{{false, false}, {false, false}}));
  EXPECT_EQ(sure_of(0.98), (Found{{false, false}, {false, true}}));
}

// Ten rocks reach the lower line, which is protected; six of them cross the upper one, five of these 1 m high and one 3
// m. The others pass beyond its ends: no kit there catches 75 %, and the smallest that catches 75 % of the six ranks
// first.
TEST(Design, NamesTheEndsOfTheLineAsTheLimit) {
  DesignPlan plan = plan_without_factors();
  plan.protect = 2;
  plan.lines.resize(1);
  std::vector<Seen> rocks;
  for (int k = 0; k < 10; ++k) {
    Seen seen = crossing_rock({{2, 2, 12, 1.5, 4}});
    if (k < 6) {
      const Seen at_upper = crossing_rock({{0, 1, 10, k < 5 ? 1.0 : 3.0, 5, k == 5}});
      seen.log.hits.insert(seen.log.hits.begin(), at_upper.log.hits.begin(), at_upper.log.hits.end());
      seen.log.passed_above = at_upper.log.passed_above;
    }
    rocks.push_back(seen);
  }
  const DesignResult result = result_of(plan, rocks);
  ASSERT_EQ(result.ranking.size(), 2u);
  expect_kit(result.ranking[0], 0, 2, 10e3, false, 5, 1, 0, 25 * 2 * 10);
  expect_kit(result.ranking[1], 0, 4, 10e3, false, 6, 0, 0, 25 * 4 * 10);
  for (const KitChoice& kit : result.ranking) {
    EXPECT_EQ(kit.limit, KitLimit::ends);
    EXPECT_EQ(kit.beside, 4u);
  }
  // For 60 % enough rocks cross the line: 4 m catch six of ten, 2 m only five.
  plan.catch_share = 0.6;
  const DesignResult lower = result_of(plan, rocks);
  EXPECT_EQ(lower.ranking[0].height, 4);
  EXPECT_EQ(lower.ranking[0].limit, KitLimit::none);
  EXPECT_EQ(lower.ranking[1].limit, KitLimit::height);
}

// With at most 10 kJ, seven of the eight at the upper line are caught: one has more energy.
TEST(Design, NamesTheEnergyAsTheLimit) {
  DesignPlan plan = plan_without_factors();
  plan.lines.resize(1);
  plan.catch_share = 0.95;
  plan.energies = {10e3};
  const DesignResult result = result_of(plan, eight_rocks());
  EXPECT_EQ(result.ranking[0].height, 4);
  EXPECT_EQ(result.ranking[0].limit, KitLimit::energy);
  EXPECT_EQ(result.ranking[1].limit, KitLimit::height);
}

TEST(Design, RanksKitsLastThatCatchTooFew) {
  DesignPlan plan = plan_without_factors();
  plan.catch_share = 0.95;
  const DesignResult result = result_of(plan, eight_rocks());
  expect_kit(result.ranking[0], 1, 2, 20e3, true, 4, 0, 0, 8 * 2 * 20);
  expect_kit(result.ranking[1], 0, 4, 20e3, true, 8, 0, 0, 25 * 4 * 20);
  expect_kit(result.ranking[2], 0, 2, 20e3, false, 7, 1, 0, 25 * 2 * 20);
}

// Half of the rocks roll over the line with 14.4 kJ, the others fly over it with 10 kJ at 3 m: a kit of 4 m needs less
// energy.
TEST(Design, KeepsAHigherKitThatNeedsLessEnergy) {
  DesignPlan plan = plan_without_factors();
  plan.lines.resize(1);
  plan.catch_share = 0.5;
  std::vector<Seen> rocks;
  for (int k = 0; k < 2; ++k) rocks.push_back(crossing_rock({{0, 1, 12, 0.6 + 1e-7, 5}}));
  for (int k = 0; k < 2; ++k) rocks.push_back(crossing_rock({{0, 1, 10, 3, 5}}));
  const DesignResult result = result_of(plan, rocks);
  ASSERT_EQ(result.ranking.size(), 2u);
  // Both cost the same, and the lower kit comes first.
  expect_kit(result.ranking[0], 0, 2, 20e3, true, 2, 2, 0, 25 * 2 * 20);
  expect_kit(result.ranking[1], 0, 4, 10e3, true, 2, 0, 2, 25 * 4 * 10);
  EXPECT_NEAR(result.lines[0].whole.percentiles[3][0].value, 1.8, 1e-9) << "a height by rounding is none";
}

TEST(Design, DoesNotOfferEnergyThatDoesNotHelp) {
  DesignPlan plan = plan_without_factors();
  plan.energies = {10e3, 20e3, 40e3, 80e3};
  plan.catch_share = 0.95;
  const DesignResult result = result_of(plan, eight_rocks());
  expect_kit(result.ranking.back(), 0, 2, 20e3, false, 7, 1, 0, 25 * 2 * 20);
}

TEST(Design, HasNoKitWithoutRocks) {
  const DesignResult result = result_of(plan_without_factors(), {});
  EXPECT_FALSE(result.lines[0].whole.share);
  ASSERT_EQ(result.ranking.size(), 2u);
  EXPECT_FALSE(result.ranking[0].suffices);
  EXPECT_FALSE(result.ranking[0].caught);
  EXPECT_FALSE(result.ranking[0].is_sure);
}

// Line 2 is protected. Four of eight rocks reach it: three of them across line 0, and one that passes line 0 only
// afterwards.
TEST(Design, CountsTheRocksThatReachTheProtectedLine) {
  DesignPlan plan = plan_without_factors();
  plan.protect = 2;
  std::vector<Seen> rocks;
  for (int k = 0; k < 4; ++k) rocks.push_back(crossing_rock({{0, 1, 10, 1, 5}}));  // end between the two
  for (int k = 0; k < 2; ++k) rocks.push_back(crossing_rock({{0, 1, 10, 1, 5}, {2, 2, 12, 1, 4}}));
  rocks.push_back(crossing_rock({{0, 3, 10, 1, 5}, {2, 2, 12, 1, 4}}));
  rocks.push_back(crossing_rock({{2, 2, 12, 1, 4}}));
  const DesignResult result = result_of(plan, rocks);
  EXPECT_EQ(result.lines[0].whole.rocks, 7u) << "figures along a line are of all rocks that cross it";
  const auto kit =
      std::ranges::find_if(result.ranking, [](const KitChoice& k) { return k.line == 0 && k.height == 2; });
  EXPECT_EQ(kit->caught->of, 4u);
  EXPECT_EQ(kit->caught->rocks, 2u);
  EXPECT_EQ(kit->beside, 2u);
  EXPECT_FALSE(kit->suffices);
  const auto at_it = std::ranges::find_if(result.ranking, [](const KitChoice& k) { return k.line == 1; });
  EXPECT_EQ(at_it->caught->of, 4u);
  EXPECT_EQ(at_it->caught->rocks, 4u);
  EXPECT_EQ(at_it->beside, 0u);
}

std::vector<Seen> random_rocks(Dice& dice, std::size_t count) {
  std::vector<Seen> rocks;
  for (std::size_t k = 0; k < count; ++k) {
    std::vector<Crosses> crossings;
    for (std::uint32_t barrier = 0; barrier < 3; ++barrier) {
      for (std::size_t n = dice.below(3); n > 0; --n) {
        crossings.push_back({barrier, dice.between(0, 10), dice.magnitude(1, 40), dice.magnitude(0.1, 8),
                             dice.between(0, 25), dice.chance(0.3)});
      }
    }
    rocks.push_back(crossing_rock(crossings));
  }
  return rocks;
}

TEST(Design, IsTheSameForAnySplitAndOrderOfTheRocks) {
  Dice dice(17);
  std::vector<Seen> rocks = random_rocks(dice, 300);
  for (const std::uint64_t planned : {300U, 5'000'000U}) {
    for (const bool protects : {false, true}) {
      DesignPlan plan = plan_without_factors();
      if (protects) plan.protect = 2;
      plan.pairs = {{0, 1}};
      plan.free_end = 1;
      const auto make = [&] { return std::make_unique<DesignObserver>(plan, planned); };
      const auto whole = make();
      show(*whole, rocks);
      for (int trial = 0; trial < 5; ++trial) {
        for (std::size_t k = rocks.size(); k > 1; --k) std::swap(rocks[k - 1], rocks[dice.below(k)]);
        std::vector<std::vector<Seen>> shards(1 + dice.below(7));
        for (const Seen& seen : rocks) shards[dice.below(shards.size())].push_back(seen);
        const auto merged = make();
        show(*merged, shards.back());
        shards.pop_back();
        for (const auto& shard : shards) {
          const auto observer = make();
          show(*observer, shard);
          ASSERT_TRUE(takes(*merged, saved(*observer)));
        }
        EXPECT_EQ(saved(*merged), saved(*whole));
      }
      const auto fewer = make();
      show(*fewer, {rocks.begin(), rocks.end() - 1});
      EXPECT_NE(saved(*fewer), saved(*whole)) << "the comparison can fail";
    }
  }
}

struct Handle {
  std::unique_ptr<DesignObserver> observer;
  void merge_saved(ByteReader& in) { observer->merge_saved(in); }
};

TEST(Design, SurvivesDamagedBytes) {
  Dice dice(19);
  const std::vector<Seen> rocks = random_rocks(dice, 30);
  DesignPlan plan = plan_without_factors();
  plan.pairs = {{0, 1}};
  for (const std::uint64_t planned : {30U, 5'000'000U}) {
    const auto make = [&] { return std::make_unique<DesignObserver>(plan, planned); };
    const auto whole = make();
    show(*whole, rocks);
    expect_damage_is_survived<Handle>(
        dice, saved(*whole), [&] { return Handle{make()}; },
        [](Handle& handle) { (void)evaluate(handle.observer->plan(), handle.observer->tally()); });
  }
}

TEST(Design, RefusesStatesOfOtherLinesOrKits) {
  const DesignPlan plan = plan_without_factors();
  DesignObserver mine(plan, 10);
  const auto with = [&](const std::function<void(DesignPlan&)>& change) {
    DesignPlan other = plan;
    change(other);
    return DesignObserver(other, 10);
  };
  DesignObserver fewer_lines = with([](DesignPlan& p) { p.lines.pop_back(); });
  DesignObserver more_sections = with([](DesignPlan& p) { p.lines[1].sections = 2; });
  DesignObserver more_heights = with([](DesignPlan& p) { p.heights.push_back(5); });
  DesignObserver with_pairs = with([](DesignPlan& p) { p.pairs = {{0, 1}}; });
  for (DesignObserver* other : {&fewer_lines, &more_sections, &more_heights, &with_pairs})
    EXPECT_FALSE(takes(*other, saved(mine)));
  EXPECT_TRUE(takes(mine, saved(mine)));
}

}  // namespace
}  // namespace talus::design_test
