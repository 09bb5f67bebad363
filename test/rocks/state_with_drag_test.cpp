// A flight with drag at any time: the textbook's form, parabolas, and the speed at which a rock sinks.

#include "talus/rocks/state_with_drag.hpp"

#include <gtest/gtest.h>

#include "support/dice.hpp"

namespace talus::state_with_drag_test {
namespace {

using testing_tools::Dice;

const Vec3 gravity(0, 0, -standard_gravity);

TEST(StateWithDrag, IsTheClosedForm) {
  Dice dice(2);
  for (int number = 0; number < 500; ++number) {
    const double rate = dice.magnitude(1e-3, 1e3), t = dice.magnitude(0.1, 100);
    const Vec3 p = dice.in_cube(100), v = dice.in_cube(30);
    const long double k = rate, gone = -std::expm1(-k * t) / k;
    const Vec3 place = p + static_cast<double>(gone) * v + static_cast<double>((t - gone) / k) * gravity;
    const FlightState state = state_with_drag(p, v, {rate, gravity}, t);
    EXPECT_LT((state.place - place).norm(), 1e-12 * (100 + place.norm())) << rate << " " << t;
    EXPECT_LT((state.velocity - (std::exp(-rate * t) * v + static_cast<double>(gone) * gravity)).norm(), 1e-12 * 100);
  }
}

// The weaker the drag, the nearer to a parabola: to first order in k t by k t (v t/2 + g t^2/6).
TEST(StateWithDrag, IsAParabolaWithoutDrag) {
  const Vec3 p(1, 2, 3), v(4, 5, 6);
  const Parabola path{p, v, gravity};
  for (const double rate : {0.0, 1e-12, 1e-9, 1e-6}) {
    const FlightState state = state_with_drag(p, v, {rate, gravity}, 2);
    const Vec3 held_back = rate * (2 * v + gravity * 8 / 6);
    EXPECT_LT((path.at(2) - held_back - state.place).norm(), 1e-13 + 100 * rate * rate) << rate;
    EXPECT_LT((path.velocity(2) - state.velocity).norm(), 1e-13 + 100 * rate) << rate;
  }
}

TEST(StateWithDrag, SinksAtItsTerminalVelocity) {
  const double rate = 75;
  const FlightState state = state_with_drag(Vec3{}, {3, 0, 4}, {rate, gravity}, 1000);
  EXPECT_NEAR(state.place.x(), 3 / rate, 1e-15);
  EXPECT_NEAR(state.velocity.z(), -standard_gravity / rate, 1e-15);
  EXPECT_NEAR(state.place.z(), 4 / rate - standard_gravity / rate * (1000 - 1 / rate), 1e-10);
}

}  // namespace
}  // namespace talus::state_with_drag_test
