#include "talus/rocks/parabola.hpp"

#include <gtest/gtest.h>

namespace talus::parabola_test {
namespace {

// Section 2.3 of the manual: from (0, 0, 20) at 3 m/s, g = 9.81, at t = 1.100246 s.
TEST(Parabola, FirstFlightOfTheManual) {
  const Parabola path{{0, 0, 20}, {3, 0, 0}, {0, 0, -9.81}};
  EXPECT_LT((path.at(1.100246) - Vec3(3.300738, 0, 14.06229)).norm(), 1e-5);
  EXPECT_LT((path.velocity(1.100246) - Vec3(3, 0, -10.7934)).norm(), 2e-5);
}

TEST(Parabola, IncludesTheVerticalVelocityTerm) {
  const Parabola path{{1, 2, 3}, {4, 5, 6}, {0, 0, -10}};
  EXPECT_EQ(path.at(2), Vec3(9, 12, -5));
  EXPECT_EQ(path.z(2), -5);
  EXPECT_EQ(path.velocity(2), Vec3(4, 5, -14));
}

TEST(Parabola, EnergyIsConstant) {
  const Parabola path{{1, 2, 300}, {40, -5, 6}, {0, 0, -standard_gravity}};
  const auto energy = [&](double t) {
    return 0.5 * path.velocity(t).squared_norm() + standard_gravity * path.at(t).z();
  };
  for (const double t : {0.1, 1.0, 5.0, 30.0}) EXPECT_NEAR(energy(t), energy(0), 1e-12 * 4000);
}

}  // namespace
}  // namespace talus::parabola_test
