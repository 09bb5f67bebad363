// Linear drag: pieces against the closed form.

#include "talus/rocks/drag.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/dice.hpp"

namespace talus::flight_drag_test {
namespace {

using testing_tools::Dice;

const Vec3 gravity(0, 0, -standard_gravity);

// The closed form in time, as in textbooks; in long double, since it subtracts large numbers.
Vec3 exact_velocity(const Vec3& v0, double rate, double t) {
  const double kept = std::exp(-rate * t);
  return kept * v0 - std::expm1(-rate * t) / rate * gravity;
}
Vec3 exact_place(const Vec3& p0, const Vec3& v0, double rate, double t) {
  const long double k = rate, gone = -std::expm1(-k * t) / k;
  const auto fallen = static_cast<double>((t - gone) / k);
  return p0 + static_cast<double>(gone) * v0 + fallen * gravity;
}

TEST(LinearDrag, BendAgreesWithSeriesAndLogarithm) {
  EXPECT_EQ(bend_of_drag(0), 1);
  EXPECT_NEAR(bend_of_drag(1e-9), 1 + 2e-9 / 3, 1e-18);
  for (const double q : {0.01, 0.05, 0.0999, 0.1, 0.1001, 0.2, 0.25, 0.5, 0.9}) {
    long double sum = 0, power = 1;
    for (int n = 0; n < 4000; ++n, power *= static_cast<long double>(q)) sum += 2 * power / (n + 2);
    EXPECT_NEAR(bend_of_drag(q), static_cast<double>(sum), 4e-14) << q;
  }
}

// Piece after piece, rising and falling: position, velocity and time are those of the closed form, for any length of
// the pieces.
TEST(LinearDrag, PiecesEndOnTheClosedForm) {
  Dice dice(1);
  for (int number = 0; number < 200; ++number) {
    const LinearDrag drag{dice.magnitude(1e-4, 100), gravity};
    const Vec3 p0 = dice.in_cube(100), v0 = dice.in_cube(30);
    const double part = dice.between(0.1, 3);  // of the length within the tolerance
    Vec3 p = p0, v = v0;
    double t = 0;
    for (int k = 0; k < 50; ++k) {
      const double length = std::min(part * drag.longest_piece(), 0.9 / drag.rate);
      const Parabola piece = drag.piece(p, v, length);
      p = piece.at(length);
      v = drag.velocity(piece, length);
      t += drag.time(length);
    }
    const double scale = 100 + v0.norm() * t;
    EXPECT_LT((p - exact_place(p0, v0, drag.rate, t)).norm(), 2e-12 * scale) << drag.rate;
    EXPECT_LT((v - exact_velocity(v0, drag.rate, t)).norm(), 1e-12 * scale) << drag.rate;
  }
}

// The maximum depth of a piece below the closed form, between its ends; on plan it is exact.
double farthest_below(const LinearDrag& drag, const Vec3& v, double length) {
  const Parabola piece = drag.piece(Vec3{}, v, length);
  double farthest = 0;
  for (int k = 0; k <= 1000; ++k) {
    const double s = length * k / 1000;
    const Vec3 off = exact_place(Vec3{}, v, drag.rate, drag.time(s)) - piece.at(s);
    EXPECT_LT(std::hypot(off.x(), off.y()), 1e-11);
    EXPECT_GT(off.z(), -1e-11);
    farthest = std::max(farthest, off.z());
  }
  return farthest;
}

TEST(LinearDrag, PiecesKeepTheirTolerance) {
  for (const double rate : {1e-3, 0.01, 0.1, 0.5, 1.0, 3.0, 10.0, 100.0}) {
    const LinearDrag drag{rate, gravity};
    const double farthest = farthest_below(drag, {20, -5, 8}, drag.longest_piece());
    EXPECT_LE(farthest, tolerance::drag_piece) << rate;
    // Short enough; and if the tolerance limits the length and not the rate, not much shorter than needed.
    if (rate <= 1) {
      EXPECT_GT(farthest, 0.5 * tolerance::drag_piece) << rate;
    }
  }
}

// Third order: half the length gives an eighth of the error.
TEST(LinearDrag, PiecesConvergeInTheThirdOrder) {
  const LinearDrag drag{0.5, gravity};
  double before = farthest_below(drag, {20, 0, 8}, 0.2);
  for (double length = 0.1; length > 0.01; length /= 2) {
    const double now = farthest_below(drag, {20, 0, 8}, length);
    EXPECT_NEAR(before / now, 8, 6 * length) << length;  // except for higher orders
    before = now;
  }
}

TEST(LinearDrag, TerminalSpeedIsWeightOverDrag) {
  const double mass = 800, b = 500;
  const LinearDrag drag{b / mass, gravity};
  Vec3 p(0, 0, 1000), v(12, 0, 5);
  double t = 0;
  while (t < 60) {
    const double length = drag.longest_piece();
    const Parabola piece = drag.piece(p, v, length);
    p = piece.at(length);
    v = drag.velocity(piece, length);
    t += drag.time(length);
  }
  EXPECT_LT((v - Vec3(0, 0, -mass * standard_gravity / b)).norm(), 1e-12);
}

// Anywhere on a piece, not only at its end: kinetic and potential energy have lost at least the work of the drag.
TEST(LinearDrag, EnergyNeverGrows) {
  Dice dice(2);
  for (int number = 0; number < 2000; ++number) {
    const LinearDrag drag{dice.magnitude(1e-3, 100), gravity};
    const Vec3 v = dice.chance(0.1) ? Vec3{} : dice.in_cube(dice.magnitude(0.01, 40));
    const double length = drag.longest_piece();
    const Parabola piece = drag.piece(Vec3{}, v, length);
    const auto energy = [&](double s) {
      return 0.5 * drag.velocity(piece, s).squared_norm() - gravity.dot(piece.at(s));
    };
    for (int k = 1; k <= 20; ++k) EXPECT_LE(energy(length * k / 20), energy(0) * (1 + 1e-14) + 1e-15);
  }
}

TEST(LinearDrag, WithoutDragIsFreeFlight) {
  const Parabola path{{1, 2, 3}, {4, 5, 6}, gravity};
  const LinearDrag none;
  EXPECT_EQ(none.velocity(path, 0.7), path.velocity(0.7));
  EXPECT_EQ(none.time(0.7), 0.7);
  EXPECT_EQ(none.parameter(0.7), 0.7);
  const LinearDrag little{1e-12, gravity};
  const Parabola piece = little.piece(path.p, path.v, 2);
  EXPECT_LT((piece.at(2) - path.at(2)).norm(), 1e-10);
  EXPECT_LT((little.velocity(piece, 2) - path.velocity(2)).norm(), 1e-10);
  EXPECT_NEAR(little.time(2), 2, 1e-11);
}

TEST(LinearDrag, TimeAndParameterAreInverse) {
  const LinearDrag drag{0.8, gravity};
  for (const double s : {0.0, 1e-9, 0.1, 0.5, 1.2}) EXPECT_NEAR(drag.parameter(drag.time(s)), s, 1e-15);
  EXPECT_LT(drag.parameter(1e9), 1 / drag.rate * (1 + 1e-15));
}

}  // namespace
}  // namespace talus::flight_drag_test
