// Drag along the ground: legs of each law, compared to dv/dt = c - k v.

#include "talus/sliding/drag.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "talus/sliding/closed_form.hpp"
#include "talus/sliding/rolling.hpp"
#include "talus/sliding/stepped.hpp"

namespace talus::sliding_drag_test {
namespace {

const Vec3 gravity(0, 0, -standard_gravity);
constexpr double slope = 0.5;  // [rad], falls along x
const Vec3 normal(std::sin(slope), 0, std::cos(slope));
const Vec3 downhill(std::cos(slope), 0, -std::sin(slope));
const Footing footing = Footing::on_plane(gravity, normal);

struct State {
  Vec3 position, velocity, spin;
  double time = 0;
};

// Leg after leg for `longest`, or to a standstill; make(state, footing, timestep) is the law.
template <class Law>
State go(const Law& law, State state, double rate, double timestep, double longest, bool rolls = false) {
  while (state.time < longest * (1 - 1e-12)) {
    const double allowed = dragged_timestep(rate, timestep, footing.pull, state.velocity);
    const double step = std::min(allowed, longest - state.time);
    const Leg leg =
        cut_short(law(state, dragged(footing, state.velocity, rate, step, rolls ? 5.0 / 7 : 1), step), step);
    state.position = leg.path.at(leg.duration);
    state.velocity = leg.end_velocity;
    state.spin = leg.end_spin;
    state.time += leg.duration;
    if (state.velocity.norm() == 0) break;
  }
  return state;
}

constexpr double mu = 0.3;
const auto stepped = [](const State& s, const Footing& f, double dt) {
  return stepped_leg(s.position, s.velocity, s.spin, f, mu, dt);
};
const auto closed = [](const State& s, const Footing& f, double dt) {
  return closed_form_leg(s.position, s.velocity, s.spin, f, mu, dt);
};

struct Exact {
  double speed, way;
};
// dv/dt = c - k v from v0.
Exact exact(double c, double k, double v0, double t) {
  const double gone = (1 - std::exp(-k * t)) / k;
  return {v0 * std::exp(-k * t) + c * gone, v0 * gone + c / k * (t - gone)};
}

const double c_sliding = standard_gravity * (std::sin(slope) - mu * std::cos(slope));

TEST(GroundDrag, TheVelocityOfASlideIsTheClosedForm) {
  for (const double rate : {0.01, 0.3, 0.9, 5.0, 80.0}) {
    for (const double v0 : {0.5, 12.0}) {
      const State start{Vec3{}, v0 * downhill, {1, 2, 3}, 0};
      const Exact expected = exact(c_sliding, rate, v0, 3);
      const State a = go(stepped, start, rate, 0.01, 3), b = go(closed, start, rate, 0.01, 3);
      EXPECT_NEAR(a.velocity.dot(downhill), expected.speed, 1e-12 * (1 + v0)) << rate;
      EXPECT_NEAR(b.velocity.dot(downhill), expected.speed, 1e-12 * (1 + v0)) << rate;
      EXPECT_EQ(a.spin, Vec3(1, 2, 3));
    }
  }
}

// The stepped law moves with the velocity at the end of the step: first order. The closed form is second order.
TEST(GroundDrag, TheDistanceOfASlideConverges) {
  const State start{Vec3{}, 12 * downhill, Vec3{}, 0};
  const Exact expected = exact(c_sliding, 0.9, 12, 3);
  const auto error = [&](const auto& law, double timestep) {
    return std::abs(go(law, start, 0.9, timestep, 3).position.dot(downhill) - expected.way);
  };
  EXPECT_NEAR(error(stepped, 0.02) / error(stepped, 0.01), 2, 0.05);
  EXPECT_NEAR(error(closed, 0.02) / error(closed, 0.01), 4, 0.05);
  EXPECT_LT(error(closed, 0.01), 2e-4);
}

TEST(GroundDrag, TerminalSpeedDownAPlane) {
  const State a = go(closed, {Vec3{}, 30 * downhill, Vec3{}, 0}, 0.5, 0.01, 80);
  EXPECT_NEAR(a.velocity.dot(downhill), c_sliding / 0.5, 1e-11);
}

// Uphill, friction and gravity also brake: T = ln(1 + k v0/c)/k, distance v0/k - c/k^2 ln(1 + k v0/c).
TEST(GroundDrag, StopsInTheTimeAndDistanceOfTheClosedForm) {
  const double k = 0.7, v0 = 8, c = standard_gravity * (std::sin(slope) + mu * std::cos(slope));
  const double time = std::log1p(k * v0 / c) / k, way = v0 / k - c / (k * k) * std::log1p(k * v0 / c);
  const State start{Vec3{}, -v0 * downhill, Vec3{}, 0};
  const State a = go(stepped, start, k, 0.001, 10), b = go(closed, start, k, 0.001, 10);
  EXPECT_EQ(b.velocity.norm(), 0);
  EXPECT_NEAR(b.time, time, 1e-6);
  EXPECT_NEAR(-b.position.dot(downhill), way, 1e-6);
  EXPECT_NEAR(a.time, time, 1e-3);
  EXPECT_NEAR(-a.position.dot(downhill), way, 5e-3);
}

// Without slip the spin has a share: 7/5 dv/dt = c - k v.
TEST(GroundDrag, ARollingSphereIsBrakedByFiveSevenths) {
  const Rock rock = sphere_of_diameter(1, 2700);
  const ContactFriction friction{0.6, 0.05};
  const auto rolling = [&](const State& s, const Footing& f, double dt) {
    return rolling_leg(s.position, s.velocity, s.spin, normal, f, rock, friction, dt);
  };
  const double v0 = 6, rate = 0.8;
  State start{Vec3{}, v0 * downhill, Vec3{}, 0};
  start.spin = rolling_spin(start.velocity, start.spin, normal, rock.radius);
  const double c = 5.0 / 7 * standard_gravity * (std::sin(slope) - friction.rolling * std::cos(slope));
  const Exact expected = exact(c, 5.0 / 7 * rate, v0, 2);
  const State end = go(rolling, start, rate, 0.01, 2, true);
  EXPECT_NEAR(end.velocity.dot(downhill), expected.speed, 1e-11);
  EXPECT_NEAR(end.position.dot(downhill), expected.way, 2e-4);
  EXPECT_LT((end.spin - rolling_spin(end.velocity, end.spin, normal, rock.radius)).norm(), 1e-9);
}

TEST(GroundDrag, NeverReversesTheMotion) {
  for (const double rate : {1.0, 50.0, 1e4}) {
    State state{Vec3{}, Vec3(3, 2, 0), Vec3{}, 0};
    const Footing level = Footing::on_plane(gravity, unit_z);
    for (int k = 0; k < 200 && state.velocity.norm() > 1e-9; ++k) {
      const double step = dragged_timestep(rate, 0.01, Vec3{}, state.velocity);
      const Leg leg = stepped_leg(state.position, state.velocity, state.spin,
                                  dragged(level, state.velocity, rate, step, 1), 0.2, step);
      EXPECT_LE(leg.end_velocity.norm(), state.velocity.norm());
      EXPECT_GE(leg.end_velocity.dot(state.velocity), 0);
      state.velocity = leg.end_velocity;
    }
  }
}

}  // namespace
}  // namespace talus::sliding_drag_test
