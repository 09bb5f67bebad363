#include "talus/results/maps.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <tuple>
#include <utility>
#include <vector>

#include "support/dice.hpp"
#include "talus/results/map_observer.hpp"
#include "talus/statistics/quantile.hpp"
#include "talus/terrain/profile.hpp"

namespace talus::maps_test {
namespace {

using testing_tools::Dice;
using enum MapQuantity;

struct Seen {
  RockRecord record;
  RockLog log{false, true};
};

const MapGrid unit_grid({0, 0}, 1, {});

/// Level ground at z, from x = -1 km to `end`.
Profile level_ground(double z = 0, double end = 1000) {
  const Vec2 vertices[] = {{-1000, z}, {end, z}};
  return Profile(vertices);
}
const Profile flat_ground = level_ground();
const MaxHeights over_flat_ground = max_height_over(flat_ground, RockModel::lumped_mass);

/// A rock with these pieces, which need not join.
Seen rock_of(std::vector<PathPiece> pieces, EndReason reason = EndReason::at_rest, double mass = 1000) {
  Seen seen;
  seen.record.body = sphere_of_mass(mass, 2700);
  seen.record.outcome.reason = reason;
  seen.record.outcome.end.position = pieces.back().path.at(pieces.back().duration);
  seen.log.pieces = std::move(pieces);
  return seen;
}

PathPiece flight(const Vec3& p, const Vec3& v, double duration, const Vec3& spin = Vec3{}) {
  return {{p, v, {0, 0, -10}}, duration, 0, spin, false};
}

Maps maps_of(const std::vector<Seen>& rocks, RockModel model = RockModel::lumped_mass) {
  MapObserver observer(unit_grid, max_height_over(flat_ground, model));
  const auto part = observer.new_part();
  for (const Seen& seen : rocks) part->see(seen.record, seen.log);
  observer.commit(*part);
  Maps maps(unit_grid);
  maps.merge(observer.maps());
  return maps;
}

std::optional<MapTally> tally_at(const Maps& maps, MapCell cell) {
  for (const Maps::Tile* tile : maps.tiles()) {
    const std::int32_t column = cell.column - tile->first().column, row = cell.row - tile->first().row;
    const bool inside = column >= 0 && row >= 0 && column < Maps::tile_side && row < Maps::tile_side;
    if (inside) return tile->find(column, row);
  }
  return std::nullopt;
}

// Cell by cell, to the last bit.
bool are_same(const Maps& a, const Maps& b) {
  if (a.rocks() != b.rocks() || a.touched_cells() != b.touched_cells()) return false;
  for (const Maps::Tile* tile : a.tiles()) {
    for (std::int32_t k = 0; k < Maps::tile_side * Maps::tile_side; ++k) {
      const std::int32_t column = k % Maps::tile_side, row = k / Maps::tile_side;
      const auto mine = tile->find(column, row);
      if (!mine) continue;
      const auto theirs = tally_at(b, {tile->first().column + column, tile->first().row + row});
      if (!theirs || !(*mine == *theirs)) return false;
    }
  }
  return true;
}

// The precision of the numbers of a visit.
void expect_single(double found, double expected) { EXPECT_NEAR(found, expected, 1e-7 * expected); }

TEST(Maps, CountARockOnceInACell) {
  // There, back, and there again.
  const Maps maps = maps_of({rock_of({flight({0.5, 0.5, 1}, {2, 0, 0}, 1), flight({2.5, 0.5, 1}, {-1, 0, 0}, 2),
                                      flight({0.5, 0.5, 1}, {3, 0, 0}, 1)})});
  EXPECT_EQ(maps.rocks(), 1U);
  EXPECT_EQ(maps.touched_cells(), 4U);
  for (std::int32_t column = 0; column < 4; ++column) {
    ASSERT_TRUE(tally_at(maps, {column, 0}));
    EXPECT_EQ(tally_at(maps, {column, 0})->passages(), 1U);
  }
}

TEST(Maps, HaveTheMaximumEnergiesOfTheStay) {
  const Vec3 spin(0, 3, 4);
  const Seen seen = rock_of({flight({0.5, 0.5, 9}, {1, 0, 0}, 1.2, spin)});
  const Maps maps = maps_of({seen});
  // It leaves the first cell after half a second, with a vertical velocity of 5 m/s, and ends with 12 m/s.
  const MapTally first = *tally_at(maps, {0, 0});
  const MapTally second = *tally_at(maps, {1, 0});
  const double rotational = 0.5 * seen.record.body.inertia * 25;
  expect_single(first.maximum(velocity), std::sqrt(1 + 25.0));
  expect_single(first.maximum(energy_translational), 500 * 26);
  expect_single(first.maximum(energy_total), 500 * 26 + rotational);
  expect_single(second.maximum(energy_total), 500 * (1 + 144) + rotational);
  EXPECT_NEAR(second.mean(energy_total), 500 * (1 + 144) + rotational, 0.01);
}

TEST(Maps, MeasureHeightAboveTheGroundBelow) {
  // A flight whose apex, 1.25 m above its start, is over the second cell.
  const Maps over_flat = maps_of({rock_of({flight({0.5, 0.5, 2}, {2, 0, 5}, 1)})});
  expect_single(tally_at(over_flat, {1, 0})->maximum(bounce_height), 3.25);
  expect_single(tally_at(over_flat, {0, 0})->maximum(bounce_height), 2 + 5 * 0.25 - 5 * 0.25 * 0.25);

  const Profile terrace = level_ground(1, 0.9);
  MapObserver observer(unit_grid, max_height_over(terrace, RockModel::lumped_mass));
  const auto part = observer.new_part();
  const Seen seen = rock_of({flight({0.5, 0.5, 2}, {2, 0, 0}, 0.5)});
  part->see(seen.record, seen.log);
  observer.commit(*part);
  expect_single(tally_at(observer.maps(), {0, 0})->maximum(bounce_height), 1);
  EXPECT_EQ(tally_at(observer.maps(), {1, 0})->maximum(bounce_height), 0);  // without ground below
}

TEST(Maps, HaveTheHeightOfTheLowestPointOfARockOnTheGround) {
  PathPiece leg = flight({0.5, 0.5, 0.7}, {1, 0, 0}, 1);
  leg.path.a = Vec3{};
  leg.on_ground = true;
  leg.ends = {leg.path.v, leg.path.v, leg.spin};
  EXPECT_EQ(tally_at(maps_of({rock_of({leg})}), {0, 0})->maximum(bounce_height), 0);
  const Maps sphere = maps_of({rock_of({leg})}, RockModel::rigid_sphere);
  expect_single(tally_at(sphere, {0, 0})->maximum(bounce_height), 0.7 - sphere_of_mass(1000, 2700).radius);
  expect_single(tally_at(sphere, {1, 0})->maximum(bounce_height), 0.7 - sphere_of_mass(1000, 2700).radius);
}

TEST(Maps, CountRocksThatStayAsDeposits) {
  const auto ended = [](EndReason reason) { return rock_of({flight({0.5, 0.5, 1}, {1, 0, 0}, 1)}, reason); };
  const Maps maps = maps_of({ended(EndReason::at_rest), ended(EndReason::stopped_by_barrier),
                             ended(EndReason::left_model), ended(EndReason::maximum_time), ended(EndReason::lost)});
  EXPECT_EQ(tally_at(maps, {1, 0})->deposits(), 2U);
  EXPECT_EQ(tally_at(maps, {1, 0})->passages(), 5U);
  EXPECT_EQ(tally_at(maps, {0, 0})->deposits(), 0U);
}

TEST(Maps, CountEveryImpact) {
  Seen seen = rock_of({flight({0.5, 0.5, 1}, {1, 0, 0}, 1)});
  seen.log.impact_places = {{0.6, 0.5, 0}, {0.7, 0.5, 0}, {1.5, 0.5, 0}};
  const Maps maps = maps_of({seen, seen});
  EXPECT_EQ(tally_at(maps, {0, 0})->impacts(), 4U);
  EXPECT_EQ(tally_at(maps, {1, 0})->impacts(), 2U);
}

/// Rocks that bounce about a few cells, on both sides of the grid's origin.
std::vector<Seen> random_rocks(Dice& dice, int count) {
  std::vector<Seen> rocks;
  for (int k = 0; k < count; ++k) {
    std::vector<PathPiece> pieces;
    Vec3 p(dice.between(-2, 2), dice.between(-2, 2), dice.between(0, 3));
    for (std::size_t n = 1 + dice.below(8); n-- > 0;) {
      Vec3 v = dice.in_cube(3) * dice.magnitude(0.1, 3);
      v.z() = std::abs(v.z());
      pieces.push_back(flight(p, v, dice.magnitude(0.05, 2), dice.in_cube(10)));
      p = pieces.back().path.at(pieces.back().duration);
      p.z() = std::abs(p.z());
    }
    const EndReason reason = dice.chance(0.7) ? EndReason::at_rest : EndReason::left_model;
    rocks.push_back(rock_of(std::move(pieces), reason, dice.magnitude(10, 1e5)));
    for (std::size_t n = dice.below(5); n-- > 0;) rocks.back().log.impact_places.push_back(dice.in_cube(4));
  }
  return rocks;
}

/// A reference that keeps every value of every rock.
struct Kept {
  std::array<std::vector<double>, map_quantity_count> values;
  std::uint64_t deposits = 0, impacts = 0;
};
using Place = std::pair<std::int32_t, std::int32_t>;

std::map<Place, Kept> keep_everything(const std::vector<Seen>& rocks) {
  std::map<Place, Kept> cells;
  for (const Seen& seen : rocks) {
    std::map<Place, std::array<double, map_quantity_count>> stays;
    const Rock& body = seen.record.body;
    for (const PathPiece& piece : seen.log.pieces) {
      walk(unit_grid, piece, [&](MapCell cell, double enter, double leave) {
        std::array<double, map_quantity_count>& greatest = stays[{cell.column, cell.row}];
        for (const double t : {enter, leave, std::clamp(piece.path.v.z() / 10, enter, leave)}) {
          const double speed = piece.path.velocity(t).norm();
          const double translational = 0.5 * body.mass * speed * speed;
          const double values[] = {translational + 0.5 * body.inertia * piece.spin.squared_norm(), translational, speed,
                                   piece.path.z(t)};
          for (std::size_t k = 0; k < map_quantity_count; ++k) greatest[k] = std::max(greatest[k], values[k]);
        }
      });
    }
    const auto place_of = [](const Vec3& p) {
      return Place(static_cast<std::int32_t>(std::floor(p.x())), static_cast<std::int32_t>(std::floor(p.y())));
    };
    for (const Vec3& impact : seen.log.impact_places) {
      (void)stays[place_of(impact)];
      ++cells[place_of(impact)].impacts;
    }
    (void)stays[place_of(seen.record.outcome.end.position)];
    if (seen.record.outcome.reason == EndReason::at_rest) {
      ++cells[place_of(seen.record.outcome.end.position)].deposits;
    }
    for (const auto& [place, greatest] : stays) {
      for (std::size_t k = 0; k < map_quantity_count; ++k) cells[place].values[k].push_back(greatest[k]);
    }
  }
  return cells;
}

// The maps of a glide are those of its steps one by one, whether or not a step crosses cell borders.
TEST(Maps, TreatAGlideLikeItsSteps) {
  Dice dice(5);
  std::vector<Seen> folded, unfolded;
  for (int k = 0; k < 200; ++k) {
    Seen seen = rock_of({flight({0.5, 0.5, 1}, {1, 0, 0}, 0.1)});
    Motion motion;
    motion.position = {dice.between(-2, 2), dice.between(-2, 2), 0};
    const double turn = dice.between(0, 6.3);
    const Vec3 down(std::cos(turn), std::sin(turn), 0), aside(-down.y(), down.x(), 0);
    const double stride = dice.magnitude(0.01, 2);
    GlideStep step{0, 0, 0, 0};
    for (std::size_t n = 1 + dice.below(200); n-- > 0;) {
      step.vx = stride * dice.between(-0.5, 1) / 0.01;
      step.vy = stride * dice.between(-1, 1) / 0.01;
      step.x += 0.01 * step.vx;
      step.y += 0.01 * step.vy;
      seen.log.glide_steps.push_back(step);
    }
    seen.log(event::Glide{motion, motion, 0, 0.01, down, aside, FacetId{}});
    std::vector<PathPiece> pieces;
    seen.log.for_each_piece([&](const PathPiece& piece) { pieces.push_back(piece); });
    EXPECT_EQ(pieces.size(), 1 + seen.log.glide_steps.size());
    const PathPiece& last = pieces.back();
    seen.record.outcome.end.position = last.path.at(last.duration);
    folded.push_back(seen);
    unfolded.push_back(seen);
    unfolded.back().log.pieces = pieces;
  }
  const Maps together = maps_of(folded), one_by_one = maps_of(unfolded);
  ByteWriter a, b;
  together.save(a);
  one_by_one.save(b);
  EXPECT_GT(together.touched_cells(), 100U);
  EXPECT_EQ(a.bytes(), b.bytes());
}

TEST(Maps, AgreeWithAReferenceThatKeepsEveryValue) {
  Dice dice(23);
  const std::vector<Seen> rocks = random_rocks(dice, 2000);
  const Maps maps = maps_of(rocks);
  std::map<Place, Kept> cells = keep_everything(rocks);
  ASSERT_EQ(maps.touched_cells(), cells.size());
  std::size_t well_visited = 0;
  for (auto& [place, kept] : cells) {
    const auto tally = tally_at(maps, {place.first, place.second});
    ASSERT_TRUE(tally);
    EXPECT_EQ(tally->passages(), kept.values[0].size());
    EXPECT_EQ(tally->deposits(), kept.deposits);
    EXPECT_EQ(tally->impacts(), kept.impacts);
    well_visited += tally->passages() > 50;
    for (std::uint32_t k = 0; k < map_quantity_count; ++k) {
      const auto quantity = static_cast<MapQuantity>(k);
      std::vector<double>& values = kept.values[k];
      std::sort(values.begin(), values.end());
      double sum = 0;
      for (const double value : values) sum += value;
      const double mean = sum / static_cast<double>(values.size());
      EXPECT_NEAR(tally->maximum(quantity), values.back(), 1e-6 * values.back());
      EXPECT_NEAR(tally->mean(quantity), mean, 1e-6 * mean + 1e-7);
      for (const double percent : {5.0, 50.0, 95.0, 99.0, 100.0}) {
        const auto [rank, fraction] = quantile_place(percent / 100, values.size());
        const double exact = fraction > 0 ? between(values[rank], values[rank + 1], fraction) : values[rank];
        const bool is_alone = values.size() == 1;
        EXPECT_NEAR(tally->percentile(quantity, percent), exact, is_alone ? 1e-6 * exact : 0.01 * exact + 0.001);
      }
    }
  }
  EXPECT_GT(well_visited, 10U);
}

TEST(Maps, DoNotDependOnHowTheRocksAreSplit) {
  Dice dice(29);
  const std::vector<Seen> rocks = random_rocks(dice, 500);
  const Maps whole = maps_of(rocks);
  for (int trial = 0; trial < 10; ++trial) {
    // Shards, each with several parts committed in any order, merged in any order.
    std::vector<std::unique_ptr<MapObserver>> shards;
    for (int k = 0; k < 3; ++k) {
      shards.push_back(std::make_unique<MapObserver>(unit_grid, over_flat_ground));
    }
    std::vector<std::pair<std::size_t, std::unique_ptr<ObserverPart>>> parts;
    for (std::size_t k = 0; k < 9; ++k) parts.emplace_back(k % 3, shards[k % 3]->new_part());
    for (const Seen& seen : rocks) parts[dice.below(parts.size())].second->see(seen.record, seen.log);
    while (!parts.empty()) {
      const std::size_t k = dice.below(parts.size());
      shards[parts[k].first]->commit(*parts[k].second);
      parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(k));
    }
    Maps merged(unit_grid);
    while (!shards.empty()) {
      const std::size_t k = dice.below(shards.size());
      merged.merge(shards[k]->maps());
      shards.erase(shards.begin() + static_cast<std::ptrdiff_t>(k));
    }
    EXPECT_TRUE(are_same(merged, whole));
    EXPECT_FALSE(are_same(merged, maps_of({rocks.begin(), rocks.end() - 1})));  // the comparison can fail
  }
}

TEST(Maps, OfEachSourceAddUpToThoseOfAllRocks) {
  Dice dice(37);
  std::vector<Seen> rocks = random_rocks(dice, 600);
  constexpr std::uint32_t sources = 4;
  // In long ranges, as seeders release them, and in any order.
  for (std::uint32_t k = 0; k < rocks.size(); ++k) {
    const auto any = static_cast<std::uint32_t>(dice.below(sources - 1));
    rocks[k].record.source = SourceId{k < 300 ? k / 150 : any};
  }
  MapObserver split(unit_grid, over_flat_ground, sources);
  for (std::size_t first = 0; first < rocks.size(); first += 100) {
    const auto part = split.new_part();
    for (std::size_t k = first; k < first + 100; ++k) part->see(rocks[k].record, rocks[k].log);
    split.commit(*part);
    EXPECT_EQ(split.maps().rocks(), first + 100);  // also asked for in between
  }
  EXPECT_TRUE(are_same(split.maps(), maps_of(rocks)));
  ASSERT_EQ(split.by_source().size(), sources);
  for (std::uint32_t source = 0; source < sources; ++source) {
    std::vector<Seen> own;
    for (const Seen& seen : rocks) {
      if (seen.record.source.index == source) own.push_back(seen);
    }
    EXPECT_TRUE(are_same(split.by_source()[source], maps_of(own))) << source;
  }
  EXPECT_EQ(split.by_source()[3].rocks(), 0U);
  EXPECT_FALSE(are_same(split.by_source()[0], split.by_source()[1]));  // the comparison can fail
}

TEST(Maps, HaveNoSourcesIfNotSplit) {
  MapObserver whole(unit_grid, over_flat_ground);
  const auto part = whole.new_part();
  Seen seen = rock_of({flight({0.5, 0.5, 1}, {1, 0, 0}, 1)});
  seen.record.source = SourceId{7};
  part->see(seen.record, seen.log);
  whole.commit(*part);
  EXPECT_TRUE(whole.by_source().empty());
  EXPECT_EQ(whole.maps().rocks(), 1U);
}

TEST(Maps, ExtendOverTheTouchedCells) {
  EXPECT_FALSE(Maps(unit_grid).extent());
  const Maps maps =
      maps_of({rock_of({flight({-40.5, 3.5, 9}, {1, 0, 0}, 1)}), rock_of({flight({70.5, -2.5, 9}, {0, 0, 0}, 1)})});
  const auto extent = maps.extent();
  ASSERT_TRUE(extent);
  EXPECT_EQ(extent->first, (MapCell{-41, -3}));
  EXPECT_EQ(extent->last, (MapCell{70, 3}));
}

// The figures of memory in maps.hpp.
TEST(Maps, TakeMemoryForTheTouchedCells) {
  Dice dice(31);
  std::vector<Seen> rocks;
  for (int k = 0; k < 1000; ++k) {
    const Vec3 v(dice.between(20, 25), dice.between(-1, 1), 5);
    rocks.push_back(rock_of({flight({0.5, dice.between(0, 50), 20}, v, 4)}));
  }
  const Maps maps = maps_of(rocks);
  const auto cells = static_cast<double>(maps.touched_cells());
  EXPECT_GT(cells, 3000);
  RecordProperty("cells", static_cast<int>(cells));
  RecordProperty("bytes_a_cell", static_cast<int>(static_cast<double>(maps.bytes()) / cells));
  EXPECT_LT(static_cast<double>(maps.bytes()) / cells, 700);
}

}  // namespace
}  // namespace talus::maps_test
