#include "talus/sliding/bend.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace talus::bend_test {
namespace {

const Rock rock = sphere_of_diameter(1.0, 2700);
constexpr double degrees = std::numbers::pi / 180;

TEST(Bend, TurnsTheVelocityAlongTheGroundAtTheSameSpeed) {
  const Vec3 velocity(3, 4, -2), n = Vec3(0.1, -0.2, 1).normalized();
  const Vec3 turned = turned_onto(velocity, n);
  EXPECT_NEAR(turned.norm(), velocity.norm(), 1e-14);
  EXPECT_NEAR(turned.dot(n), 0, 1e-14);
  EXPECT_EQ(turned_onto(Vec3(0, 0, -2), unit_z), Vec3{}) << "no direction along the ground";
}

TEST(Bend, HasTheAngleAtWhichTheVelocityLeadsIntoTheGround) {
  const Vec3 velocity = 7 * Vec3(std::cos(10 * degrees), 0, -std::sin(10 * degrees));
  EXPECT_NEAR(bend_angle(velocity, unit_z), 10 * degrees, 1e-14);
  EXPECT_EQ(bend_angle(-velocity, unit_z), 0);
  EXPECT_EQ(bend_angle(Vec3{}, unit_z), 0);
}

// Rolling: dv = -5/7 mu_r v dtheta.
TEST(Bend, TakesRollingResistanceOfTheImpulseFromARollingSphere) {
  const Vec3 velocity(10, 0, 0), n = unit_z;
  const Vec3 spin = rolling_spin(velocity, Vec3(0, 0, 3), n, rock.radius);
  const Turned turned = rolled_round_bend(velocity, spin, n, 0.1, rock, {.dynamic = 0.6, .rolling = 0.3});
  EXPECT_NEAR(turned.velocity.x(), 10 * (1 - 5.0 / 7 * 0.3 * 0.1), 1e-12);
  EXPECT_NEAR(slip_velocity(turned.velocity, turned.spin, n, rock.radius).norm(), 0, 1e-9);
  EXPECT_NEAR(turned.spin.z(), 3, 1e-12);
}

// Slipping: mu times the impulse brakes the centre, and spins the sphere up by 5/2 of that at its surface.
TEST(Bend, TakesFrictionOfTheImpulseFromASlippingSphere) {
  const Vec3 velocity(10, 0, 0), n = unit_z;
  const double lost = 0.4 * 0.1 * 10;
  const Turned turned = rolled_round_bend(velocity, Vec3{}, n, 0.1, rock, {.dynamic = 0.4, .rolling = 0});
  EXPECT_NEAR(turned.velocity.x(), 10 - lost, 1e-12);
  EXPECT_NEAR(turned.spin.y() * rock.radius, 2.5 * lost, 1e-12);
}

TEST(Bend, NeverAddsEnergy) {
  const Vec3 n = unit_z;
  const auto energy = [](const Vec3& v, const Vec3& w) {
    return rock.mass * v.squared_norm() + rock.inertia * w.squared_norm();
  };
  for (const Vec3& spin : {Vec3(0, 0, 0), Vec3(0, 40, 0), Vec3(0, -40, 0), Vec3(9, 3, 1), Vec3(0, 1e-7, 0)}) {
    for (const double angle : {1e-9, 0.01, 0.26, 0.7}) {
      for (const ContactFriction friction : {ContactFriction{0, 0}, {0.5, 0}, {0.5, 0.3}, {0.1, 3}, {0, 1}}) {
        const Vec3 velocity(6, 2, 0);
        const Turned turned = rolled_round_bend(velocity, spin, n, angle, rock, friction);
        ASSERT_TRUE(turned.velocity.is_finite() && turned.spin.is_finite());
        EXPECT_LE(energy(turned.velocity, turned.spin), energy(velocity, spin) * (1 + 1e-12));
      }
    }
  }
}

}  // namespace
}  // namespace talus::bend_test
