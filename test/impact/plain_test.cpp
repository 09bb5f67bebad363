#include "talus/impact/plain.hpp"

#include <gtest/gtest.h>

#include "support/dice.hpp"

namespace talus::plain_test {
namespace {

using namespace testing_tools;

TEST(PlainImpact, ScalesEachComponent) {
  const Rebound after = plain_rebound({3, -4, -5}, {1, 2, 3}, unit_z, {0.4, 0.5});
  EXPECT_LT((after.velocity - Vec3(1.5, -2, 2)).norm(), 1e-15);
  EXPECT_EQ(after.spin, Vec3(1, 2, 3));
}

TEST(PlainImpact, RandomImpactsObeyTheLaw) {
  Dice dice(3);
  for (int i = 0; i < 100'000; ++i) {
    const Vec3 n = dice.direction(), w = dice.in_cube(10);
    Vec3 v = dice.direction();
    v *= dice.magnitude(1e-6, 100);
    if (v.dot(n) > 0) v = -v;
    const Restitution e{dice.unit(), dice.unit()};
    const Rebound after = plain_rebound(v, w, n, e);
    ASSERT_LE(after.velocity.norm(), v.norm() * (1 + 1e-14));
    ASSERT_NEAR(after.velocity.dot(n), -e.normal * v.dot(n), 1e-14 * v.norm());
    ASSERT_LT((tangential(after.velocity, n) - e.tangential * tangential(v, n)).norm(), 1e-14 * v.norm());
    ASSERT_EQ(after.spin, w);
    const Map3 turn = dice.turn();
    ASSERT_LT((plain_rebound(turn * v, w, turn * n, e).velocity - turn * after.velocity).norm(), 1e-13 * v.norm());
  }
}

TEST(RestitutionScaling, DecreasesWithSpeedAndMass) {
  RestitutionScaling scaling;
  EXPECT_EQ(scaling.scaled(0.5, -20, 5000), 0.5);
  scaling.normal_speed = 9.144;
  EXPECT_DOUBLE_EQ(scaling.scaled(0.5, -9.144, 5000), 0.25);
  EXPECT_DOUBLE_EQ(scaling.scaled(0.5, 3 * 9.144, 5000), 0.05);
  EXPECT_EQ(scaling.scaled(0.5, 0, 5000), 0.5);
  scaling.mass = 1000;
  EXPECT_DOUBLE_EQ(scaling.scaled(0.5, -9.144, 1000), 0.125);
  scaling.normal_speed.reset();
  EXPECT_DOUBLE_EQ(scaling.scaled(0.5, -9.144, 3000), 0.05);
}

}  // namespace
}  // namespace talus::plain_test
