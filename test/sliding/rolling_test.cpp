#include "talus/sliding/rolling.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/dice.hpp"

namespace talus::rolling_test {
namespace {

using testing_tools::Dice;

const Vec3 gravity(0, 0, -standard_gravity);
const Rock rock = sphere_of_diameter(1.0, 2700);

Vec3 normal_of_slope(double angle) { return {std::sin(angle), 0, std::cos(angle)}; }

struct State {
  Vec3 position, velocity, spin;
  double time = 0;
};

State roll(State state, const Vec3& n, ContactFriction friction, double timestep, double longest) {
  const Footing footing = Footing::on_plane(gravity, n);
  while (state.time < longest * (1 - 1e-12)) {
    const Leg leg = rolling_leg(state.position, state.velocity, state.spin, n, footing, rock, friction,
                                std::min(timestep, longest - state.time));
    state.position = leg.path.at(leg.duration);
    state.velocity = leg.end_velocity;
    state.spin = leg.end_spin;
    state.time += leg.duration;
    if (state.velocity.norm() == 0 && holds(footing, friction)) break;
  }
  return state;
}

TEST(Rolling, AcceleratesByFiveSeventhsDownAPlane) {
  const double angle = 0.4;
  const Vec3 n = normal_of_slope(angle), down(std::cos(angle), 0, -std::sin(angle));
  for (const double resistance : {0.0, 0.1}) {
    const double a = 5.0 / 7 * standard_gravity * (std::sin(angle) - resistance * std::cos(angle));
    for (const double dt : {0.01, 0.37}) {  // constant acceleration: exact for any step
      const State end = roll({}, n, {0.6, resistance}, dt, 2);
      EXPECT_LT((end.velocity - 2 * a * down).norm(), 1e-12);
      EXPECT_LT((end.position - 2 * a * down).norm(), 1e-11);
      EXPECT_LT((end.spin - n.cross(end.velocity) / rock.radius).norm(), 1e-12);
    }
  }
}

TEST(Rolling, SlipsIfFrictionIsTooSmall) {
  const double angle = 0.8, mu = 0.2;  // rolling needs 2/7 tan(angle) = 0.294
  const Vec3 n = normal_of_slope(angle), down(std::cos(angle), 0, -std::sin(angle));
  const State end = roll({}, n, {mu, 0}, 0.01, 1);
  const double a = standard_gravity * (std::sin(angle) - mu * std::cos(angle));
  EXPECT_LT((end.velocity - a * down).norm(), 1e-10);
  const double angular = mu * rock.mass * standard_gravity * std::cos(angle) * rock.radius / rock.inertia;
  EXPECT_NEAR(end.spin.y(), angular, 1e-10);
  EXPECT_GT(slip_velocity(end.velocity, end.spin, n, rock.radius).x(), 1);
}

// A sphere on level ground without spin: it slips for 2 v0 / (7 mu g) and then rolls with 5/7 of its speed.
TEST(Rolling, BeginsAfterSlipping) {
  const double v0 = 6, mu = 0.3, t = 2 * v0 / (7 * mu * standard_gravity);
  const Vec3 n = unit_z;
  State state;
  state.velocity = {v0, 0, 0};
  const State end = roll(state, n, {mu, 0}, 0.01, t);
  EXPECT_NEAR(end.velocity.x(), 5.0 / 7 * v0, 1e-9);
  EXPECT_NEAR(end.spin.y(), end.velocity.x() / rock.radius, 1e-9);
  EXPECT_NEAR(end.position.x(), v0 * t - 0.5 * mu * standard_gravity * t * t, 1e-9);
  const State later = roll(state, n, {mu, 0}, 0.01, 3 * t);
  EXPECT_NEAR(later.velocity.x(), 5.0 / 7 * v0, 1e-9);
  EXPECT_LT(slip_velocity(later.velocity, later.spin, n, rock.radius).norm(), 1e-9);
}

TEST(Rolling, ComesToRestByItsResistance) {
  State state;
  state.velocity = {3, 0, 0};
  state.spin = {0, 3 / rock.radius, 0};
  const double a = 5.0 / 7 * 0.1 * standard_gravity;
  const State end = roll(state, unit_z, {0.6, 0.1}, 0.01, 100);
  EXPECT_NEAR(end.time, 3 / a, 1e-9);
  EXPECT_NEAR(end.position.x(), 9 / (2 * a), 1e-9);
  EXPECT_EQ(end.velocity, Vec3{});
  EXPECT_LT(tangential(end.spin, unit_z).norm(), 1e-9);
}

// Resistance holds a slow sphere but does not drive it, for any length of the step.
TEST(Rolling, IsNotPushedUphillByItsResistance) {
  const Vec3 n = normal_of_slope(0.17), down(std::cos(0.17), 0, -std::sin(0.17));
  for (const double speed : {0.0, 1e-12, 1e-10, 1e-9, 1e-6}) {
    for (const double way : {1.0, -1.0}) {
      const Vec3 velocity = way * speed * down;
      const State end = roll({Vec3{}, velocity, rolling_spin(velocity, Vec3{}, n, rock.radius)}, n, {0.8, 0.5}, 1, 5);
      EXPECT_LT(end.position.norm(), 5e-6) << speed;
      EXPECT_LE(end.velocity.norm(), speed);
    }
  }
}

TEST(Rolling, KeepsTheSpinAboutTheNormal) {
  State state;
  state.velocity = {3, 0, 0};
  state.spin = {0, 3 / rock.radius, 5};
  EXPECT_NEAR(roll(state, unit_z, {0.6, 0.1}, 0.01, 1).spin.z(), 5, 1e-12);
}

TEST(Rolling, HoldsByTheSmallerFriction) {
  const Footing footing = Footing::on_plane(gravity, normal_of_slope(0.2));
  EXPECT_TRUE(holds(footing, ContactFriction{0.5, 0.21}));
  EXPECT_FALSE(holds(footing, ContactFriction{0.5, 0.2}));
  EXPECT_FALSE(holds(footing, ContactFriction{0.2, 0.5}));
}

// Friction little above and below what rolling needs, and a pull across the motion: slip is slow and turns quickly.
TEST(Rolling, DoesNotAmplifyRounding) {
  Dice dice(64);
  const Vec3 n = unit_z;
  constexpr double disturbance = 1e-12;
  double largest = 0;
  for (int i = 0; i < 200; ++i) {
    const double heading = dice.between(0, 3), mu = dice.between(0.3, 0.7), normal = dice.between(1, 8);
    const Footing footing{4.5 * dice.between(0.5, 1) * mu * normal * Vec3(std::cos(heading), std::sin(heading), 0),
                          normal};
    const Vec3 velocity(1.8, 0, 0), spin = rolling_spin(velocity, Vec3{}, n, rock.radius) + dice.in_cube(0.1);
    const auto end_from = [&](const Vec3& start) {
      State state{Vec3{}, start, spin};
      while (state.time < 1) {
        const Leg leg =
            rolling_leg(state.position, state.velocity, state.spin, n, footing, rock, ContactFriction{mu, 0.1}, 0.01);
        state = {leg.path.at(leg.duration), leg.end_velocity, leg.end_spin, state.time + leg.duration};
      }
      return state;
    };
    const State a = end_from(velocity), b = end_from(velocity + Vec3(0, disturbance, 0));
    largest = std::max(largest, (a.position - a.time * a.velocity - b.position + b.time * b.velocity).norm());
  }
  EXPECT_LT(largest, 100 * disturbance);
}

TEST(Rolling, EnergyNeverRises) {
  Dice dice(63);
  for (int i = 0; i < 100'000; ++i) {
    Vec3 n = dice.direction();
    n.z() = std::abs(n.z()) + 1e-3;
    n = n.normalized();
    const Footing footing = Footing::on_plane(gravity, n);
    const Rock r = sphere_of_diameter(dice.magnitude(0.05, 5), 2700);
    const ContactFriction friction{dice.magnitude(0.01, 3), dice.chance(0.2) ? 0.0 : dice.magnitude(1e-3, 1)};
    const double dt = dice.magnitude(1e-4, 0.02);
    const Vec3 v = dice.magnitude(1e-6, 30) * tangential(dice.direction(), n).normalized();
    Vec3 w = dice.direction();
    w *= dice.magnitude(1e-6, 30) / r.radius;
    if (dice.chance(0.5)) w = rolling_spin(v, w, n, r.radius);
    const Leg leg = rolling_leg(Vec3{}, v, w, n, footing, r, friction, dt);
    const auto kinetic = [&](const Vec3& velocity, const Vec3& spin) {
      return 0.5 * velocity.squared_norm() + 0.5 * r.inertia / r.mass * spin.squared_norm();
    };
    const double before = kinetic(v, w);
    const double after = kinetic(leg.end_velocity, leg.end_spin) - gravity.dot(leg.path.at(leg.duration));
    ASSERT_LE(after, before + 1e-12 * (1 + before))
        << i << " n " << n << " mu " << friction.dynamic << " rolling " << friction.rolling << " dt " << dt << " v "
        << v << " w r " << w * r.radius << " duration " << leg.duration;
  }
}

}  // namespace
}  // namespace talus::rolling_test
