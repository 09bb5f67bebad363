#include "talus/terrain/slope.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include "support/dice.hpp"

namespace talus::slope_test {
namespace {

using namespace testing_tools;

template <class Height>
double slope_at(Height&& height, double x, double y, double dx, double dy) {
  std::array<double, 9> z{};
  for (int k = 0; k < 9; ++k) z[static_cast<std::size_t>(k)] = height(x + (k % 3 - 1) * dx, y + (k / 3 - 1) * dy);
  return slope_of_gradient_squared(horn_gradient_squared(z, dx, dy));
}

TEST(HornSlope, OfAPlaneIsExact) {
  Dice dice(4);
  for (int round = 0; round < 200; ++round) {
    const double a = dice.between(-3, 3), b = dice.between(-3, 3), c = dice.between(-1000, 1000);
    const auto plane = [&](double x, double y) { return c + a * x + b * y; };
    EXPECT_NEAR(slope_at(plane, 10, 20, dice.between(0.5, 10), dice.between(0.5, 10)), std::atan(std::hypot(a, b)),
                1e-11);
  }
}

// On a sphere of radius R the slope at a distance r from the axis is asin(r / R); halving the cells quarters the error.
TEST(HornSlope, OfASphereConvergesAtSecondOrder) {
  constexpr double radius = 100;
  const auto sphere = [](double x, double y) { return std::sqrt(radius * radius - x * x - y * y); };
  for (const double r : {20.0, 50.0, 70.0}) {
    for (const double azimuth : {0.0, 0.6, 2.2}) {
      const double x = r * std::cos(azimuth), y = r * std::sin(azimuth), exact = std::asin(r / radius);
      double before = std::abs(slope_at(sphere, x, y, 4, 4) - exact);
      for (const double cell : {2.0, 1.0, 0.5}) {
        const double error = std::abs(slope_at(sphere, x, y, cell, cell) - exact);
        EXPECT_NEAR(before / error, 4, 0.4) << r << ' ' << cell;
        before = error;
      }
      EXPECT_LT(before, 1e-4);
    }
  }
}

TEST(HornSlope, WithoutDataIsNaN) {
  for (std::size_t k = 0; k < 9; ++k) {
    std::array<double, 9> z{};
    z[k] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(std::isnan(horn_gradient_squared(z, 1, 1))) << k;
  }
}

}  // namespace
}  // namespace talus::slope_test
