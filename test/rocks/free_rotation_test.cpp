// The exact rotation of a body against numerical integration and computed periods.

#include "talus/rocks/attitude.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "support/dice.hpp"

namespace talus::free_rotation_test {
namespace {

using namespace testing_tools;

/// Euler's equations and the orientation, by Runge and Kutta's method of fourth order.
class Integrated {
 public:
  Integrated(const Vec3& inertia, const Orientation& q, const Vec3& body_spin)
      : inertia_(inertia), now_{q.w(), q.xyz(), body_spin} {}

  void step(double dt) {
    const Rates k1 = rates(now_), k2 = rates(moved(k1, dt / 2)), k3 = rates(moved(k2, dt / 2)),
                k4 = rates(moved(k3, dt));
    now_.w += dt / 6 * (k1.w + 2 * k2.w + 2 * k3.w + k4.w);
    now_.v += dt / 6 * (k1.v + 2 * k2.v + 2 * k3.v + k4.v);
    now_.spin += dt / 6 * (k1.spin + 2 * k2.spin + 2 * k3.spin + k4.spin);
  }
  [[nodiscard]] Orientation orientation() const { return {now_.w, now_.v.x(), now_.v.y(), now_.v.z()}; }
  [[nodiscard]] Vec3 spin() const { return orientation().to_world(now_.spin); }

 private:
  struct Rates {
    double w;
    Vec3 v, spin;
  };
  [[nodiscard]] Rates moved(const Rates& k, double dt) const {
    return {now_.w + dt * k.w, now_.v + dt * k.v, now_.spin + dt * k.spin};
  }
  [[nodiscard]] Rates rates(const Rates& at) const {
    const Vec3 moment = inertia_.times(at.spin).cross(at.spin);
    return {-0.5 * at.v.dot(at.spin), 0.5 * (at.w * at.spin + at.v.cross(at.spin)),
            Vec3{moment[0] / inertia_[0], moment[1] / inertia_[1], moment[2] / inertia_[2]}};
  }

  Vec3 inertia_;
  Rates now_;
};

Vec3 random_inertia(Dice& dice) {
  // Of a box, and sometimes of a square or a cube.
  Vec3 size(dice.between(0.2, 2), dice.between(0.2, 2), dice.between(0.2, 2));
  if (dice.chance(0.25)) size[1] = size[0];
  if (dice.chance(0.25)) size[2] = size[1];
  const Vec3 s = size.times(size);
  return {s[1] + s[2], s[0] + s[2], s[0] + s[1]};
}

Orientation random_orientation(Dice& dice) {
  return Orientation::of_turn(dice.between(0, std::numbers::pi) * dice.direction());
}

TEST(FreeRotation, AgreesWithNumericalIntegration) {
  Dice dice(1);
  for (int i = 0; i < 200; ++i) {
    const Vec3 inertia = random_inertia(dice);
    const Orientation start = random_orientation(dice);
    const Vec3 spin = dice.in_cube(6);
    const FreeRotation rotation(inertia, start, spin);
    Integrated integrated(inertia, start, start.to_body(spin));
    constexpr double duration = 4;
    constexpr int steps = 8000;
    for (int k = 0; k < steps; ++k) integrated.step(duration / steps);
    const auto [orientation, spin_then] = rotation.at(duration);
    EXPECT_LT(angle_between(orientation, integrated.orientation()), 1e-9) << inertia << spin;
    EXPECT_LT((spin_then - integrated.spin()).norm(), 1e-8) << inertia << spin;
  }
}

TEST(FreeRotation, KeepsEnergyAndAngularMomentum) {
  Dice dice(2);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 inertia = random_inertia(dice);
    const Orientation start = random_orientation(dice);
    const Vec3 spin = dice.magnitude(1e-3, 50) * dice.direction();
    const FreeRotation rotation(inertia, start, spin);
    const auto momentum = [&](const Orientation& q, const Vec3& w) { return q.to_world(inertia.times(q.to_body(w))); };
    const Vec3 before = momentum(start, spin);
    const auto [orientation, then] = rotation.at(dice.between(0, 20));
    EXPECT_LT((momentum(orientation, then) - before).norm(), 1e-12 * before.norm());
    EXPECT_NEAR(momentum(orientation, then).dot(then), before.dot(spin), 1e-11 * before.dot(spin));
    const auto [first, at_start] = rotation.at(0);
    EXPECT_LT(angle_between(first, start), 1e-11);
    EXPECT_LT((at_start - spin).norm(), 1e-11 * spin.norm());
  }
}

TEST(FreeRotation, GoesOnFromAnyTime) {
  Dice dice(3);
  for (int i = 0; i < 500; ++i) {
    const Vec3 inertia = random_inertia(dice);
    const FreeRotation whole(inertia, random_orientation(dice), dice.in_cube(10));
    const auto half = whole.at(1.3), end = whole.at(3.1);
    const auto again = FreeRotation(inertia, half.orientation, half.spin).at(1.8);
    EXPECT_LT(angle_between(again.orientation, end.orientation), 1e-9);
  }
}

// A box of 3 x 2 x 1 m that spins almost about its intermediate axis: R. Leine et al. (2021), doi
// 10.1007/s11044-021-09792-y. It turns over again and again. The moments are those of Jacobi's functions in 30 digits.
TEST(FreeRotation, TurnsOverAboutTheIntermediateAxis) {
  const FreeRotation rotation({5.0 / 12, 5.0 / 6, 13.0 / 12}, {}, {0.001, 10, 0.001});
  const auto along_intermediate = [&](double t) {
    const auto [orientation, spin] = rotation.at(t);
    return orientation.to_body(spin).y();
  };
  double before = 10;
  for (const double turn : {2.46533736, 6.93788122, 11.41042508, 15.88296893, 20.35551279}) {
    double low = turn - 0.5, high = turn + 0.5;
    ASSERT_LT(before * along_intermediate(high), 0);
    before = along_intermediate(high);
    for (int i = 0; i < 40; ++i) {
      const double middle = 0.5 * (low + high);
      (along_intermediate(low) * along_intermediate(middle) > 0 ? low : high) = middle;
    }
    EXPECT_NEAR(low, turn, 0.6e-8);
  }
}

// After a period the body spins about the same axis of its own as before: to the last digit of the period.
TEST(FreeRotation, HasTheComputedPeriods) {
  struct Known {
    Vec3 inertia, spin;
    double period;
  };
  const Vec3 slab(5.0 / 12, 5.0 / 6, 13.0 / 12);
  for (const auto& [inertia, spin, period] :
       {Known{{1, 2, 3}, {1, 1, 1}, 6.422703084}, Known{slab, {0.1, 10, 0.1}, 5.110152307},
        Known{slab, {0.001, 10, 0.001}, 8.945087716}, Known{{70.577, 70.577, 112.437}, {1, 0, 20}, 0.52968033}}) {
    const FreeRotation rotation(inertia, {}, spin);
    const auto in_body = [&](double t) {
      const auto [orientation, now] = rotation.at(t);
      return orientation.to_body(now);
    };
    const double last_digit = period > 1 ? 1e-9 : 1e-8;
    const double rate = inertia.times(spin).cross(spin).norm() / inertia.x();  // of change, at most [rad/s2]
    EXPECT_LT((in_body(period) - spin).norm(), rate * last_digit + 1e-10) << period;
    EXPECT_GT((in_body(0.999 * period) - spin).norm(), 100 * rate * last_digit) << period;
  }
}

// EOTA's body 221, 0.93 x 0.93 x 0.47 m and 780 kg: a disc that wobbles, 31.87791 rad/s around at 1.7976455 degrees.
TEST(FreeRotation, ADiscWobblesAsComputed) {
  const Vec3 inertia(70.577, 70.577, 112.437), spin(1, 0, 20);
  const FreeRotation rotation(inertia, {}, spin);
  const Vec3 momentum = inertia.times(spin), axis = momentum.normalized();
  EXPECT_NEAR(momentum.norm() / inertia.x(), 31.87791, 1e-5);
  const double turn = 2 * std::numbers::pi / 31.87791;
  for (const double share : {0.25, 0.5, 0.75, 1.0}) {
    const Vec3 of_disc = rotation.at(share * turn).orientation.to_world(unit_z);
    EXPECT_NEAR(std::acos(of_disc.dot(axis)), 1.7976455 * std::numbers::pi / 180, 1e-8);
    const Vec3 start = tangential(unit_z, axis), now = tangential(of_disc, axis);
    EXPECT_NEAR(now.dot(start), start.squared_norm() * std::cos(2 * std::numbers::pi * share), 1e-9);
  }
}

// The largest moment: what spins about it stays there. An explicit scheme leaves it within ten seconds.
TEST(FreeRotation, StaysAboutTheMajorAxis) {
  const FreeRotation rotation({5.0 / 12, 5.0 / 6, 13.0 / 12}, {}, {0.001, 0.001, 10});
  for (const double t : {1.0, 5.0, 20.0, 100.0}) {
    EXPECT_LT((rotation.at(t).spin - Vec3(0, 0, 10)).norm(), 0.005);
  }
}

TEST(FreeRotation, WithoutSpinOrAsASphereIsSteady) {
  const Orientation start = Orientation::of_turn({0.3, -0.2, 1});
  EXPECT_EQ(FreeRotation({1, 2, 3}, start, Vec3{}).at(7).orientation, start);
  const Vec3 spin(1, -2, 0.5);
  EXPECT_EQ(FreeRotation({2, 2, 2}, start, spin).at(7).spin, spin);
}

TEST(FreeRotation, MomentsThatDifferByRoundingAreEqual) {
  const Vec3 spin(3, -1, 2);
  const FreeRotation cube({0.25, 0.25 + 1e-16, 0.25 - 1e-16}, Orientation::of_turn({0.3, 0.2, 0.1}), spin);
  for (const double t : {0.1, 1.0, 10.0}) EXPECT_EQ(cube.at(t).spin, spin);
}

}  // namespace
}  // namespace talus::free_rotation_test
