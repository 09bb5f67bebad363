#include "talus/core/orientation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/dice.hpp"

namespace talus::orientation_test {
namespace {

using namespace testing_tools;

void expect_near(const Vec3& value, const Vec3& expected) {
  EXPECT_LT((value - expected).norm(), 1e-12) << value << " expected " << expected;
}

TEST(Orientation, TurnsAboutAVectorByItsLength) {
  const auto quarter = Orientation::of_turn({0, 0, std::numbers::pi / 2});
  expect_near(quarter.to_world(unit_x), unit_y);
  expect_near(quarter.to_body(unit_y), unit_x);
  EXPECT_EQ(Orientation::of_turn(Vec3{}), Orientation{});
}

TEST(Orientation, ProductsTurnOneAfterTheOther) {
  Dice dice(1);
  for (int i = 0; i < 1000; ++i) {
    const auto a = Orientation::of_turn(3 * dice.direction()),
               b = Orientation::of_turn(dice.between(0, 3) * dice.direction());
    const Vec3 v = dice.in_cube(10);
    expect_near((a * b).to_world(v), a.to_world(b.to_world(v)));
    expect_near(a.to_body(a.to_world(v)), v);
    expect_near(a.matrix() * v, a.to_world(v));
  }
}

TEST(Orientation, TensorsKeepTheirPrincipalValues) {
  Dice dice(2);
  for (int i = 0; i < 1000; ++i) {
    const auto turned = Orientation::of_turn(3 * dice.direction());
    const Vec3 principal(dice.between(1, 2), dice.between(1, 2), dice.between(1, 2));
    const Mat3 tensor = in_world(turned, principal);
    expect_near(tensor * turned.to_world(unit_y), principal.y() * turned.to_world(unit_y));
    expect_near(tensor * turned.to_world(unit_z), principal.z() * turned.to_world(unit_z));
  }
}

TEST(Mat3, SolvesWhatItMultiplies) {
  Dice dice(3);
  for (int i = 0; i < 1000; ++i) {
    const Mat3 m = Mat3{{dice.in_cube(1), dice.in_cube(1), dice.in_cube(1)}} + Mat3::diagonal(Vec3::all(4));
    const Vec3 v = dice.in_cube(10);
    expect_near(m.solve(m * v), v);
    expect_near((m * m.transposed()) * v, m * (m.transposed() * v));
  }
  const Vec3 a(1, 2, 3), b(-4, 5, 1);
  expect_near(outer_product(a, b) * unit_y, 5 * a);
}

}  // namespace
}  // namespace talus::orientation_test
