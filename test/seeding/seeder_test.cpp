#include "talus/seeding/seeder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "support/meshes.hpp"
#include "talus/seeding/lift.hpp"
#include "talus/terrain/profile.hpp"

namespace talus::seeder_test {
namespace {

using namespace testing_tools;

Seeder point_seeder() {
  Seeder seeder;
  seeder.where = Vec3(1, 2, 3);
  seeder.size = Sampler(1000.0);
  seeder.density = Sampler(2700.0);
  return seeder;
}

Release release_of(const Seeder& seeder, std::uint64_t rock = 0) {
  return release_at(seeder, std::get<Vec3>(*seeder.where), *seeder.direction, Draws(SamplingPlan{}, rock));
}

// ---- where ----

// The sources computed in advance are those of the rocks at release.
TEST(SourceRuns, AreTheSourcesOfTheRocks) {
  Seeder along_lines = point_seeder(), in_cells = point_seeder(), at_point = point_seeder();
  ReleaseLines lines;
  const std::vector<Vec3> left{{0, 0, 0}, {0, 30, 0}}, middle{{5, 0, 0}, {5, 0.01, 0}}, right{{10, 0, 0}, {10, 70, 0}};
  lines.add(left, SourceId{3});
  lines.add(middle, SourceId{0});
  lines.add(right, SourceId{1});
  lines.add(left, SourceId{3});
  along_lines.where = lines;
  ReleaseCells cells;
  for (std::uint32_t k = 0; k < 17; ++k) cells.cells.push_back(k);
  cells.columns = 20;
  cells.sources = {{0, SourceId{2}}, {5, SourceId{0}}, {16, SourceId{2}}};
  in_cells.where = cells;
  at_point.source = SourceId{4};
  for (Seeder seeder : {along_lines, in_cells, at_point}) {
    for (const std::uint64_t rocks : {1, 2, 10, 1000}) {
      for (const SamplingMethod method : {SamplingMethod::monte_carlo, SamplingMethod::latin_hypercube}) {
        seeder.first_rock = 40;
        seeder.rocks = rocks;
        seeder.step = even_step(count_places(seeder));
        const ReleaseOrder order = release_order(seeder, 9);
        const std::vector<SourceRun> runs = source_runs(seeder, 9);
        ASSERT_EQ(runs.front().first_place, 0U);
        for (std::size_t k = 1; k < runs.size(); ++k) {
          EXPECT_GT(runs[k].first_place, runs[k - 1].first_place);
          EXPECT_LT(runs[k].first_place, order.places);
          EXPECT_NE(runs[k].source, runs[k - 1].source);
        }
        for (std::uint64_t rock = 40; rock < 40 + rocks; ++rock) {
          const auto after = std::ranges::upper_bound(runs, order.place_of(rock), {}, &SourceRun::first_place);
          ASSERT_EQ(place_of(seeder, {9, method, 40, rocks}, rock).source, std::prev(after)->source) << rock;
        }
      }
    }
  }
}

TEST(PlaceOf, SeveralLinesShareTheRocksByLength) {
  Seeder seeder = point_seeder();
  ReleaseLines lines;
  const std::vector<Vec3> left{{0, 0, 0}, {0, 30, 0}}, right{{10, 0, 0}, {10, 70, 0}};
  lines.add(left, SourceId{0});
  lines.add(right, SourceId{1});
  seeder.where = lines;
  seeder.rocks = 1000;
  seeder.step = even_step(count_places(seeder));
  ASSERT_EQ(source_runs(seeder, 1).size(), 2U);
  for (const SamplingMethod method : {SamplingMethod::monte_carlo, SamplingMethod::latin_hypercube}) {
    std::array<int, 10> tenths{};
    for (std::uint64_t rock = 0; rock < 1000; ++rock) {
      const Vec3 point = place_of(seeder, {1, method, 0, 1000}, rock).point;
      ++tenths[static_cast<std::size_t>((point.y() + (point.x() == 0 ? 0 : 30)) / 10)];
    }
    for (const int count : tenths) EXPECT_NEAR(count, 100, 1);
  }
}

TEST(PlaceOf, APointIsThePoint) {
  Seeder seeder = point_seeder();
  seeder.source = SourceId{4};
  for (const std::uint64_t rock : {0, 1, 2}) {
    const ReleasePlace place = place_of(seeder, SamplingPlan{}, rock);
    EXPECT_EQ(place.point, Vec3(1, 2, 3));
    EXPECT_EQ(place.source, SourceId{4});
  }
}

// ---- how large ----

TEST(ReleaseAt, SizesAreMassVolumeOrDiameter) {
  Seeder seeder = point_seeder();
  EXPECT_DOUBLE_EQ(release_of(seeder).rock.mass, 1000);
  EXPECT_NEAR(release_of(seeder).rock.radius, std::cbrt(3000 / (4 * std::numbers::pi * 2700)), 1e-15);

  seeder.size_of = SizeOf::volume;
  seeder.size = Sampler(2.0);
  EXPECT_DOUBLE_EQ(release_of(seeder).rock.mass, 5400);

  seeder.size_of = SizeOf::diameter;
  const Rock ball = release_of(seeder).rock;
  EXPECT_DOUBLE_EQ(ball.radius, 1);
  EXPECT_NEAR(ball.mass, 2700 * 4.0 / 3 * std::numbers::pi, 1e-9);
  EXPECT_NEAR(ball.inertia, 0.4 * ball.mass, 1e-9);
}

TEST(ReleaseAt, EveryRockHasItsOwnSizeAndSpeed) {
  Seeder seeder = point_seeder();
  seeder.size = Sampler(Distribution{1000, DistributionKind::uniform, {}, 500, 500}, Bounds{});
  seeder.horizontal = Sampler(Distribution{2, DistributionKind::uniform, {}, 1, 1}, Bounds{});
  double mass_sum = 0, speed_sum = 0, product_sum = 0;
  constexpr int rocks = 20'000;
  for (std::uint64_t rock = 0; rock < rocks; ++rock) {
    const Release release = release_of(seeder, rock);
    const double mass = release.rock.mass - 1000, speed = release.motion.velocity.x() - 2;
    ASSERT_LE(std::abs(mass), 500);
    ASSERT_LE(std::abs(speed), 1);
    mass_sum += mass;
    speed_sum += speed;
    product_sum += mass * speed;
  }
  // Five standard errors; a uniform number on [-h, h] has the standard deviation h / sqrt(3).
  const double error = 5 / std::sqrt(3.0 * rocks);
  EXPECT_LT(std::abs(mass_sum / rocks), 500 * error);
  EXPECT_LT(std::abs(speed_sum / rocks), 1 * error);
  EXPECT_LT(std::abs(product_sum / rocks), 500 * 5 / (3 * std::sqrt(1.0 * rocks)));  // they are independent
}

// ---- how fast ----

TEST(ReleaseAt, HorizontalAndVerticalSpeedsFollowTheHeadingOnPlan) {
  Seeder seeder = point_seeder();
  seeder.direction = Vec3(3, 4, 12) / 13;
  seeder.horizontal = Sampler(5.0);
  seeder.vertical = Sampler(-2.0);
  EXPECT_LT((release_of(seeder).motion.velocity - Vec3(3, 4, -2)).norm(), 1e-14);
}

TEST(ReleaseAt, SpeedFollowsTheDirectionInSpace) {
  Seeder seeder = point_seeder();
  seeder.direction = Vec3(3, 4, 12) / 13;
  seeder.speed = Sampler(26.0);
  EXPECT_LT((release_of(seeder).motion.velocity - Vec3(6, 8, 24)).norm(), 1e-13);
}

TEST(ReleaseAt, PositiveSpinRollsForwards) {
  Seeder seeder = point_seeder();
  seeder.direction = Vec3(0, 1, 0);
  seeder.spin = Sampler(3.0);
  const Motion motion = release_of(seeder).motion;
  EXPECT_NEAR(motion.spin.norm(), 3, 1e-15);
  // The top of the rock moves forwards.
  EXPECT_GT(motion.spin.cross(unit_z).dot(*seeder.direction), 2.9);
}

TEST(ReleaseAt, ADropStraightDownHasAHeading) {
  Seeder seeder = point_seeder();
  seeder.direction = -unit_z;
  seeder.speed = Sampler(4.0);
  seeder.spin = Sampler(1.0);
  const Motion motion = release_of(seeder).motion;
  EXPECT_EQ(motion.velocity, Vec3(0, 0, -4));
  EXPECT_TRUE(motion.spin.is_finite());
  EXPECT_NEAR(motion.spin.norm(), 1, 1e-15);
}

// ---- lifting ----

TEST(Lifted, LeavesARockThatIsClearOfTheGround) {
  const Profile flat(std::vector<Vec2>{{0, 0}, {10, 0}});
  EXPECT_EQ(clear_place(flat, {5, 0, 0.1}, 0).fit, Fit::as_given);
  EXPECT_EQ(clear_place(flat, {5, 0, 1.1}, 1).fit, Fit::as_given);
}

TEST(Lifted, PlacesAPointOnTheGroundAndASphereItsRadiusAboveIt) {
  const Profile flat(std::vector<Vec2>{{0, 0}, {10, 0}});
  EXPECT_NEAR(clear_place(flat, {5, 0, -3}, 0).z, 0, 1e-12);
  EXPECT_NEAR(clear_place(flat, {5, 0, -3}, 1).z, 1, 1e-8);
  EXPECT_NEAR(clear_place(flat, {5, 0, 0.25}, 1).z, 1, 1e-8);
}

TEST(Lifted, ASphereFitsOnEverySlope) {
  Dice dice(61);
  for (int ground = 0; ground < 20; ++ground) {
    const TriangleMesh mesh = random_slope(dice, 20, 30, dice.between(0, 1.5), dice.magnitude(0.01, 2)).mesh();
    for (int k = 0; k < 50; ++k) {
      const double x = dice.between(5, 25), y = dice.between(5, 25), radius = dice.magnitude(0.05, 1.5);
      const Vec3 place(x, y, *mesh.elevation(x, y) + dice.between(-2, 1));
      const Vec3 centre(x, y, clear_place(mesh, place, radius).z);
      ASSERT_GE(centre.z(), *mesh.elevation(x, y));
      mesh.supports(centre, radius, 0,
                    [&](const Vec3&, const Vec3&, double distance, FacetId) { ASSERT_GE(distance, radius - 1e-6); });
    }
  }
}

}  // namespace
}  // namespace talus::seeder_test
