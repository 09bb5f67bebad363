// Places of release and their rocks.

#include "talus/lines/release_spots.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/simulated_paths.hpp"

namespace talus {
namespace {

using testing_tools::SimulatedRun;

constexpr const char* release_slope = R"([terrain]
section = [[0, 0], [30, -30], [80, -35]]
width_m = 60

[[material]]
name = "Rock"
friction_angle_deg = 33

[[seeder]]
name = "Point"
position = [2, 30, 5]
rocks = 7
mass_kg = 900

[[seeder]]
name = "Area"
type = "polygon"
polygon = [[3, 20], [9, 20], [9, 26], [3, 26]]
cell_m = 2
rocks = 31
mass_kg = 900

[[seeder]]
name = "Line"
type = "line"
points = [[1, 10], [1, 50]]
height_above_m = 1
rocks = 12
mass_kg = 900
)";

TEST(ReleaseSpots, HaveTheirRocksOfOneSource) {
  const SimulatedRun run(release_slope);
  const ReleaseSpots spots(run.model);
  EXPECT_EQ(spots.list().size(), 1u + 9u + 1u);
  std::vector<std::uint64_t> rocks(spots.list().size());
  for (const RockRecord& record : run.records) ++rocks[spots.of_rock(record.rock)];
  for (std::size_t k = 0; k < rocks.size(); ++k) {
    EXPECT_EQ(rocks[k], spots.list()[k].rocks);
    EXPECT_GT(rocks[k], 0u);
  }
  for (const RockRecord& record : run.records) {
    const ReleaseSpot& spot = spots.list()[spots.of_rock(record.rock)];
    EXPECT_EQ(spot.seeder.index, record.seeder.index);
    EXPECT_EQ(spot.source.index, record.source.index);
    if (spot.size.x() == 0) continue;
    const Vec2 away = (record.outcome.start.position - spot.place).xy();
    EXPECT_LE(std::abs(away.x()), spot.size.x() / 2 + 1e-9);
    EXPECT_LE(std::abs(away.y()), spot.size.y() / 2 + 1e-9);
  }
}

TEST(StoredSources, CountTheStoredRocksOfEachPlace) {
  const SimulatedRun run(release_slope);
  const std::vector<std::uint64_t> rocks{0, 3, 6, 7, 16, 37, 38, 49};
  const StoredSources sources(run.model, rocks);
  EXPECT_EQ(sources.stored.front(), 3u);
  EXPECT_EQ(sources.stored[sources.spots.of_rock(7)], 2u) << "rock 16 is of the same of nine cells";
  EXPECT_EQ(sources.stored[sources.spots.of_rock(37)], 1u);
  EXPECT_EQ(sources.stored[10], 2u);
}

}  // namespace
}  // namespace talus
