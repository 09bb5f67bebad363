// The extent of rocks with a shape: at barriers and collectors, and their bounce heights.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "support/dice.hpp"
#include "support/meshes.hpp"
#include "support/scenes.hpp"
#include "talus/rocks/heights.hpp"
#include "talus/terrain/triangle_mesh.hpp"

namespace talus::bodies_at_barriers_test {
namespace {

using namespace testing_tools;

constexpr double g = 9.81;

/// Of 1 m3, with these edges.
RockShape box(const Vec3& edges) {
  RockShape shape;
  for (const double x : {-0.5, 0.5}) {
    for (const double y : {-0.5, 0.5}) {
      for (const double z : {-0.5, 0.5}) shape.corners.push_back(edges.times({x, y, z}));
    }
  }
  const Vec3 s = edges.times(edges);
  shape.gyration = Vec3{s[1] + s[2], s[0] + s[2], s[0] + s[1]} / 12;
  shape.reach = 0.5 * edges.norm();
  return shape;
}

const RockShape slab = box({2, 2, 0.25}), beam = box({4, 0.5, 0.5});

TriangleMesh level() {
  const double far = 400;
  return Shape{{{-far, -far, 0}, {far, -far, 0}, {far, far, 0}, {-far, far, 0}}, {{0, 1, 2}, {0, 2, 3}}}.mesh();
}

Laws laws() {
  Laws laws;
  set_model(laws, RockModel::rigid_sphere);
  laws.gravity = {0, 0, -g};
  laws.stopped_velocity = 0.01;
  return laws;
}

std::vector<Barrier> fence(double x, double height, bool is_collector = false) {
  Barrier barrier;
  barrier.capacity = std::numeric_limits<double>::infinity();
  barrier.is_collector = is_collector;
  barrier.set_panels(panels_over(std::vector<Vec3>{{x, 100, 0}, {x, 10, 0}, {x, -100, 0}}, height, 0));
  return {barrier};
}

/// 1 m3, its centre at (0, 0, height).
Release thrown(const RockShape& shape, double height, const Vec3& velocity, const Orientation& orientation = {}) {
  Release release;
  release.rock = sphere_of_mass(2700, 2700);
  release.shape = &shape;
  release.orientation = orientation;
  release.motion.position = {0, 0, height};
  release.motion.velocity = velocity;
  return release;
}

Followed thrown_at(const std::vector<Barrier>& barriers, const Release& release, const Laws& with = laws()) {
  return follow(level(), ground_of({.rn = 0, .mu = 0.4}), with, release, barriers);
}

const Orientation upright = Orientation::of_turn({0, std::numbers::pi / 2, 0});

// Both have the same centre, 2 m above the ground at the fence.
TEST(BodiesAtBarriers, ABeamHitsUprightTheFenceThatItClearsLying) {
  const double speed = 40, fall = 0.5 * g * (5 / speed) * (5 / speed);
  const auto barriers = fence(5, 1.5);
  const Followed lying = thrown_at(barriers, thrown(beam, 2 + fall, {speed, 0, 0}));
  EXPECT_TRUE(lying.log.hits.empty());
  ASSERT_EQ(lying.log.passed_above.size(), 1U);
  const Passage& above = lying.log.passed_above[0];
  EXPECT_NEAR(above.lowest, 1.75, 1e-9);
  EXPECT_NEAR(top_over(above.lowest, above.half_height_of(99)), 2.25, 1e-9);
  EXPECT_NEAR(above.clearance, 0.25, 1e-6);
  const Followed standing = thrown_at(barriers, thrown(beam, 2 + fall, {speed, 0, 0}, upright));
  EXPECT_EQ(standing.outcome.reason, EndReason::stopped_by_barrier);
  ASSERT_EQ(standing.log.hits.size(), 1U);
  const Passage& hit = standing.log.hits[0];
  EXPECT_NEAR(hit.motion.position.x(), 4.75, 1e-5);
  EXPECT_NEAR(top_over(hit.lowest, hit.half_height_of(99)), hit.motion.position.z() + 2, 1e-6);
  EXPECT_LE(hit.height, 1.5 + 1e-6);
  EXPECT_NEAR(hit.normal.x(), -1, 1e-6);
}

// With its centre at the fence at 1 m, it clears one of 0.75 - 0.01 m, and touches one of 0.75 + 0.01 m with its face.
TEST(BodiesAtBarriers, ASlabClearsALowFenceOnlyIfItsLowestCornerDoes) {
  Laws floating = laws();
  floating.gravity = {0, 0, -1e-6};
  floating.max_time = 2;
  for (const double tilt : {0.0, 0.3, -0.3, 0.7}) {
    const Orientation tilted = Orientation::of_turn({0, tilt, 0});
    double lowest = 1e9;
    for (const Vec3& corner : slab.corners) lowest = std::min(lowest, 1.5 + tilted.to_world(corner).z());
    for (const double more : {-0.01, 0.01}) {
      const Followed path = thrown_at(fence(5, lowest + more), thrown(slab, 1.5, {5, 0, 0}, tilted), floating);
      EXPECT_EQ(path.log.hits.empty(), more < 0) << tilt;
      EXPECT_EQ(path.log.passed_above.empty(), more > 0) << tilt;
      if (more > 0 && !path.log.hits.empty()) {
        EXPECT_NEAR(path.log.hits[0].lowest, lowest, 1e-4) << tilt;
        EXPECT_NEAR(path.log.hits[0].height, lowest + more, 0.011) << tilt;
      }
    }
  }
}

// A beam that spins about the vertical: its end touches the fence when sin(angle) brings it there.
TEST(BodiesAtBarriers, ASpinningBeamTouchesWithItsEnd) {
  Laws floating = laws();
  floating.gravity = {0, 0, -1e-6};
  floating.max_time = 5;
  Release release = thrown(beam, 5, {1, 0, 0}, Orientation::of_turn({0, 0, std::numbers::pi / 2}));
  release.motion.spin = {0, 0, 0.5};
  const Followed path = thrown_at(fence(3, 10), release, floating);
  ASSERT_EQ(path.log.hits.size(), 1U);
  const double t = path.log.hits[0].motion.time, angle = std::numbers::pi / 2 + 0.5 * t;
  EXPECT_NEAR(t + 2 * std::abs(std::cos(angle)) + 0.25 * std::abs(std::sin(angle)), 3, 2e-6);
}

// It is as if nobody were there for a collector, whose heights are those of the body.
TEST(BodiesAtBarriers, ACollectorRecordsTheHeightsOfTheBody) {
  const double fall = 0.5 * g * 0.5 * 0.5;
  for (const Orientation& turned : {Orientation{}, upright}) {
    const Followed path = thrown_at(fence(5, 10, true), thrown(beam, 3 + fall, {10, 0, 0}, turned));
    ASSERT_GE(path.log.hits.size(), 1U);
    const Passage& hit = path.log.hits[0];
    const double half = turned == upright ? 2 : 0.25;
    EXPECT_NEAR(hit.motion.position.x(), 5, 1e-9);
    EXPECT_NEAR(hit.height, 3, 1e-9);
    EXPECT_NEAR(hit.lowest, 3 - half, 1e-9);
    EXPECT_NEAR(hit.half_height_of(99), half, 1e-9);
  }
}

// On one line, the collector counts the rock that the fence stops; and in touch with the ground both work as in flight.
TEST(BodiesAtBarriers, ACollectorOnTheFenceCountsWhatTheFenceStops) {
  auto barriers = fence(5, 3);
  barriers.push_back(fence(5, 10, true)[0]);
  for (const double height : {1.2, 0.125 + 1e-9}) {
    const Followed path = thrown_at(barriers, thrown(slab, height, {10, 0, 0}));
    EXPECT_EQ(path.outcome.reason, EndReason::stopped_by_barrier);
    ASSERT_EQ(path.log.hits.size(), 2U);
    EXPECT_EQ(path.log.hits[0].barrier.index, 1U);
    EXPECT_EQ(path.log.hits[1].barrier.index, 0U);
    EXPECT_NEAR(path.log.hits[1].motion.position.x(), 4, 0.02) << height;
    if (height < 1) {
      EXPECT_NEAR(path.log.hits[1].half_height_of(99), 0.125, 1e-3);
    }
  }
}

// Rebounds, break-through: each rock ends, and none is held by a fence without capacity.
TEST(BodiesAtBarriers, RandomBodiesGetOn) {
  Dice dice(17);
  for (int k = 0; k < 100; ++k) {
    auto barriers = fence(6, dice.between(0.5, 3));
    const bool breaks = k % 2 == 0;
    if (breaks) barriers[0].capacity = 1;
    if (!breaks) barriers[0].restitution = Restitution{dice.between(0, 0.5), 0.9};
    const Followed path = thrown_at(barriers, [&] {
      Release release = thrown(k % 3 == 0 ? beam : slab, dice.between(2.5, 4), {dice.between(2, 12), 0, 0},
                               Orientation::of_turn(dice.between(0, 3) * dice.direction()));
      release.motion.spin = dice.in_cube(4);
      return release;
    }());
    EXPECT_NE(path.outcome.reason, EndReason::maximum_steps) << k;
    EXPECT_NE(path.outcome.reason, EndReason::maximum_time) << k;
    EXPECT_LT(path.log.hits.size(), 30U) << k;
    if (breaks) {
      EXPECT_NE(path.outcome.reason, EndReason::stopped_by_barrier) << k;
    } else if (path.log.passed_above.empty()) {
      EXPECT_LT(path.outcome.end.position.x(), 6) << k;
    }
  }
}

// ---- bounce heights ----

TEST(BodiesBounce, AtRestOnAFaceByNothing) {
  const Followed path = thrown_at({}, thrown(slab, 0.125, Vec3{}));
  EXPECT_EQ(path.outcome.reason, EndReason::at_rest);
  EXPECT_NEAR(path.outcome.max_bounce, 0, 1e-6);
}

TEST(BodiesBounce, ByTheHeightOfTheLowestCorner) {
  EXPECT_NEAR(thrown_at({}, thrown(slab, 2, Vec3{})).outcome.max_bounce, 2 - 0.125, 1e-9);
  EXPECT_NEAR(thrown_at({}, thrown(beam, 3, Vec3{}, upright)).outcome.max_bounce, 1, 1e-9);
  const double rise = 6 * 6 / (2 * g);
  EXPECT_NEAR(thrown_at({}, thrown(slab, 1, {1, 0, 6})).outcome.max_bounce, 1 + rise - 0.125, 3e-3);
  // A beam that turns end over end: against looks a thousandth of a radian apart.
  Release release = thrown(beam, 3, {1, 0, 4});
  release.motion.spin = {0, 3, 0};
  double highest = 0;
  for (double t = 0; t < 1; t += 0.0003) {
    const double half = 2 * std::abs(std::sin(3 * t)) + 0.25 * std::abs(std::cos(3 * t));
    highest = std::max(highest, 3 + 4 * t - 0.5 * g * t * t - half);
  }
  EXPECT_NEAR(thrown_at({}, release).outcome.max_bounce, highest, 0.01 * beam.reach + 3e-3);
}

}  // namespace
}  // namespace talus::bodies_at_barriers_test
