// Two lines one behind the other: every combination of kits, counted rock by rock.

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <tuple>
#include <vector>

#include "results/crossing_rocks.hpp"
#include "support/dice.hpp"
#include "talus/results/design_pairs.hpp"

namespace talus::design_pairs_test {
namespace {

using test::Crosses;
using test::crossing_rock;
using test::result_of;
using test::Seen;
using testing_tools::Dice;

DesignPlan plan_of_two_lines() {
  DesignPlan plan;
  plan.lines = {{.name = "Upper", .barrier = 0, .length = 25, .section_length = 25, .pieces = {{0, 0, 1}}},
                {.name = "Lower", .barrier = 2, .length = 20, .section_length = 20, .pieces = {{0, 0, 1}}}};
  plan.percentiles = {50};
  plan.heights = {1, 2, 4};
  plan.energies = {5e3, 20e3, 50e3};
  plan.catch_share = 0.9;
  plan.cost = {1, 1};
  plan.pairs = {{0, 1}};
  return plan;
}

/// What a kit does with a rock, as a reader of the documentation would say it: the first crossing counts.
struct Way {
  std::optional<double> time;
  bool is_caught = false, is_met = false;
};

Way way_of(const DesignPlan& plan, const std::vector<Crosses>& rock, std::size_t line, double height, double energy) {
  const Crosses* first = nullptr;
  const auto first_on = [&](std::uint32_t barrier) {
    const Crosses* found = nullptr;
    for (const Crosses& crossing : rock) {
      if (crossing.barrier == barrier && (found == nullptr || crossing.time < found->time)) found = &crossing;
    }
    return found;
  };
  first = first_on(plan.lines[line].barrier);
  if (first == nullptr) return {};
  const Crosses* reached = plan.protect ? first_on(*plan.protect) : nullptr;
  if (plan.protect && (reached == nullptr || first->time > reached->time)) return {first->time};
  const double length = plan.lines[line].length;
  if (first->station < plan.free_end || first->station > length - plan.free_end) return {first->time};
  return {first->time, first->height <= height && 100 * first->velocity * first->velocity <= energy, true};
}

bool counts(const DesignPlan& plan, const std::vector<Crosses>& rock) {
  return std::ranges::any_of(rock, [&](const Crosses& crossing) {
    return plan.protect ? crossing.barrier == *plan.protect : crossing.barrier != 1;
  });
}

std::vector<std::vector<Crosses>> random_rocks(Dice& dice, std::size_t count) {
  std::vector<std::vector<Crosses>> rocks(count);
  for (auto& rock : rocks) {
    for (std::uint32_t barrier = 0; barrier < 3; ++barrier) {
      for (std::size_t n = dice.below(3); n > 0; --n) {
        rock.push_back({barrier, dice.between(0, 10), dice.magnitude(1, 40), dice.magnitude(0.1, 8),
                        dice.between(0, 20), dice.chance(0.3)});
      }
    }
  }
  return rocks;
}

// For every combination of kits, the rocks that either catches; of all with the same cost or less, the table has the
// one that catches the most.
TEST(DesignPairs, AgreeWithCountingRockByRock) {
  Dice dice(23);
  for (int trial = 0; trial < 20; ++trial) {
    DesignPlan plan = plan_of_two_lines();
    if (trial % 2 == 1) plan.protect = 2;
    if (trial % 3 == 0) plan.free_end = 2;
    const auto rocks = random_rocks(dice, 60);
    std::vector<Seen> seen;
    for (const auto& rock : rocks) seen.push_back(crossing_rock(rock));
    const DesignResult result = result_of(plan, seen);
    std::uint64_t upper_first = 0, lower_first = 0, of = 0;
    for (const auto& rock : rocks) {
      const Way upper = way_of(plan, rock, 0, 0, 0), lower = way_of(plan, rock, 1, 0, 0);
      of += counts(plan, rock) ? 1 : 0;
      if (!counts(plan, rock) || !upper.time || !lower.time) continue;
      upper_first += *upper.time < *lower.time ? 1 : 0;
      lower_first += *lower.time < *upper.time ? 1 : 0;
    }
    const std::size_t first = upper_first >= lower_first ? 0 : 1;
    ASSERT_FALSE(result.pairs.empty());
    std::map<std::pair<double, std::uint64_t>, int> in_table;
    for (const PairChoice& choice : result.pairs) {
      EXPECT_EQ(choice.first.line, first);
      std::uint64_t caught = 0, by_first = 0, at_second = 0, by_second = 0, beside = 0;
      for (const auto& rock : rocks) {
        if (!counts(plan, rock)) continue;
        const Way a = way_of(plan, rock, choice.first.line, choice.first.height, choice.first.maximum_energy);
        const Way b = way_of(plan, rock, choice.second.line, choice.second.height, choice.second.maximum_energy);
        caught += a.is_caught || b.is_caught ? 1 : 0;
        by_first += a.is_caught ? 1 : 0;
        at_second += !a.is_caught && b.is_met ? 1 : 0;
        by_second += !a.is_caught && b.is_caught ? 1 : 0;
        beside += !a.is_met && !b.is_met ? 1 : 0;
      }
      EXPECT_EQ(choice.caught->of, of);
      EXPECT_EQ(choice.caught->rocks, caught);
      EXPECT_EQ(choice.by_first, by_first);
      EXPECT_EQ(choice.at_second, at_second);
      EXPECT_EQ(choice.by_second, by_second);
      EXPECT_EQ(choice.beside, beside);
      ++in_table[{choice.cost, caught}];
    }
    // No combination is cheaper, or as cheap, and catches more than a row of the table.
    std::vector<std::pair<double, std::uint64_t>> all;
    for (const double h : plan.heights) {
      for (const double e : plan.energies) {
        for (const double i : plan.heights) {
          for (const double f : plan.energies) {
            std::uint64_t caught = 0;
            for (const auto& rock : rocks) {
              caught +=
                  counts(plan, rock) && (way_of(plan, rock, 0, h, e).is_caught || way_of(plan, rock, 1, i, f).is_caught)
                      ? 1
                      : 0;
            }
            all.emplace_back(25 * h * e / 1000 + 20 * i * f / 1000, caught);
          }
        }
      }
    }
    const auto beats = [](const auto& a, const auto& b) {
      return a.first <= b.first && a.second >= b.second && (a.first < b.first || a.second > b.second);
    };
    for (const auto& row : in_table) {
      EXPECT_EQ(row.second, 1);
      EXPECT_TRUE(std::ranges::none_of(all, [&](const auto& other) { return beats(other, row.first); }));
    }
    for (const auto& one : all) {
      const bool is_beaten = std::ranges::any_of(all, [&](const auto& other) { return beats(other, one); });
      EXPECT_EQ(in_table.contains(one), !is_beaten) << one.first << " " << one.second;
    }
  }
}

TEST(DesignPairs, RankThoseThatSufficeByCost) {
  DesignPlan plan = plan_of_two_lines();
  plan.catch_share = 0.75;
  // One rock is too high for 1 m at the upper line, and low at the lower one; one the other way round; two low at both.
  const DesignResult result = result_of(
      plan,
      {crossing_rock({{0, 1, 5, 3, 5}, {2, 2, 5, 0.5, 5}}), crossing_rock({{0, 1, 5, 0.5, 5}, {2, 2, 5, 3, 5}}),
       crossing_rock({{0, 1, 5, 0.5, 5}, {2, 2, 5, 0.5, 5}}), crossing_rock({{0, 1, 5, 0.5, 5}, {2, 2, 5, 0.5, 5}})});
  const PairChoice& best = result.pairs.front();
  EXPECT_TRUE(best.suffices);
  EXPECT_EQ(best.caught->rocks, 4u);
  EXPECT_EQ(best.by_first, 3u);
  EXPECT_EQ(best.at_second, 1u);
  EXPECT_EQ(best.by_second, 1u);
  EXPECT_EQ(best.first.height, 1);
  EXPECT_EQ(best.second.height, 1);
  EXPECT_EQ(best.cost, 25 * 5 + 20 * 5);
  EXPECT_EQ(result.ranking.front().cost, 20 * 5) << "one line alone catches three of four";
}

TEST(DesignPairs, AskForTheOverlapOfTheirDirections) {
  DesignPlan plan = plan_of_two_lines();
  plan.pairs[0].overlap = 3;
  plan.pairs[0].distance = 20;
  Seen rock = crossing_rock({{0, 1, 5, 0.5, 5}, {2, 2, 5, 0.5, 5}});
  rock.log.hits[0].motion.velocity = Vec3(4, 1, -2);
  const PairChoice choice = result_of(plan, {rock}).pairs.front();
  EXPECT_DOUBLE_EQ(*choice.needed_overlap, 20 * 0.25);
  plan.pairs[0].distance.reset();
  EXPECT_FALSE(result_of(plan, {rock}).pairs.front().needed_overlap);
}

TEST(DesignPairs, LeaveOutKitsThatReachWhatIsProtected) {
  DesignPlan plan = plan_of_two_lines();
  plan.lines[1].clearances = {3};
  plan.kits = {{.name = "Slack", .heights = {4}, .maximum_energy = 50e3, .checked_energy = 50e3, .elongation = 4},
               {.name = "Taut", .heights = {4}, .maximum_energy = 50e3, .checked_energy = 50e3, .elongation = 2}};
  plan.kits[0].cost_per_metre = 1;
  plan.kits[1].cost_per_metre = 2;
  const DesignResult result = result_of(plan, {crossing_rock({{0, 1, 5, 3, 5}, {2, 2, 5, 0.5, 5}})});
  ASSERT_EQ(result.pairs.size(), 1u);
  EXPECT_EQ(result.pairs[0].first.kit, 0u) << "there is room behind the upper line";
  EXPECT_EQ(result.pairs[0].second.kit, 1u);
  EXPECT_EQ(result.pairs[0].cost, 25 * 1 + 20 * 2);
}

TEST(DesignPairs, HaveNoShareWithoutRocks) {
  const DesignResult result = result_of(plan_of_two_lines(), {});
  ASSERT_EQ(result.pairs.size(), 1u);
  EXPECT_FALSE(result.pairs[0].caught);
  EXPECT_FALSE(result.pairs[0].suffices);
}

}  // namespace
}  // namespace talus::design_pairs_test
