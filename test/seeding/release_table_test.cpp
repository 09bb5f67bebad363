// Rocks from the rows of a table: which row, and what replaces the seeder's draws.

#include "talus/seeding/release_table.hpp"

#include <gtest/gtest.h>

#include <array>
#include <numbers>
#include <vector>

#include "support/dice.hpp"
#include "talus/seeding/seeder.hpp"

namespace talus::release_table_test {
namespace {

Seeder seeder_of(ReleaseTable table, std::uint64_t rocks) {
  Seeder seeder;
  seeder.rocks = rocks;
  table.order_by_place();
  seeder.where = std::move(table);
  seeder.size = Sampler(500.0);
  seeder.density = Sampler(2500.0);
  seeder.horizontal = Sampler(3.0);
  seeder.vertical = Sampler(-1.0);
  seeder.spin = Sampler(2.0);
  seeder.step = even_step(count_places(seeder));
  return seeder;
}

ReleaseTable some_rows(std::size_t count, std::size_t each_source = 1000) {
  ReleaseTable table;
  for (std::size_t k = 0; k < count; ++k)
    table.add(Vec3(static_cast<double>(k), 0, 0), {}, SourceId{static_cast<std::uint32_t>(k / each_source)},
              static_cast<std::uint32_t>(k + 1));
  return table;
}

/// Of the only rock of a row.
Release release_of_row(const Seeder& seeder, std::size_t row, const Vec3& direction = unit_x) {
  const ReleaseOrder order = release_order(seeder, 1);
  std::uint64_t rock = 0;
  while (std::get<ReleaseTable>(*seeder.where).row_at(order.place_of(rock)) != row) ++rock;
  const SamplingPlan plan{1, {}, seeder.first_rock, seeder.rocks};
  const ReleasePlace place = place_of(seeder, plan, rock);
  return release_at(seeder, place.point, direction, Draws(plan, rock), place.given);
}

// Rows in random order: the first of them in their turn are spread over all.
TEST(ReleaseTables, TakeTurnsAlongACurveOnPlan) {
  testing_tools::Dice dice(5);
  ReleaseTable table;
  for (std::uint32_t k = 0; k < 400; ++k) table.add(Vec3(dice.between(0, 10), dice.between(0, 10), 0), {}, {}, k + 1);
  table.order_by_place();
  double way = 0;
  for (std::size_t k = 0; k + 1 < 400; ++k)
    way += (table.place(table.row_at(k + 1)) - table.place(table.row_at(k))).norm();
  EXPECT_LT(way / 399, 0.7) << "neighbours are half a metre apart; random places are 5 m apart";
  const Seeder seeder = seeder_of(std::move(table), 400);
  std::array<int, 4> quarters{};
  for (std::uint64_t rock = 0; rock < 40; ++rock) {
    const Vec3 at = place_of(seeder, {1, {}, 0, 400}, rock).point;
    ++quarters[(at.x() < 5 ? 0 : 1) + (at.y() < 5 ? 0 : 2)];
  }
  for (const int count : quarters) EXPECT_NEAR(count, 10, 4);
}

TEST(ReleaseTables, ShareAnyNumberOfRocksEvenly) {
  for (const std::uint64_t rocks : {1U, 5U, 7U, 10U, 1000U}) {
    const Seeder seeder = seeder_of(some_rows(7), rocks);
    std::vector<std::uint64_t> counts(7);
    for (std::uint64_t k = 0; k < rocks; ++k)
      ++counts[static_cast<std::size_t>(place_of(seeder, {1, {}, 0, rocks}, k).point.x())];
    for (const std::uint64_t count : counts) EXPECT_TRUE(count == rocks / 7 || count == rocks / 7 + 1) << rocks;
  }
}

TEST(ReleaseTables, HaveTheSourcesOfTheirRows) {
  const Seeder seeder = seeder_of(some_rows(7, 3), 14);
  const auto runs = source_runs(seeder, 1);
  ASSERT_EQ(runs.size(), 3U);
  EXPECT_EQ(runs[1].first_place, 3U);
  EXPECT_EQ(runs[2].first_place, 6U);
  const ReleaseOrder order = release_order(seeder, 1);
  for (std::uint64_t rock = 0; rock < 14; ++rock) {
    const ReleasePlace place = place_of(seeder, {1, {}, 0, 14}, rock);
    EXPECT_EQ(place.source.index, order.place_of(rock) / 3);
    EXPECT_EQ(place.source.index, static_cast<std::uint32_t>(place.point.x()) / 3);
  }
}

TEST(ReleaseTables, KeepWhatEachRowGives) {
  ReleaseTable table;
  ReleaseRow first, third;
  first.mass = 70;
  third.velocity = {1, 2, 3};
  table.add(Vec3{}, first, {}, 1);
  table.add(Vec3{}, {}, {}, 2);
  table.add(Vec3{}, third, {}, 3);
  EXPECT_EQ(table.given(0).mass, 70);
  EXPECT_FALSE(ReleaseRow::has(table.given(0).velocity));
  EXPECT_FALSE(ReleaseRow::has(table.given(1).mass));
  EXPECT_FALSE(ReleaseRow::has(table.given(2).mass));
  EXPECT_EQ(table.given(2).velocity, Vec3(1, 2, 3));
  EXPECT_FALSE(ReleaseRow::has(table.given(2).density));
}

TEST(ReleaseTables, ReplaceTheSettingsOfTheSeeder) {
  ReleaseTable table;
  ReleaseRow row;
  row.mass = 70;
  row.density = 2800;
  row.velocity = {0, 4, -1};
  row.spin_vector = {1, 2, 3};
  table.add(Vec3(5, 6, 7), row, {}, 1);
  const Release release = release_of_row(seeder_of(std::move(table), 1), 0);
  EXPECT_EQ(release.motion.position, Vec3(5, 6, 7));
  EXPECT_EQ(release.rock.mass, 70);
  EXPECT_DOUBLE_EQ(release.rock.radius, sphere_of_mass(70, 2800).radius);
  EXPECT_EQ(release.motion.velocity, Vec3(0, 4, -1));
  EXPECT_EQ(release.motion.spin, Vec3(1, 2, 3));
}

TEST(ReleaseTables, LeaveTheRestToTheSeeder) {
  const Release release = release_of_row(seeder_of(some_rows(1), 1), 0, unit_y);
  EXPECT_EQ(release.rock.mass, 500);
  EXPECT_DOUBLE_EQ(release.rock.radius, sphere_of_mass(500, 2500).radius);
  EXPECT_EQ(release.motion.velocity, Vec3(0, 3, -1));
  EXPECT_EQ(release.motion.spin, Vec3(-2, 0, 0));
}

TEST(ReleaseTables, GiveVolumesAndPartsOfVelocities) {
  ReleaseTable table;
  ReleaseRow volume, horizontal, speed, roll;
  volume.volume = 2;
  horizontal.horizontal = 8;
  speed.speed = 10;
  roll.velocity = {0, -5, 0};
  roll.spin = 4;
  for (const ReleaseRow& row : {volume, horizontal, speed, roll}) table.add(Vec3{}, row, {}, 1);
  const Seeder seeder = seeder_of(std::move(table), 4);
  const Vec3 down = Vec3(0.6, 0, -0.8);
  EXPECT_EQ(release_of_row(seeder, 0).rock.mass, 5000);
  EXPECT_EQ(release_of_row(seeder, 1, down).motion.velocity, Vec3(8, 0, -1));
  EXPECT_EQ(release_of_row(seeder, 2, down).motion.velocity, 10 * down);
  // It rolls the way it moves, towards -y: about +x.
  EXPECT_EQ(release_of_row(seeder, 3, down).motion.spin, Vec3(4, 0, 0));
}

// A speed of the seeder gives way to parts of a velocity in the row.
TEST(ReleaseTables, PrecedeTheSpeedOfTheSeeder) {
  ReleaseTable table;
  ReleaseRow vertical;
  vertical.vertical = 6;
  table.add(Vec3{}, vertical, {}, 1);
  table.add(Vec3{}, {}, {}, 2);
  Seeder seeder = seeder_of(std::move(table), 2);
  seeder.speed = Sampler(20.0);
  seeder.horizontal = Sampler(0.0);
  EXPECT_EQ(release_of_row(seeder, 0).motion.velocity, Vec3(0, 0, 6));
  EXPECT_EQ(release_of_row(seeder, 1).motion.velocity, Vec3(20, 0, 0));
}

}  // namespace
}  // namespace talus::release_table_test
