#include "talus/rocks/elliptic.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/dice.hpp"

namespace talus::elliptic_test {
namespace {

using namespace testing_tools;

double quarter_period(double m1) { return elliptic_f(1, 0, m1); }

// The standard library's integrals are an independent implementation.
TEST(Elliptic, TheIntegralAgreesWithTheStandardLibrary) {
  Dice dice(1);
  for (int i = 0; i < 5000; ++i) {
    const double k = dice.between(0, 0.999), am = dice.between(-1.57, 1.57), f = std::ellint_1(k, am);
    EXPECT_NEAR(elliptic_f(std::sin(am), std::cos(am), 1 - k * k), f, 1e-13 * (1 + std::abs(f)));
  }
}

TEST(Elliptic, JacobiFunctionsInvertTheIntegral) {
  Dice dice(2);
  for (int i = 0; i < 5000; ++i) {
    const double m1 = dice.magnitude(1e-12, 1), m = 1 - m1, am = dice.between(-1.57, 1.57);
    const ThetaSeries series(m, m1);
    const double u = elliptic_f(std::sin(am), std::cos(am), m1);
    const int half_periods = static_cast<int>(dice.between(-20, 20));
    const double sign = half_periods % 2 == 0 ? 1 : -1;
    const auto at = series.at(series.rate() * u + std::numbers::pi * half_periods);
    const double norm = std::hypot(at.sn, at.cn) * sign;
    EXPECT_NEAR(at.sn / norm, std::sin(am), 1e-11);
    EXPECT_NEAR(at.cn / norm, std::cos(am), 1e-11);
    EXPECT_NEAR(at.dn / norm * sign, std::sqrt(m1 + m * std::cos(am) * std::cos(am)), 1e-11);
    EXPECT_NEAR(series.rate() * quarter_period(m1), std::numbers::pi / 2, 1e-13);
  }
}

// Pi(n; am | m) = u + S (arg theta4(z + i y) - u Z) with n = -m tan^2 b, y of F(b | 1 - m), S = sin b cos b / dn; and
// by half a period of theta4 the same with theta1.
TEST(Elliptic, ThetaFunctionsGiveTheIntegralOfTheThirdKind) {
  Dice dice(3);
  for (int i = 0; i < 5000; ++i) {
    const double k = dice.between(0.01, 0.999), m = k * k, m1 = 1 - m, b = dice.between(0.01, 1.56);
    const double am = dice.between(-1.57, 1.57), u = std::ellint_1(k, am);
    const double expected = std::ellint_3(k, -m * std::tan(b) * std::tan(b), am);
    ThetaSeries series(m, m1);
    const double y = series.rate() * elliptic_f(std::sin(b), std::cos(b), m);
    const double s = std::sin(b) * std::cos(b) / std::sqrt(m + m1 * std::cos(b) * std::cos(b));
    const double z = series.rate() * u;
    double arg = 0, zeta = 0;
    if (y < 0.5 * series.half_height()) {
      series.take_theta4(y);
      const auto at = series.at(z);
      arg = std::atan2(at.im, at.re);
      zeta = series.zeta(y);
    } else {  // theta4(z + i y) has the argument of i exp(-i z) theta1(z - i rest)
      const double rest = series.half_height() - y;
      series.take_theta1(rest);
      const auto at = series.at(z);
      arg = std::remainder(std::atan2(at.im, at.re) + 0.5 * std::numbers::pi - z, 2 * std::numbers::pi);
      zeta = 1 / s - series.rate() - series.zeta(rest);
    }
    EXPECT_NEAR(u + s * (arg - u * zeta), expected, 1e-11 * (1 + std::abs(expected)));
  }
}

TEST(Elliptic, WithoutModulusTheyAreSineAndCosine) {
  const ThetaSeries circle(0, 1);
  EXPECT_EQ(circle.rate(), 1);
  for (const double u : {-7.0, 0.0, 0.3, 2.0, 11.0}) {
    EXPECT_NEAR(circle.at(u).sn, std::sin(u), 1e-15);
    EXPECT_NEAR(circle.at(u).cn, std::cos(u), 1e-15);
    EXPECT_NEAR(circle.at(u).dn, 1, 1e-15);
  }
}

// The period 4 K of a pendulum at a right angle, k^2 = 1/2, is 7.41629870920549.
TEST(Elliptic, FullPeriod) { EXPECT_NEAR(4 * quarter_period(0.5), 7.41629870920549, 1e-13); }

}  // namespace
}  // namespace talus::elliptic_test
