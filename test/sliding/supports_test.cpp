#include "talus/sliding/supports.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/dice.hpp"

namespace talus::supports_test {
namespace {

using testing_tools::Dice;

const Vec3 gravity(0, 0, -standard_gravity);

Supports supports_of(std::initializer_list<Vec3> normals) {
  Supports supports;
  for (const Vec3& n : normals) supports.add(n.normalized());
  return supports;
}

TEST(Supports, KeepsEqualNormalsOnce) {
  const Supports supports = supports_of({{0, 0, 1}, {1e-12, 0, 1}, {1, 0, 1}});
  EXPECT_EQ(supports.count(), 2);
}

TEST(FootingOn, NoSupportIsFreeFall) {
  const Footing footing = footing_on(gravity, Supports());
  EXPECT_EQ(footing.pull, gravity);
  EXPECT_EQ(footing.normal_acceleration, 0);
}

TEST(FootingOn, OnePlane) {
  const Vec3 n = Vec3(0.5, 0, 1).normalized();
  const Footing one = footing_on(gravity, supports_of({n})), plane = Footing::on_plane(gravity, n);
  EXPECT_LT((one.pull - plane.pull).norm(), 1e-14);
  EXPECT_NEAR(one.normal_acceleration, plane.normal_acceleration, 1e-14);
}

// A V-shaped valley that dips along y: the pull is gravity along the valley.
TEST(FootingOn, AValleyPullsAlongIt) {
  const Vec3 e = Vec3(0, 1, -0.3).normalized();
  const Vec3 left = e.cross(Vec3(-0.5, 0, 1)).cross(e).normalized(), right(-left.x(), left.y(), left.z());
  const Footing footing = footing_on(gravity, supports_of({left, right}));
  EXPECT_LT((footing.pull - gravity.dot(e) * e).norm(), 1e-12);
  const Vec3 carried = footing.pull - gravity;  // by both sides equally
  EXPECT_NEAR(footing.normal_acceleration, 2 * carried.norm() / (left + right).norm(), 1e-12);
}

TEST(FootingOn, APitHasNoPull) {
  const Footing footing = footing_on(gravity, supports_of({{1, 0, 1}, {-0.5, 0.8, 1}, {-0.5, -0.8, 1}}));
  EXPECT_LT(footing.pull.norm(), 1e-12);
  EXPECT_GT(footing.normal_acceleration, standard_gravity);
}

// A steep plane and a wall that the rock moves away from: only the plane carries it.
TEST(FootingOn, ASupportThatTheRockLeavesDoesNotCarry) {
  const Vec3 plane = Vec3(1, 0, 1).normalized();
  const Footing footing = footing_on(gravity, supports_of({plane, {1, 0, 0.2}}));
  EXPECT_GE(footing.pull.dot(Vec3(1, 0, 0.2).normalized()), -1e-9);
}

// The projection onto a convex cone: nearest to gravity, in the cone, and at right angles to the removed part.
TEST(FootingOn, IsTheProjectionOntoTheCone) {
  Dice dice(64);
  for (int i = 0; i < 20'000; ++i) {
    Supports supports;
    const std::size_t count = 1 + dice.below(4);
    for (std::size_t k = 0; k < count; ++k) {
      Vec3 n = dice.direction();
      n.z() = std::abs(n.z());
      supports.add(n);
    }
    const Footing footing = footing_on(gravity, supports);
    for (int k = 0; k < supports.count(); ++k) ASSERT_GE(footing.pull.dot(supports[k]), -1e-7);
    ASSERT_NEAR(footing.pull.dot(gravity - footing.pull), 0, 1e-5);
    ASSERT_GE(footing.normal_acceleration, 0);
  }
}

TEST(CaughtBetween, AppliesInAValleyNotOnARidge) {
  const Vec3 left = Vec3(1, 0, 1).normalized(), right = Vec3(-1, 0, 1).normalized();
  ASSERT_TRUE(is_caught_between(gravity, left, right, {0, 1, 0}, 0.1));
  const Valley valley = valley_between(gravity, left, right);
  EXPECT_NEAR(std::abs(valley.direction.y()), 1, 1e-14);
  EXPECT_LT(valley.footing.pull.norm(), 1e-12);
  // A rock that leaves the first side faster than the cutoff is not caught.
  const Vec3 up_the_second = right.cross(unit_y);
  const Vec3 away = up_the_second.dot(left) > 0 ? up_the_second : -up_the_second;
  EXPECT_FALSE(is_caught_between(gravity, left, right, 0.2 * away, 0.1));
  EXPECT_TRUE(is_caught_between(gravity, left, right, 0.05 * away, 0.1));
}

// The forces of both sides and gravity balance across the valley.
TEST(CaughtBetween, SharesTheLoadBetweenTheSides) {
  const Vec3 steep = Vec3(2, 0, 1).normalized(), gentle = Vec3(-1, 0, 3).normalized();
  ASSERT_TRUE(is_caught_between(gravity, steep, gentle, {0, 0, 0}, 0.1));
  const Valley valley = valley_between(gravity, steep, gentle);
  const double on_first = valley.first_share * valley.footing.normal_acceleration;
  const double on_second = valley.footing.normal_acceleration - on_first;
  EXPECT_LT((on_first * steep + on_second * gentle + gravity - valley.footing.pull).norm(), 1e-12);
}

TEST(CaughtBetween, DoesNotApplyIfOneSideLeadsAway) {
  // Both sides fall in the same direction: the rock slides off the first over the second.
  EXPECT_FALSE(is_caught_between(gravity, Vec3(1, 0, 2).normalized(), Vec3(1, 0, 1).normalized(), {0, 0, 0}, 0.1));
  EXPECT_FALSE(is_caught_between(gravity, unit_z, unit_z, {0, 0, 0}, 0.1));
}

}  // namespace
}  // namespace talus::supports_test
