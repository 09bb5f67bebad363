#include "talus/rocks/elliptic.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/dice.hpp"

namespace talus::elliptic_test {
namespace {

using namespace testing_tools;

// The standard library's integrals are an independent implementation.
TEST(Elliptic, IntegralsAgreeWithTheStandardLibrary) {
  Dice dice(1);
  for (int i = 0; i < 5000; ++i) {
    const double k = dice.between(0, 0.999), am = dice.between(-1.57, 1.57), n = -dice.magnitude(1e-3, 100);
    const double f = std::ellint_1(k, am), pi = std::ellint_3(k, n, am);
    EXPECT_NEAR(elliptic_f(am, 1 - k * k), f, 1e-13 * (1 + std::abs(f)));
    EXPECT_NEAR(elliptic_pi(n, am, 1 - k * k), pi, 1e-12 * (1 + std::abs(pi)));
  }
}

TEST(Elliptic, JacobiFunctionsInvertTheIntegralAndGoOnBeyondAQuarter) {
  Dice dice(2);
  for (int i = 0; i < 5000; ++i) {
    const double m1 = dice.magnitude(1e-8, 1), u = dice.between(-60, 60);
    const JacobiFunctions at = JacobiSeries(m1).at(u);
    EXPECT_NEAR(elliptic_f(at.am, m1), u, 1e-12 * 60 / std::sqrt(m1));  // where dn is small, am hardly changes with u
    EXPECT_NEAR(at.sn * at.sn + at.cn * at.cn, 1, 1e-15);
    EXPECT_NEAR(at.dn * at.dn + (1 - m1) * at.sn * at.sn, 1, 1e-15);
  }
}

TEST(Elliptic, WithoutModulusTheyAreSineAndCosine) {
  const JacobiSeries circle(1);
  for (const double u : {-7.0, 0.0, 0.3, 2.0, 11.0}) {
    EXPECT_NEAR(circle.at(u).sn, std::sin(u), 1e-15);
    EXPECT_NEAR(circle.at(u).dn, 1, 1e-15);
    EXPECT_NEAR(elliptic_f(u, 1), u, 1e-14);
  }
}

// The period 4 K of a pendulum at a right angle, k^2 = 1/2, is 7.41629870920549.
TEST(Elliptic, FullPeriod) { EXPECT_NEAR(4 * elliptic_f(std::numbers::pi / 2, 0.5), 7.41629870920549, 1e-13); }

}  // namespace
}  // namespace talus::elliptic_test
