// Saves summaries and maps and merges them again.

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "support/dice.hpp"
#include "support/saved.hpp"
#include "talus/results/map_observer.hpp"
#include "talus/results/summary.hpp"

namespace talus::saved_results_test {
namespace {

using testing_tools::Dice;
using testing_tools::expect_damage_is_survived;
using testing_tools::saved;
using testing_tools::takes;

struct Seen {
  RockRecord record;
  RockLog log{false, true};
};

/// Rocks that bounce about a few cells on both sides of the origin and meet two barriers.
std::vector<Seen> random_rocks(Dice& dice, std::size_t count) {
  std::vector<Seen> rocks(count);
  for (std::size_t k = 0; k < count; ++k) {
    RockRecord& record = rocks[k].record;
    RockLog& log = rocks[k].log;
    record.rock = k;
    record.source = SourceId{static_cast<std::uint32_t>(dice.below(3))};
    record.body = sphere_of_mass(dice.magnitude(10, 1e5), 2700);
    Vec3 p(dice.between(-40, 40), dice.between(-2, 2), dice.between(0, 3));
    record.outcome.start.position = p;
    for (std::size_t n = 1 + dice.below(5); n-- > 0;) {
      Vec3 v = dice.in_cube(3) * dice.magnitude(0.1, 3);
      v.z() = std::abs(v.z());
      log.pieces.push_back({{p, v, {0, 0, -10}}, dice.magnitude(0.05, 1), 0, dice.in_cube(10), false});
      p = log.pieces.back().path.at(log.pieces.back().duration);
      p.z() = std::abs(p.z());
      if (dice.chance(0.5)) log.impact_places.push_back(p);
    }
    record.outcome.end.position = p;
    record.outcome.reason = dice.chance(0.1) ? EndReason::lost : EndReason::at_rest;
    record.outcome.max_kinetic_energy = dice.magnitude(1e-3, 1e7);
    record.outcome.max_bounce = dice.unit();
    log.ways = {dice.magnitude(1e-3, 1e3), dice.magnitude(1e-3, 1e3)};
    record.outcome.events = static_cast<std::int64_t>(dice.below(9));
    record.was_lifted = dice.chance(0.2);
    if (dice.chance(0.4)) {
      Passage hit;
      hit.barrier = BarrierId{static_cast<std::uint32_t>(dice.below(2))};
      hit.motion.velocity = dice.in_cube(20);
      hit.height = dice.unit();
      hit.outcome = static_cast<BarrierOutcome>(dice.below(4));
      log.hits.push_back(hit);
    }
    if (dice.chance(0.2)) log.passed_above.push_back({{.barrier = BarrierId{1}, .clearance = dice.unit()}});
  }
  return rocks;
}

using Make = std::function<std::unique_ptr<SummingObserver>()>;

void show(SummingObserver& observer, const std::vector<const Seen*>& rocks) {
  const auto part = observer.new_part();
  for (const Seen* seen : rocks) part->see(seen->record, seen->log);
  observer.commit(*part);
}

std::string state_of(const std::vector<Seen>& rocks, const Make& make) {
  std::vector<const Seen*> all;
  for (const Seen& seen : rocks) all.push_back(&seen);
  const auto observer = make();
  show(*observer, all);
  return saved(*observer);
}

// Random splits over observers, each saved, and merged in random order into one that may have seen some rocks itself.
void expect_any_split_merges_to_the_whole(Dice& dice, const std::vector<Seen>& rocks, const Make& make) {
  const std::string whole = state_of(rocks, make);
  for (int trial = 0; trial < 10; ++trial) {
    std::vector<std::vector<const Seen*>> shards(1 + dice.below(7));
    for (const Seen& seen : rocks) shards[dice.below(shards.size())].push_back(&seen);
    const auto merged = make();
    if (dice.chance(0.5)) {
      show(*merged, shards.back());
      shards.pop_back();
    }
    std::vector<std::string> states;
    for (const auto& shard : shards) {
      const auto observer = make();
      show(*observer, shard);
      states.push_back(saved(*observer));
    }
    while (!states.empty()) {
      const std::size_t k = dice.below(states.size());
      ASSERT_TRUE(takes(*merged, states[k]));
      states.erase(states.begin() + static_cast<std::ptrdiff_t>(k));
    }
    EXPECT_EQ(saved(*merged), whole);
  }
  const std::vector<Seen> fewer(rocks.begin(), rocks.end() - 1);
  EXPECT_NE(state_of(fewer, make), whole) << "the comparison can fail";
}

/// A copyable wrapper of an observer, for the tools of support/saved.hpp.
struct Handle {
  std::unique_ptr<SummingObserver> observer;
  void merge_saved(ByteReader& in) { observer->merge_saved(in); }
};

TEST(SavedResults, Summaries) {
  Dice dice(11);
  const std::vector<Seen> rocks = random_rocks(dice, 300);
  for (const std::uint64_t planned : {300U, 5'000'000U}) {
    LocalFrame frame;
    frame.origin = {2.6e6, 1.2e6, 0};
    const Make make = [&] { return std::make_unique<SummaryObserver>(planned, 2, frame); };
    expect_any_split_merges_to_the_whole(dice, rocks, make);
    expect_damage_is_survived<Handle>(
        dice, state_of(rocks, make), [&] { return Handle{make()}; },
        [](Handle& handle) {
          const Summary& summary = static_cast<SummaryObserver&>(*handle.observer).summary();
          (void)summary.end_x.sketch().quantile(0.5);
          (void)summary.end_x.describe();
        });
  }
}

TEST(SavedResults, RefuseSummariesOfOtherRuns) {
  SummaryObserver mine(10, 1, {}), longer(11, 1, {}), more_barriers(10, 2, {});
  EXPECT_FALSE(takes(longer, saved(mine)));
  EXPECT_FALSE(takes(more_barriers, saved(mine)));
  SummaryObserver elsewhere(10, 1, {Vec3(1024, 0, 0)});
  EXPECT_FALSE(takes(elsewhere, saved(mine))) << "its positions have another origin";
  EXPECT_TRUE(takes(mine, saved(mine)));
}

/// On level ground at z = 0.
void heights(const Rock&, const PathPiece& piece, std::span<const double> borders, std::span<double> heights) {
  for (std::size_t k = 0; k < heights.size(); ++k)
    heights[k] = std::max({0.0, piece.path.z(borders[k]), piece.path.z(borders[k + 1])});
}

TEST(SavedResults, Maps) {
  Dice dice(13);
  const std::vector<Seen> rocks = random_rocks(dice, 400);
  for (const auto& [sources, ensembles] :
       {std::pair<std::optional<std::size_t>, std::size_t>({}, 0), {3, 0}, {{}, 5}}) {
    const Make make = [&] {
      return std::make_unique<MapObserver>(MapGrid({0, 0}, 1, {}), heights, sources, MapContents(), ensembles);
    };
    expect_any_split_merges_to_the_whole(dice, rocks, make);
    expect_damage_is_survived<Handle>(
        dice, state_of(rocks, make), [&] { return Handle{make()}; },
        [](Handle& handle) {
          const Maps& maps = static_cast<MapObserver&>(*handle.observer).maps();
          for (const Maps::Tile* tile : maps.tiles()) {
            for (std::int32_t k = 0; k < Maps::tile_side * Maps::tile_side; ++k) {
              const auto tally = tile->find(k % Maps::tile_side, k / Maps::tile_side);
              if (tally) (void)tally->percentile(MapQuantity::velocity, 95);
            }
          }
        });
  }
}

TEST(SavedResults, RefuseMapsOfAnotherGridOrOtherSources) {
  const auto maps = [](double cell, std::optional<std::size_t> sources, std::size_t ensembles = 0) {
    return std::make_unique<MapObserver>(MapGrid({0, 0}, cell, {}), heights, sources, MapContents(), ensembles);
  };
  const auto mine = maps(1, 2);
  for (const auto& other : {maps(0.5, 2), maps(1, 3), maps(1, {}), maps(1, 2, 1)})
    EXPECT_FALSE(takes(*other, saved(*mine)));
  EXPECT_TRUE(takes(*mine, saved(*mine)));
}

}  // namespace
}  // namespace talus::saved_results_test
