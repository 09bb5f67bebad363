// Regular polygons that roll down a plane without slip or rebound: rimless wheels, whose motion has a closed form.
//
//   k = I / (m R^2) = (2 + cos 2a) / 6 of a homogeneous polygon with n corners at R, a = pi / n
//   eta = (k + cos 2a) / (1 + k)                                     of its rate remains when a corner comes down
//   w = sqrt(eta^2 / (1 - eta^2) 4 g sin a sin s / (R (1 + k)))      its steady rate just after that, on a slope s
//   w >= sqrt(2 g (1 - cos(a - s)) / (R (1 + k)))                    to turn over that corner and roll on
//   (w / eta)^2 R < g cos(a + s)                                     not to lift off before the next comes down
//
// Source: T. McGeer, "Passive dynamic walking", International Journal of Robotics Research 9 (1990), section 2; numbers
// evaluated by another program.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "support/meshes.hpp"
#include "support/scenes.hpp"
#include "talus/core/degrees.hpp"
#include "talus/meshing/rock_shape.hpp"
#include "talus/terrain/profile.hpp"

namespace talus::wheels_test {
namespace {

using namespace testing_tools;

constexpr double g = 9.81;

struct Wheel {
  int sides;
  double radius = 1;  // of its corners [m]

  [[nodiscard]] double a() const { return std::numbers::pi / sides; }
  [[nodiscard]] double k() const { return (2 + std::cos(2 * a())) / 6; }
  [[nodiscard]] double eta() const { return (k() + std::cos(2 * a())) / (1 + k()); }
  [[nodiscard]] double steady_rate(double slope) const {
    const double kept = eta() * eta();
    return std::sqrt(kept / (1 - kept) * 4 * g * std::sin(a()) * std::sin(slope) / (radius * (1 + k())));
  }
  [[nodiscard]] double least_rate(double slope) const {
    return std::sqrt(2 * g * (1 - std::cos(a() - slope)) / (radius * (1 + k())));
  }
  [[nodiscard]] double area() const { return 0.5 * sides * radius * radius * std::sin(2 * a()); }
  /// As long as the root of its area.
  [[nodiscard]] Rock rock() const { return sphere_of_mass(2700 * std::pow(area(), 1.5), 2700); }
};

struct Rolled {
  RockOutcome outcome;
  std::vector<double> rates;  // just after each impact [rad/s]
};

Laws laws_of(double timestep, double max_time, bool in_section) {
  Laws laws;
  set_model(laws, RockModel::rigid_sphere);
  laws.gravity = {0, 0, -g};
  laws.stopped_velocity = 0.01;
  laws.timestep = timestep;
  laws.max_time = max_time;
  laws.in_section = in_section;
  return laws;
}

/// From a turn about its lower corner with `rate` just after that came down, for a time.
Rolled roll(const Wheel& wheel, double slope, double rate, double timestep, double max_time, bool in_section = false) {
  const double far = 1000, drop = std::tan(slope) * far;
  const std::vector<Vec2> outline = regular_outline(wheel.sides);
  const RockShape shape = in_section ? section_shape(outline) : prism_shape(outline);
  Release release;
  release.rock = wheel.rock();
  release.shape = &shape;
  const Orientation downhill = Orientation::of_turn({0, slope, 0});
  release.orientation = downhill * shape.as_given;
  release.motion.position = downhill.to_world({0, 0, wheel.radius * std::cos(wheel.a()) + 1e-9});
  release.motion.spin = {0, rate, 0};
  release.motion.velocity =
      release.motion.spin.cross(wheel.radius * downhill.to_world({-std::sin(wheel.a()), 0, std::cos(wheel.a())}));
  const Laws laws = laws_of(timestep, max_time, in_section);
  const Ground ground = ground_of({.rn = 0, .rt = 0, .mu = 10, .rolling = 0});
  RockLog log(false);
  log.keep_impacts(true);
  Rolled rolled;
  const Draws draws(SamplingPlan{}, 0);
  if (in_section) {
    const Profile line(std::vector<Vec2>{{-far, drop}, {far, -drop}});
    rolled.outcome = follow_rock(Scene<Profile>{line, ground, {}, laws}, release, draws, log);
  } else {
    const Shape two{{{-far, -far, drop}, {far, -far, -drop}, {far, far, -drop}, {-far, far, drop}},
                    {{0, 1, 2}, {0, 2, 3}}};
    const TriangleMesh plane = two.mesh();
    rolled.outcome = follow_rock(Scene<TriangleMesh>{plane, ground, {}, laws}, release, draws, log);
  }
  const double moment = wheel.k() * wheel.radius * wheel.radius * release.rock.mass;
  for (const Impact& impact : log.impacts)
    rolled.rates.push_back(
        std::copysign(impact.after.spin.norm() * std::sqrt(release.rock.inertia / moment), impact.after.spin.y()));
  return rolled;
}

struct Known {
  int sides;
  double eta, least_slope, lift_off_slope, slope, rate;  // [deg], [rad/s]
};
const std::vector<Known> known{{5, 0.50103628, 12.329, 15.82, 15, 1.20202}, {6, 0.64705882, 6.572, 16.47, 15, 1.60676},
                               {8, 0.79816955, 2.558, 15.69, 15, 2.16824},  {12, 0.90933394, 0.716, 12.64, 5, 1.69154},
                               {24, 0.97719755, 0.0866, 7.17, 2, 1.59172},  {48, 0.99429115, 0.0107, 3.71, 2, 2.27813}};

// The equations above give the numbers of the table: what the motions below are compared with.
TEST(Wheels, HaveTheComputedRatesAndSlopes) {
  for (const Known& one : known) {
    const Wheel wheel{one.sides};
    EXPECT_NEAR(wheel.eta(), one.eta, 0.6e-8);
    EXPECT_NEAR(wheel.steady_rate(one.slope * radians), one.rate, 0.6e-5);
    const double least = one.least_slope * radians, lift_off = one.lift_off_slope * radians;
    EXPECT_NEAR(wheel.steady_rate(least) / wheel.least_rate(least), 1, 0.005);
    EXPECT_NEAR(std::pow(wheel.steady_rate(lift_off) / wheel.eta(), 2), g * std::cos(wheel.a() + lift_off), 0.02);
  }
}

class SteadyWheels : public testing::TestWithParam<Known> {};

// In ten impacts in a row. A corner strikes when it is within 0.1 mm of the ground, and what it has not fallen then is
// lost. Where a side wins little, 2 R sin a sin s, that makes wheels of 1 m too slow, whatever the timestep is: by 0.4
// % with 24 corners and 0.6 % with 48. (0.15 % if corners strike within 0.01 mm.) Wheels of 10 m show it less.
TEST_P(SteadyWheels, RollAtTheComputedRate) {
  const Known& one = GetParam();
  const Wheel wheel{one.sides}, large{one.sides, 10};
  const double height = 2 * std::sin(wheel.a()) * std::sin(one.slope * radians),
               early = std::min(0.5 * 1e-4 / height, 0.006);
  const auto rates = [&](const Wheel& of, double timestep, bool in_section) {
    const double slope = one.slope * radians;
    const Rolled rolled =
        roll(of, slope, 0.95 * of.steady_rate(slope), timestep, 25 * std::sqrt(of.radius), in_section);
    EXPECT_EQ(rolled.outcome.reason, EndReason::maximum_time);
    EXPECT_GT(rolled.rates.size(), 20U);
    EXPECT_LT(std::abs(rolled.outcome.end.position.y()), 1e-5);
    double least = std::numeric_limits<double>::infinity(), most = 0;
    for (std::size_t i = 0; i < std::min<std::size_t>(10, rolled.rates.size()); ++i) {
      const double share = rolled.rates[rolled.rates.size() - 1 - i] / of.steady_rate(slope);
      least = std::min(least, share);
      most = std::max(most, share);
    }
    return std::pair(least, most);
  };
  for (const bool in_section : {false, true}) {
    const auto [least, most] = rates(wheel, 0.0005, in_section);
    EXPECT_GT(least, 1 - 0.0005 - early);
    EXPECT_LT(most, 1.001);
    // Steps of the default length are of first order.
    const auto [least_by_default, most_by_default] = rates(wheel, Laws().timestep, in_section);
    EXPECT_GT(least_by_default, 0.945);
    EXPECT_LT(most_by_default, 1.025);
  }
  const auto [least, most] = rates(large, 0.0005, false);
  EXPECT_GT(least, 0.9985);
  EXPECT_LT(most, 1.001);
}
INSTANTIATE_TEST_SUITE_P(Wheels, SteadyWheels, testing::ValuesIn(known),
                         [](const auto& each) { return "With" + std::to_string(each.param.sides) + "Corners"; });

// With 24 and 48 corners the slopes are so small that a side wins 0.02 mm and less, and corners come down more slowly
// than the cutoff: this takes short steps. With the default step such wheels need 0.17 and 0.2 degrees.
TEST(Wheels, StopBelowTheLeastSlopeAndRollOnAboveIt) {
  for (const Known& one : known) {
    const Wheel wheel{one.sides};
    const bool is_round = one.sides > 12;
    for (const double share : {is_round ? 0.8 : 0.95, is_round ? 1.25 : 1.05}) {
      const double least = one.least_slope * radians;
      const Rolled rolled = roll(wheel, share * least, 1.02 * wheel.steady_rate(std::max(share, 1.0) * least),
                                 is_round ? 0.0005 : Laws().timestep, is_round ? 100 : 60, is_round);
      EXPECT_EQ(rolled.outcome.reason, share < 1 ? EndReason::at_rest : EndReason::maximum_time)
          << one.sides << " corners, " << share << " of the least slope";
    }
  }
}

}  // namespace
}  // namespace talus::wheels_test
