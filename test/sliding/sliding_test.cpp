// The laws of sliding of a lumped mass: closed form and stepped, on one plane, leg by leg.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/dice.hpp"
#include "talus/sliding/closed_form.hpp"
#include "talus/sliding/stepped.hpp"

namespace talus::sliding_test {
namespace {

using testing_tools::Dice;

const Vec3 gravity(0, 0, -standard_gravity);

// A plane that falls along x at this angle.
Vec3 normal_of_slope(double angle) { return {std::sin(angle), 0, std::cos(angle)}; }

struct State {
  Vec3 position, velocity;
  double time = 0;
};

Vec3 velocity_at(const Leg& leg, double t) { return t >= leg.duration ? leg.end_velocity : leg.path.velocity(t); }

// Leg after leg to a standstill, or for `longest`.
template <class Law>
State slide(const Law& law, State state, const Footing& footing, double mu, double timestep, double longest) {
  while (state.time < longest * (1 - 1e-12)) {
    const Leg leg = law(state.position, state.velocity, Vec3{}, footing, mu, timestep);
    const double t = std::min(leg.duration, longest - state.time);
    state.position = leg.path.at(t);
    state.velocity = velocity_at(leg, t);
    state.time += t;
    if (state.velocity.norm() == 0) break;
  }
  return state;
}

// ---- closed form ----

TEST(ClosedForm, StopsAfterItsBrakingDistance) {
  for (const double angle : {-0.4, 0.0, 0.3}) {
    const Footing footing = Footing::on_plane(gravity, normal_of_slope(angle));
    const Vec3 downhill(std::cos(angle), 0, -std::sin(angle));
    const double mu = std::tan(0.6), v = 7;
    const double a = standard_gravity * (mu * std::cos(angle) - std::sin(angle));
    const Leg leg = closed_form_leg(Vec3{}, v * downhill, {1, 2, 3}, footing, mu, 0.01);
    EXPECT_NEAR(leg.duration, v / a, 1e-13);
    EXPECT_LT((leg.path.at(leg.duration) - v * v / (2 * a) * downhill).norm(), 1e-12);
    EXPECT_EQ(leg.end_velocity, Vec3{});
    EXPECT_EQ(leg.end_spin, Vec3(1, 2, 3));
  }
}

// Table B-1, rows 4 and 5: up a slope of 33.48 degrees at (1.4293, 0.94004) until it turns.
TEST(ClosedForm, TurnsBackAsInTableB1) {
  // Segment two of section 3's slope: from (50, 30) through (73.054, 45.162).
  const Vec3 along = Vec3(73.054 - 50, 0, 45.162 - 30).normalized();
  const Footing footing = Footing::on_plane(gravity, {-along.z(), 0, along.x()});
  const double mu = std::tan(std::numbers::pi / 6);
  const Leg leg =
      closed_form_leg({73.054, 0, 45.162}, Vec3(1.4293, 0, 0.94004).norm() * along, Vec3{}, footing, mu, 0.01);
  EXPECT_NEAR(0.36199 + leg.duration, 0.53105, 2e-5);
  EXPECT_LT((leg.path.at(leg.duration) - Vec3(73.174, 0, 45.241)).norm(), 1e-3);
  EXPECT_FALSE(holds(footing, mu));
  const Leg back = closed_form_leg(leg.path.at(leg.duration), Vec3{}, Vec3{}, footing, mu, 0.01);
  const double distance = (leg.path.at(leg.duration) - Vec3(50, 0, 30)).norm();
  const double t = std::sqrt(2 * distance / back.path.a.norm());
  EXPECT_NEAR(t, 9.18066, 0.01);
  EXPECT_NEAR(back.path.velocity(t).x(), -5.0485, 0.01);
}

TEST(ClosedForm, StartsARockAtRestAlongThePull) {
  const double angle = 0.7;
  const Footing footing = Footing::on_plane(gravity, normal_of_slope(angle));
  const Leg leg = closed_form_leg(Vec3{}, Vec3{}, Vec3{}, footing, 0.5, 0.01);
  const double a = standard_gravity * (std::sin(angle) - 0.5 * std::cos(angle));
  EXPECT_TRUE(std::isinf(leg.duration));
  EXPECT_LT((leg.path.a - a * Vec3(std::cos(angle), 0, -std::sin(angle))).norm(), 1e-14);
}

// The exact hodograph, v(psi) = C tan(psi/2)^k / sin(psi), and its time. From d(psi)/dt = -pull sin(psi) / v: t =
// integral of v / (pull sin(psi)) d(psi).
TEST(ClosedForm, ObliqueConvergesToTheHodographAtSecondOrder) {
  const double angle = 0.6, mu = 0.4, psi0 = 1.9, v0 = 6, end = 0.8;
  const Vec3 n = normal_of_slope(angle);
  const Footing footing = Footing::on_plane(gravity, n);
  const double pull = footing.pull.norm(), k = mu * footing.normal_acceleration / pull;
  const Vec3 down = footing.pull / pull, across = n.cross(down);
  const double c = v0 * std::sin(psi0) / std::pow(std::tan(psi0 / 2), k);
  const auto speed = [&](double psi) { return c * std::pow(std::tan(psi / 2), k) / std::sin(psi); };
  // Simpson's rule from psi0 downwards until the time has passed.
  double psi = psi0, t = 0;
  const double step = 1e-5;
  const auto rate = [&](double angle_now) { return speed(angle_now) / (pull * std::sin(angle_now)); };
  while (true) {
    const double slice = step / 6 * (rate(psi) + 4 * rate(psi - step / 2) + rate(psi - step));
    if (t + slice > end) {
      psi -= step * (end - t) / slice;
      break;
    }
    t += slice;
    psi -= step;
  }
  const Vec3 exact = speed(psi) * (std::cos(psi) * down + std::sin(psi) * across);
  const Vec3 start = v0 * (std::cos(psi0) * down + std::sin(psi0) * across);
  const auto error = [&](double timestep) {
    return (slide(closed_form_leg, {Vec3{}, start, 0}, footing, mu, timestep, end).velocity - exact).norm();
  };
  const double coarse = error(0.02), middle = error(0.01), fine = error(0.005);
  EXPECT_LT(coarse, 2e-3);
  EXPECT_NEAR(std::log2(coarse / middle), 2, 0.15);
  EXPECT_NEAR(std::log2(middle / fine), 2, 0.15);
}

// Friction exceeds the pull, and the rock moves across the slope: it comes to rest in a bounded time without speeding
// up.
TEST(ClosedForm, ObliqueComesToRest) {
  Dice dice(61);
  for (int i = 0; i < 2000; ++i) {
    const double angle = dice.between(0.05, 1.0), mu = std::tan(angle) * dice.between(1.05, 3);
    const Vec3 n = normal_of_slope(angle);
    const Footing footing = Footing::on_plane(gravity, n);
    State state;
    state.velocity = dice.between(0.01, 10) * tangential(dice.direction(), n).normalized();
    double energy = 0.5 * state.velocity.squared_norm();
    int legs = 0;
    while (state.velocity.norm() > 1e-9) {
      const Leg leg = closed_form_leg(state.position, state.velocity, Vec3{}, footing, mu, 0.01);
      ASSERT_TRUE(std::isfinite(leg.duration));
      state.position = leg.path.at(leg.duration);
      state.velocity = leg.end_velocity;
      const double now = 0.5 * state.velocity.squared_norm() - gravity.dot(state.position);
      ASSERT_LE(now, energy + 1e-12);
      energy = now;
      ASSERT_LT(++legs, 50'000) << "angle " << angle << " mu " << mu << " still at " << state.velocity.norm();
    }
  }
}

// ---- stepped ----

TEST(Stepped, ConvergesToTheClosedFormAtFirstOrder) {
  const double angle = 0.3, mu = std::tan(0.6), v = 7.001;
  const Footing footing = Footing::on_plane(gravity, normal_of_slope(angle));
  const Vec3 downhill(std::cos(angle), 0, -std::sin(angle));
  const double a = standard_gravity * (mu * std::cos(angle) - std::sin(angle)), distance = v * v / (2 * a);
  const auto error = [&](double timestep) {
    const State end = slide(stepped_leg, {Vec3{}, v * downhill, 0}, footing, mu, timestep, 1e3);
    EXPECT_NEAR(end.time, v / a, 1e-9);
    return end.position.norm() - distance;
  };
  const double coarse = error(0.01), fine = error(0.001), finest = error(0.0001);
  EXPECT_NEAR(coarse / fine, 10, 0.5);
  EXPECT_NEAR(fine / finest, 10, 0.5);
  EXPECT_NEAR(finest, -0.5 * v * 0.0001, 1e-5);  // each step is half a change of velocity short of the mean speed
}

// Semi-implicit Euler: after n steps from rest the distance is a n (n+1) dt^2 / 2, the speed n a dt.
TEST(Stepped, StepsAreSemiImplicit) {
  const double angle = 0.7, mu = 0.5, dt = 0.01;
  const Footing footing = Footing::on_plane(gravity, normal_of_slope(angle));
  const double a = standard_gravity * (std::sin(angle) - mu * std::cos(angle));
  const State end = slide(stepped_leg, {}, footing, mu, dt, 100 * dt);
  EXPECT_NEAR(end.velocity.norm(), 100 * a * dt, 1e-12);
  EXPECT_NEAR(end.position.norm(), a * 100 * 101 / 2 * dt * dt, 1e-12);
}

// Table B-2, row 5: 16 full steps and one of 0.00891 s without displacement.
TEST(Stepped, TurnsBackAsInTableB2) {
  const Vec3 along = Vec3(73.0533 - 50, 0, 45.1624 - 30).normalized();
  const Footing footing = Footing::on_plane(gravity, Vec3(-along.z(), 0, along.x()));
  const State end = slide(stepped_leg, {{73.0533, 0, 45.1624}, along.dot(Vec3(1.42185, 0, 0.948681)) * along, 0},
                          footing, std::tan(std::numbers::pi / 6), 0.01, 1.0);
  EXPECT_NEAR(end.time, 0.16891, 1e-5);
  EXPECT_LT((end.position - Vec3(73.1668, 0, 45.2371)).norm(), 2e-4);
}

TEST(Stepped, TheLastStepHasNoDisplacement) {
  const Footing footing = Footing::on_plane(gravity, unit_z);
  const Leg leg = stepped_leg({1, 2, 3}, {0.01, 0, 0}, {4, 5, 6}, footing, 0.5, 0.01);
  EXPECT_DOUBLE_EQ(leg.duration, 0.01 / (0.5 * standard_gravity));
  EXPECT_EQ(leg.path.at(leg.duration), Vec3(1, 2, 3));
  EXPECT_EQ(leg.end_velocity, Vec3{});
  EXPECT_EQ(leg.end_spin, Vec3(4, 5, 6));
}

// ---- both ----

TEST(Sliding, IsPreventedBySufficientFriction) {
  const double angle = 0.4;
  const Footing footing = Footing::on_plane(gravity, normal_of_slope(angle));
  EXPECT_NEAR(footing.pull.norm(), standard_gravity * std::sin(angle), 1e-13);
  EXPECT_NEAR(footing.normal_acceleration, standard_gravity * std::cos(angle), 1e-13);
  EXPECT_TRUE(holds(footing, std::tan(angle) + 1e-9));
  EXPECT_FALSE(holds(footing, std::tan(angle) - 1e-9));
  const Footing hanging = Footing::on_plane(gravity, {0, 0, -1});
  EXPECT_LT(hanging.normal_acceleration, 0);
  EXPECT_FALSE(holds(hanging, 100));
}

TEST(Sliding, EnergyNeverRises) {
  Dice dice(62);
  for (int i = 0; i < 100'000; ++i) {
    Vec3 n = dice.direction();
    n.z() = std::abs(n.z()) + 1e-3;
    n = n.normalized();
    const Footing footing = Footing::on_plane(gravity, n);
    const double mu = dice.chance(0.1) ? 0.0 : dice.magnitude(1e-3, 10), dt = dice.magnitude(1e-4, 0.1);
    Vec3 v;
    if (dice.chance(0.95)) v = dice.magnitude(1e-9, 30) * tangential(dice.direction(), n).normalized();
    const bool stands = v.norm() == 0 && holds(footing, mu);
    if (stands) continue;
    const double before = 0.5 * v.squared_norm();
    for (const bool is_stepped : {true, false}) {
      const Leg leg = (is_stepped ? stepped_leg : closed_form_leg)(Vec3{}, v, Vec3{}, footing, mu, dt);
      const double t = std::isfinite(leg.duration) ? leg.duration : dice.magnitude(1e-3, 10);
      const double after = 0.5 * velocity_at(leg, t).squared_norm() - gravity.dot(leg.path.at(t));
      ASSERT_LE(after, before + 1e-12 * (1 + before + leg.path.at(t).norm() * 10))
          << (is_stepped ? "stepped" : "closed form") << " n " << n << " mu " << mu << " dt " << dt << " v " << v;
      ASSERT_LT(std::abs(leg.path.at(t).dot(n)), 1e-11 * (1 + leg.path.at(t).norm()));
    }
  }
}

}  // namespace
}  // namespace talus::sliding_test
