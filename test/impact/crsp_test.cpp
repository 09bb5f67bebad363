#include "talus/impact/crsp.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/dice.hpp"

namespace talus::crsp_test {
namespace {

using namespace testing_tools;

// The rock of the manual's sections 2 and 7, and the normal of triangle BCD.
const Rock rock = sphere_of_diameter(1.0, 2700);
const Vec3 normal_bcd(-std::sqrt(2.0 / 3), std::sqrt(2.0) / 3, 1.0 / 3);

double energy(const Vec3& v, const Vec3& w, const Rock& r) {
  return 0.5 * r.mass * v.squared_norm() + 0.5 * r.inertia * w.squared_norm();
}

TEST(Crsp, TheManualsRock) {
  EXPECT_NEAR(rock.mass, 1413.7167, 1e-4);
  EXPECT_NEAR(rock.inertia, 141.3717, 1e-4);
}

// Section 2.3, with the manual's numbers as input.
TEST(Crsp, FactorsOfTheManual) {
  EXPECT_NEAR(crsp_scaling_factor(-6.047294534, {0.3, 0.7}), 0.65422, 5e-6);
  EXPECT_NEAR(crsp_friction_function(9.43017, 0.7), 0.78349, 5e-6);
}

TEST(Crsp, FirstImpactOfTheManual) {
  const Vec3& n = normal_bcd;
  const Rebound after = crsp_rebound({3, 0, -10.7934}, Vec3{}, n, rock, {0.3, 0.7});
  EXPECT_NEAR(after.velocity.dot(n), 1.81419, 2e-5);
  EXPECT_NEAR(tangential(after.velocity, n).norm(), 5.706, 5e-4);
  EXPECT_NEAR(after.spin.norm(), 11.412, 1e-3);
  EXPECT_LT((after.velocity - Vec3(-2.65369, 2.58014, -4.70648)).norm(), 3e-5);
  EXPECT_LT((after.spin - Vec3(-6.15741, -9.45478, -1.71143)).norm(), 5e-5);
}

// Tables 2-4 and 2-5, rows 3 to 4, on the same triangle: the rock arrives with spin, which turns the tangent frame.
// With t1 along the velocity the result would be (-2.955, 2.637, -9.334).
TEST(Crsp, SecondImpactOfTheManual) {
  struct Case {
    Vec3 v, w, v_after, w_after;
  };
  const Case cases[] = {{{-2.6531, 2.5798, -15.5889},
                         {-6.1561, -9.4525, -1.7115},
                         {-3.0604, 2.4633, -9.3476},
                         {-10.4552, -17.3048, -1.1372}},
                        {{-2.6537, 2.5801, -15.5916},
                         {-6.1574, -9.4548, -1.7114},
                         {-3.0610, 2.4636, -9.3492},
                         {-10.4569, -17.3078, -1.1371}}};
  for (const Case& c : cases) {
    const Rebound after = crsp_rebound(c.v, c.w, normal_bcd, rock, {0.3, 0.7});
    EXPECT_LT((after.velocity - c.v_after).norm(), 2e-4) << after.velocity;
    EXPECT_LT((after.spin - c.w_after).norm(), 6e-4) << after.spin;
  }
}

// Table A-2, rows 1-2, 3-4 and 5-6. Its spin is positive about y here.
TEST(Crsp, ImpactsOfTheTutorial) {
  const Rock tutorial = sphere_of_mass(1000, 2700);
  struct Case {
    Vec2 from, to;  // of the segment
    double rn;
    Vec3 v;
    double w;
    Vec3 v_after;
    double w_after;
  };
  const Case cases[] = {
      {{0, 0}, {3.1, -12.2}, 0.5, {1.5, 0, -14.4731}, 0, {3.73746, 0, -10.4238}, 24.7433},
      {{3.1, -12.2}, {6.7, -12.2}, 0.4, {3.73746, 0, -11.7673}, 24.7433, {5.73052, 0, 4.70691}, 12.8631},
      {{13.4, -25}, {26, -22.5}, 0.3, {5.73052, 0, -16.281}, 12.8631, {1.71352, 0, 5.56539}, 6.20399}};
  for (const Case& c : cases) {
    const Vec2 d = (c.to - c.from).normalized();
    const Rebound after = crsp_rebound(c.v, {0, c.w, 0}, {-d.y(), 0, d.x()}, tutorial, {c.rn, 0.9});
    EXPECT_LT((after.velocity - c.v_after).norm(), 2e-4) << after.velocity;
    EXPECT_NEAR(after.spin.y(), c.w_after, 1e-3);
    EXPECT_NEAR(after.spin.x(), 0, 1e-12);
  }
}

TEST(Crsp, WithoutNormalRestitutionNoSpeedRemains) {
  const Rebound after = crsp_rebound({3, 1, -5}, {1, 2, 3}, unit_z, rock, {0, 0.8});
  EXPECT_EQ(after.velocity, Vec3{});
  EXPECT_EQ(after.spin, Vec3(0, 0, 3));
}

TEST(Crsp, WithoutTangentialRestitutionItLeavesAlongTheNormal) {
  const Rebound after = crsp_rebound({3, 1, -5}, {1, 2, 3}, unit_z, rock, {0.5, 0});
  EXPECT_EQ(after.velocity, Vec3(0, 0, 2.5));
  EXPECT_EQ(after.spin, Vec3(0, 0, 3));
}

TEST(Crsp, StraightDownLeavesStraightUp) {
  const Rebound after = crsp_rebound({0, 0, -5}, {0, 0, 3}, unit_z, rock, {0.5, 0.8});
  EXPECT_EQ(after.velocity, Vec3(0, 0, 2.5));
  EXPECT_EQ(after.spin, Vec3(0, 0, 3));
}

// v1 = 0 with spin: the rock leaves in the direction in which its spin drives it.
TEST(Crsp, SpinAloneDrivesTheRock) {
  const Rebound after = crsp_rebound({0, 0, -5}, {0, 4, 0}, unit_z, rock, {0.5, 0.8});
  EXPECT_GT(after.velocity.x(), 0.1);
  EXPECT_NEAR(after.velocity.y(), 0, 1e-15);
  EXPECT_NEAR(after.spin.y(), after.velocity.x() / rock.radius, 1e-12);
}

// A rock that is set down arrives with a tiny velocity by rounding.
TEST(Crsp, SpinDrivesARockThatHardlyMoves) {
  const Rebound still = crsp_rebound({0, 0, -1e-7}, {0, 12, 0}, unit_z, rock, {0.3, 0.7});
  for (const double along : {1e-7, -1e-7}) {
    const Rebound after = crsp_rebound({along, 0, -1e-7}, {0, 12, 0}, unit_z, rock, {0.3, 0.7});
    EXPECT_LT((after.velocity - still.velocity).norm(), 1e-6);
    EXPECT_LT((after.spin - still.spin).norm(), 1e-6);
  }
}

// As spin about the axis of rolling vanishes, the law approaches that without spin.
TEST(Crsp, VanishingSpinHasNoEffect) {
  const Vec3 v(3, 0, -5);
  const Rebound none = crsp_rebound(v, Vec3{}, unit_z, rock, {0.5, 0.8});
  for (const double w : {1e-3, 1e-6, 1e-9, 1e-12, 1e-300}) {
    for (const double sense : {1.0, -1.0}) {
      const Rebound some = crsp_rebound(v, {0, sense * w, 0}, unit_z, rock, {0.5, 0.8});
      EXPECT_LT((some.velocity - none.velocity).norm(), w + 1e-12);
      EXPECT_TRUE(some.velocity.is_finite() && some.spin.is_finite());
    }
  }
}

TEST(Crsp, RandomImpactsObeyTheLaw) {
  Dice dice(1);
  for (int i = 0; i < 100'000; ++i) {
    const Rock r = sphere_of_diameter(dice.magnitude(0.01, 10), dice.between(1500, 3500));
    const Vec3 n = dice.direction();
    Vec3 v = dice.direction();
    v *= dice.magnitude(1e-6, 100);
    if (v.dot(n) > 0) v = -v;
    Vec3 w = dice.direction();
    w *= dice.chance(0.2) ? 0.0 : dice.magnitude(1e-6, 100) / r.radius;
    const Restitution e{dice.unit(), dice.chance(0.1) ? 1.0 : dice.unit()};
    const Rebound after = crsp_rebound(v, w, n, r, e);
    ASSERT_LE(energy(after.velocity, after.spin, r), energy(v, w, r) * (1 + 1e-12));
    const double speed = v.norm() + w.norm() * r.radius;
    ASSERT_NEAR(after.velocity.dot(n), -e.normal * v.dot(n), 1e-13 * speed);
    ASSERT_NEAR(after.spin.dot(n), w.dot(n), 1e-13 * speed / r.radius);
    // The rock leaves rolling: the contact point is at rest.
    const Vec3 contact = tangential(after.velocity - r.radius * after.spin.cross(n), n);
    ASSERT_LT(contact.norm(), 1e-11 * speed);

    // The impact is invariant under rotation and under reflection in a plane through the origin (spin is an axial
    // vector).
    const Map3 turn = dice.turn();
    const Rebound turned_after = crsp_rebound(turn * v, turn * w, turn * n, r, e);
    const double tolerance = 1e-9 * speed;
    ASSERT_LT((turned_after.velocity - turn * after.velocity).norm(), tolerance);
    const Vec3 m = dice.direction();
    const Map3 mirror = mirror_across(m);
    const Rebound mirrored = crsp_rebound(mirror * v, -(mirror * w), mirror * n, r, e);
    ASSERT_LT((mirrored.velocity - mirror * after.velocity).norm(), tolerance);
    ASSERT_LT((mirrored.spin + mirror * after.spin).norm() * r.radius, tolerance);
  }
}

}  // namespace
}  // namespace talus::crsp_test
