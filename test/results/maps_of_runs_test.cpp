// The maximum over all cells of a map equals the run's maximum for the rock, whatever the cells.

#include <gtest/gtest.h>

#include <algorithm>

#include "support/meshes.hpp"
#include "support/scenes.hpp"
#include "talus/results/map_observer.hpp"
#include "talus/terrain/raster_surface.hpp"

namespace talus::maps_of_runs_test {
namespace {

using namespace testing_tools;
using enum MapQuantity;

struct Greatest {
  double energy = 0, height = 0;
};

Greatest greatest_of(const Maps& maps) {
  Greatest greatest;
  for (const Maps::Tile* tile : maps.tiles()) {
    for (std::int32_t k = 0; k < Maps::tile_side * Maps::tile_side; ++k) {
      const auto tally = tile->find(k % Maps::tile_side, k / Maps::tile_side);
      if (!tally) continue;
      greatest.energy = std::max(greatest.energy, tally->maximum(energy_total));
      greatest.height = std::max(greatest.height, tally->maximum(bounce_height));
    }
  }
  return greatest;
}

RockRecord record_of(const Release& release, const RockOutcome& outcome) {
  RockRecord record;
  record.body = release.rock;
  record.outcome = outcome;
  return record;
}

TEST(MapsOfRuns, HaveTheMaximumHeightAndEnergyOfTheRun) {
  Dice dice(51);
  for (int trial = 0; trial < 300; ++trial) {
    RasterGrid grid{.columns = 41, .rows = 41};
    const double grade = dice.between(0.3, 1), relief = dice.magnitude(0.05, 2);
    for (int k = 0; k < 41 * 41; ++k) grid.z.push_back(static_cast<float>(-grade * (k % 41) + dice.between(0, relief)));
    const RasterSurface surface(grid);
    Laws laws;
    set_model(laws, trial % 2 == 0 ? RockModel::lumped_mass : RockModel::rigid_sphere);
    laws.timestep = dice.magnitude(0.01, 0.2);
    Release release;
    release.rock = sphere_of_diameter(dice.between(0.3, 1.5), 2700);
    release.motion.position = {dice.between(3, 20), dice.between(10, 30), 4};
    release.motion.velocity = dice.in_cube(6);
    release.motion.spin = dice.in_cube(6);
    RockLog log(false, true);
    const Ground ground = ground_of({.rn = dice.between(0, 0.5), .phi = dice.between(0.1, 0.7)});
    const RockOutcome outcome =
        follow_rock(Scene<RasterSurface>{surface, ground, {}, laws}, release, Draws(SamplingPlan{}, 0), log);

    MapObserver observer(MapGrid({dice.between(-1, 0), 0}, dice.magnitude(0.2, 30), {}),
                         max_height_over(surface, laws.model));
    const auto part = observer.new_part();
    part->see(record_of(release, outcome), log);
    observer.commit(*part);
    const Greatest greatest = greatest_of(observer.maps());
    // Maps keep seven digits.
    ASSERT_NEAR(greatest.height, outcome.max_bounce, 1e-7 * outcome.max_bounce) << trial;
    ASSERT_NEAR(greatest.energy, outcome.max_kinetic_energy, 1e-7 * outcome.max_kinetic_energy) << trial;
  }
}

std::optional<MapTally> tally_at(const Maps& maps, MapCell cell) {
  for (const Maps::Tile* tile : maps.tiles()) {
    const std::int32_t column = cell.column - tile->first().column, row = cell.row - tile->first().row;
    const bool inside = column >= 0 && row >= 0 && column < Maps::tile_side && row < Maps::tile_side;
    if (inside) return tile->find(column, row);
  }
  return std::nullopt;
}

// On the ground at a node of the grid, in any direction: starts with flights and impacts of no duration.
TEST(MapsOfRuns, CountARockThatStartsOnACornerInTheCellThatItEnters) {
  RasterGrid grid{.columns = 41, .rows = 41};
  grid.z.assign(41 * 41, 0);
  const RasterSurface surface(grid);
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      for (const double z : {0.0, 1.0}) {
        Laws laws;
        laws.impact = PlainImpact{};
        Release release;
        release.rock = sphere_of_mass(1000, 2700);
        release.motion.position = {20, 20, z};
        release.motion.velocity = {0.5 * x, 0.4 * y, 0};
        RockLog log(false, true);
        const Ground ground = ground_of({.rn = 0, .rt = 1, .phi = 0.1});
        const RockOutcome outcome =
            follow_rock(Scene<RasterSurface>{surface, ground, {}, laws}, release, Draws(SamplingPlan{}, 0), log);
        MapObserver observer(MapGrid({0, 0}, 1, {}), max_height_over(surface, laws.model));
        const auto part = observer.new_part();
        part->see(record_of(release, outcome), log);
        observer.commit(*part);
        const MapCell into{x > 0 ? 20 : 19, y > 0 ? 20 : 19};
        ASSERT_EQ(observer.maps().touched_cells(), 1U) << x << ' ' << y << ' ' << z;
        const auto tally = tally_at(observer.maps(), into);
        ASSERT_TRUE(tally);
        EXPECT_EQ(tally->impacts(), 1U);
        EXPECT_EQ(tally->deposits(), 1U);
        EXPECT_NEAR(tally->maximum(velocity), std::sqrt(0.25 + 0.16 + 2 * standard_gravity * z), 1e-6);
      }
    }
  }
}

TEST(MapsOfRuns, CountARockThatStaysOnACornerInTheCellThatContainsIt) {
  RasterGrid grid{.columns = 41, .rows = 41};
  grid.z.assign(41 * 41, 0);
  const RasterSurface surface(grid);
  Release release;
  release.motion.position = {20, 20, 0};
  RockOutcome outcome;
  outcome.end = release.motion;
  MapObserver observer(MapGrid({0, 0}, 1, {}), max_height_over(surface, RockModel::lumped_mass));
  const auto part = observer.new_part();
  part->see(record_of(release, outcome), RockLog(false, true));
  observer.commit(*part);
  ASSERT_EQ(observer.maps().touched_cells(), 1U);
  EXPECT_TRUE(tally_at(observer.maps(), {20, 20}));
}

}  // namespace
}  // namespace talus::maps_of_runs_test
