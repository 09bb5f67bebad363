#include "talus/impact/rigid_sphere.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/dice.hpp"
#include "talus/impact/crsp.hpp"
#include "talus/rocks/motion.hpp"

namespace talus::rigid_sphere_test {
namespace {

using namespace testing_tools;

double energy(const Vec3& v, const Vec3& w, const Rock& r) {
  return 0.5 * r.mass * v.squared_norm() + 0.5 * r.inertia * w.squared_norm();
}

Vec3 contact_velocity(const Vec3& v, const Vec3& w, const Vec3& n, double radius) { return v - radius * w.cross(n); }

// By rounding, a sphere may already move away from what it touches.
TEST(RigidSphere, ASeparatingContactHasNoImpulse) {
  const Rock rock = sphere_of_diameter(1.0, 2700);
  const Vec3 v(3, 0, 1e-3), w(1, 2, 3);
  const Rebound after = rigid_sphere_rebound(v, w, {0, 0, 1}, rock, {0.5, 0.3}, ContactFriction{0.5});
  EXPECT_EQ(after.velocity, v);
  EXPECT_EQ(after.spin, w);
}

// Section 7.3 of the manual, step by step, in its frame n, t1, t2.
TEST(RigidSphere, SectionSevenThree) {
  const Rock rock = sphere_of_diameter(1.0, 2700);
  const Vec3 n(-0.816496581, 0.471404521, 0.3333333333), t1(-0.197654221, 0.314231598, -0.928542574);
  const Vec3 t2(-0.542463033, -0.824036577, -0.163393933);
  const Vec3 v(3, 0, -9.9599);
  EXPECT_NEAR(v.dot(n), -5.76946, 2e-5);
  EXPECT_NEAR(v.dot(t1), 8.65523, 2e-5);  // the manual prints 8.65552 and continues with 0.7 times 8.65523
  EXPECT_NEAR(v.dot(t2), 0, 2e-5);
  const double slip_mass = 1 / (1 / rock.mass + rock.radius * rock.radius / rock.inertia);
  EXPECT_NEAR(slip_mass, 403.92, 0.005);

  const Rebound after =
      rigid_sphere_rebound(v, Vec3{}, n, rock, {0.3, 0.7}, ContactFriction{std::tan(std::numbers::pi / 6)});
  const Vec3 u = contact_velocity(after.velocity, after.spin, n, rock.radius);
  EXPECT_NEAR(u.dot(n), 1.73084, 2e-5);
  EXPECT_NEAR(u.dot(t1), 6.05867, 2e-5);
  const Vec3 impulse = rock.mass * (after.velocity - v);
  EXPECT_NEAR(impulse.dot(n), 10603.297, 0.1);
  EXPECT_NEAR(impulse.dot(t1), -1048.805, 0.1);
  EXPECT_NEAR(after.velocity.dot(n), 1.73084, 2e-5);
  EXPECT_NEAR(after.velocity.dot(t1), 7.91336, 3e-4);
  EXPECT_NEAR(after.spin.norm(), 3.7094, 2e-4);
  EXPECT_LT((after.velocity - Vec3(-2.97733, 3.30255, -6.77095)).norm(), 1e-4);
  EXPECT_LT((after.spin - Vec3(-2.0122, -3.0567, -0.6061)).norm(), 2e-4);
}

// Table 7-1, rows 3-4: another triangle, with spin.
TEST(RigidSphere, SecondImpactOfTableSevenOne) {
  const Rock rock = sphere_of_diameter(1.0, 2700);
  const Vec3 v(-2.9777, 3.3027, -16.8975), w(-2.0124, -3.0570, -0.6061);
  const Vec3 expected(3.6974, 6.7518, -12.7491), spin(-6.04178, 2.7536, 1.0464);
  // Triangle ACD, the mirror image of BCD.
  const Vec3 acd(std::sqrt(2.0 / 3), std::sqrt(2.0) / 3, 1.0 / 3);
  const Rebound after =
      rigid_sphere_rebound(v, w, acd, rock, {0.3, 0.7}, ContactFriction{std::tan(std::numbers::pi / 6)});
  EXPECT_LT((after.velocity - expected).norm(), 2e-4) << after.velocity;
  EXPECT_LT((after.spin - spin).norm(), 3e-4) << after.spin;
}

// The first two impacts of tables C-1 (Rt = 0) and C-2 (Rt = 0.68). In C-1 the manual's spin has the opposite sign.
TEST(RigidSphere, TablesOfAppendixC) {
  const Rock rock = sphere_of_mass(799.906, 2700);
  const Vec2 d = Vec2(3.1, -12.2).normalized();
  const Vec3 n(-d.y(), 0, d.x());
  const auto first = [&](double rt, double mu) {
    return rigid_sphere_rebound({1.5, 0, -12.2677}, Vec3{}, n, rock, {0.55, rt}, ContactFriction{mu});
  };
  const Rebound sticking = first(0.68, 0.47);
  EXPECT_LT((sticking.velocity - Vec3(3.57856, 0, -10.583)).norm(), 3e-4) << sticking.velocity;
  EXPECT_NEAR(sticking.spin.y(), 6.77544, 2e-3);
  const Rebound slipping = first(0, 0.47);
  EXPECT_LT((slipping.velocity - Vec3(3.57343, 0, -10.5627)).norm(), 3e-4) << slipping.velocity;
  EXPECT_NEAR(slipping.spin.y(), 6.90244, 2e-3);
}

TEST(RigidSphere, WithoutFrictionNothingTangentialChanges) {
  const Rock rock = sphere_of_diameter(1.0, 2700);
  const Vec3 v(3, -2, -5), w(1, 2, 3);
  const Rebound after = rigid_sphere_rebound(v, w, unit_z, rock, {0.5, 0.2}, ContactFriction{0});
  EXPECT_LT((after.velocity - Vec3(3, -2, 2.5)).norm(), 1e-14);
  EXPECT_EQ(after.spin, w);
}

TEST(RigidSphere, SticksWithoutTangentialRestitutionAndRolls) {
  const Rock rock = sphere_of_diameter(1.0, 2700);
  const Rebound after = rigid_sphere_rebound({7, 0, -5}, Vec3{}, unit_z, rock, {0, 0}, ContactFriction{100});
  EXPECT_NEAR(after.velocity.x(), 5, 1e-12);  // a sphere that begins to roll keeps 5/7 of its velocity
  EXPECT_NEAR(after.spin.y(), 10, 1e-12);
  EXPECT_NEAR(after.velocity.z(), 0, 1e-12);
}

TEST(RigidSphere, RandomImpactsObeyTheLaw) {
  Dice dice(2);
  int slipped = 0, stuck = 0;
  for (int i = 0; i < 100'000; ++i) {
    const Rock r = sphere_of_diameter(dice.magnitude(0.01, 10), dice.between(1500, 3500));
    const Vec3 n = dice.direction();
    Vec3 v = dice.direction();
    v *= dice.magnitude(1e-6, 100);
    if (v.dot(n) > 0) v = -v;
    Vec3 w = dice.direction();
    w *= dice.chance(0.2) ? 0.0 : dice.magnitude(1e-6, 100) / r.radius;
    const Restitution e{dice.unit(), dice.chance(0.1) ? 1.0 : dice.unit()};
    const double mu = dice.chance(0.1) ? 0.0 : dice.magnitude(1e-3, 10);
    const Rebound after = rigid_sphere_rebound(v, w, n, r, e, ContactFriction{mu});
    const double speed = v.norm() + w.norm() * r.radius;
    ASSERT_LE(energy(after.velocity, after.spin, r), energy(v, w, r) * (1 + 1e-12));
    ASSERT_NEAR(after.velocity.dot(n), -e.normal * v.dot(n), 1e-13 * speed);
    ASSERT_NEAR(after.spin.dot(n), w.dot(n), 1e-13 * speed / r.radius);

    // Coulomb: the tangential impulse is at most mu times the normal one, against the slip, and less only if that
    // suffices to leave Rt of the slip.
    const Vec3 impulse = r.mass * (after.velocity - v);
    const double jn = impulse.dot(n), jt = tangential(impulse, n).norm();
    const Vec3 before_slip = tangential(contact_velocity(v, w, n, r.radius), n);
    const Vec3 after_slip = tangential(contact_velocity(after.velocity, after.spin, n, r.radius), n);
    ASSERT_LE(jt, mu * jn + 1e-11 * r.mass * speed);
    if (jt < mu * jn * (1 - 1e-9) - 1e-11 * r.mass * speed) {
      ASSERT_LT((after_slip - e.tangential * before_slip).norm(), 1e-11 * speed);
      ++stuck;
    } else {
      ASSERT_GE(after_slip.norm(), e.tangential * before_slip.norm() - 1e-11 * speed);
      ++slipped;
    }
    // The change of spin by the impulse, about the centre: I dw = rc x J.
    ASSERT_LT((r.inertia * (after.spin - w) + r.radius * n.cross(impulse)).norm(), 1e-11 * r.mass * r.radius * speed);

    const Map3 turn = dice.turn();
    const Rebound turned_after = rigid_sphere_rebound(turn * v, turn * w, turn * n, r, e, ContactFriction{mu});
    ASSERT_LT((turned_after.velocity - turn * after.velocity).norm(), 1e-11 * speed);
    const Vec3 m = dice.direction();
    const Map3 mirror = mirror_across(m);
    const Rebound mirrored = rigid_sphere_rebound(mirror * v, -(mirror * w), mirror * n, r, e, ContactFriction{mu});
    ASSERT_LT((mirrored.velocity - mirror * after.velocity).norm(), 1e-11 * speed);
    ASSERT_LT((mirrored.spin + mirror * after.spin).norm() * r.radius, 1e-10 * speed);
  }
  EXPECT_GT(slipped, 10'000);
  EXPECT_GT(stuck, 10'000);
}

// As one that rolls: dv = -5/7 mu_r Jn/m.
TEST(RigidSphere, LosesRollingResistanceOfTheImpulseInAnyNumberOfImpacts) {
  const Rock rock = sphere_of_diameter(1.0, 2700);
  for (const int impacts : {1, 10, 1000}) {
    Motion motion;
    motion.velocity = {10, 0, 0};
    motion.spin = {0, 10 / rock.radius, 0};
    for (int i = 0; i < impacts; ++i) {
      const Vec3 falling = motion.velocity - Vec3(0, 0, 5.0 / impacts);
      const Rebound after =
          rigid_sphere_rebound(falling, motion.spin, unit_z, rock, {0, 0}, {.dynamic = 0.6, .rolling = 0.4});
      motion.velocity = after.velocity;
      motion.spin = after.spin;
    }
    EXPECT_NEAR(motion.velocity.x(), 10 - 5.0 / 7 * 0.4 * 5, 1e-12) << impacts;
    EXPECT_NEAR(motion.spin.y() * rock.radius, motion.velocity.x(), 1e-12) << "still rolls";
  }
}

TEST(RigidSphere, RollingResistanceEndsTheRollingAtMost) {
  const Rock rock = sphere_of_diameter(1.0, 2700);
  const Rebound after =
      rigid_sphere_rebound({2, 0, -5}, {0, 2 / rock.radius, 3}, unit_z, rock, {0.3, 0}, {.dynamic = 10, .rolling = 10});
  EXPECT_NEAR(after.velocity.x(), 0, 1e-12);
  EXPECT_NEAR(after.velocity.z(), 1.5, 1e-12);
  EXPECT_NEAR(after.spin.y(), 0, 1e-12);
  EXPECT_EQ(after.spin.z(), 3) << "a spin about the normal does not roll";
}

TEST(RigidSphere, RollingResistanceOnlyTakesEnergyWithinCoulombsLimit) {
  Dice dice(3);
  for (int i = 0; i < 100'000; ++i) {
    const Rock r = sphere_of_diameter(dice.magnitude(0.01, 10), dice.between(1500, 3500));
    const Vec3 n = dice.direction();
    Vec3 v = dice.magnitude(1e-3, 100) * dice.direction();
    if (v.dot(n) > 0) v = -v;
    const Vec3 w = dice.magnitude(1e-3, 100) / r.radius * dice.direction();
    const Restitution e{dice.unit(), dice.chance(0.5) ? 0.0 : dice.unit()};
    const ContactFriction friction{dice.magnitude(1e-2, 3), dice.magnitude(1e-2, 3)};
    const Rebound without = rigid_sphere_rebound(v, w, n, r, e, ContactFriction{friction.dynamic});
    const Rebound after = rigid_sphere_rebound(v, w, n, r, e, friction);
    const double speed = v.norm() + w.norm() * r.radius;
    ASSERT_LE(energy(after.velocity, after.spin, r), energy(without.velocity, without.spin, r) * (1 + 1e-12));
    ASSERT_NEAR(after.velocity.dot(n), without.velocity.dot(n), 1e-13 * speed);
    ASSERT_NEAR(after.spin.dot(n), without.spin.dot(n), 1e-13 * speed / r.radius);
    const Vec3 impulse = r.mass * (after.velocity - v);
    ASSERT_LE(tangential(impulse, n).norm(), friction.dynamic * impulse.dot(n) * (1 + 1e-9) + 1e-11 * r.mass * speed);
    const Vec3 spin = tangential(after.spin, n), spin_without = tangential(without.spin, n);
    ASSERT_LE(spin.norm(), spin_without.norm() * (1 + 1e-12));
    ASSERT_GE(spin.dot(spin_without), -1e-12 * spin_without.squared_norm());
  }
}

TEST(RigidSphere, CrspDampingScalesTheEnergyOfSlip) {
  const Rock rock = sphere_of_diameter(1.0, 2700);
  const Restitution e{0.3, 0.7};
  const Vec3 v(3, 0, -6), w(0, 2, 0);
  const double slip = 3 - 2 * 0.5;
  const double rt = crsp_damped_tangential_restitution(v, w, unit_z, rock, e);
  EXPECT_DOUBLE_EQ(rt * rt, crsp_friction_function(slip, 0.7) * crsp_scaling_factor(-6, e));
  EXPECT_LE(rt, 1);
  EXPECT_EQ(crsp_damped_tangential_restitution(v, w, unit_z, rock, {0, 0.7}), 0);
}

}  // namespace
}  // namespace talus::rigid_sphere_test
