// The end of a flight.

#include "talus/trajectory/flying.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "support/moving_rocks.hpp"
#include "talus/terrain/profile.hpp"

namespace talus::flying_test {
namespace {

using namespace testing_tools;

constexpr double g = standard_gravity;
constexpr double rounding = 1e-12;  // relative error of a few operations

const Profile& level() {
  static const Profile profile(std::vector<Vec2>{{0, 0}, {100, 0}});
  return profile;
}
Motion launched(const Vec3& position, const Vec3& velocity) { return {position, velocity}; }

TEST(Flying, EndsOnTheGroundAtTheTimeOfTheParabola) {
  Laws laws = laws_of(RockModel::lumped_mass);
  laws.impact = PlainImpact{};
  RockOn rock(level(), {.rn = 0.5, .rt = 0.8}, laws, launched({10, 0, 5}, {3, 0, 0}));
  const Phase next = fly(*rock, Flying{});
  const double time = std::sqrt(2 * 5 / g), speed = g * time;
  ASSERT_TRUE(std::holds_alternative<Flying>(next));
  EXPECT_FALSE(std::get<Flying>(next).ground);
  EXPECT_NEAR(rock->motion.time, time, rounding * time);
  EXPECT_NEAR(rock->motion.position.x(), 10 + 3 * time, 20 * rounding);
  EXPECT_NEAR(rock->motion.velocity.x(), 0.8 * 3, 3 * rounding);
  EXPECT_NEAR(rock->motion.velocity.z(), 0.5 * speed, speed * rounding);
  EXPECT_NEAR(rock->max_height, 5, 5 * rounding);
}

TEST(Flying, EndsOnAFacetWithoutNormalRestitution) {
  Laws laws = laws_of(RockModel::lumped_mass);
  laws.impact = PlainImpact{};
  RockOn rock(level(), {.rn = 0, .rt = 0.8, .phi = 0.5}, laws, launched({10, 0, 5}, {3, 0, 0}));
  const Phase next = fly(*rock, Flying{});
  ASSERT_TRUE(std::holds_alternative<OnFacet>(next));
  const OnFacet& state = std::get<OnFacet>(next);
  EXPECT_EQ(state.on.normal, unit_z);
  EXPECT_DOUBLE_EQ(state.friction.mu, std::tan(0.5));
  EXPECT_TRUE(std::holds_alternative<std::monostate>(state.side_contact));
  EXPECT_EQ(rock->motion.velocity.z(), 0);
}

// At 14 degrees: below the default of 15. Speed and spin are kept but for friction, v' = v exp(-mu theta), or with
// rolling resistance, v (1 - 5/7 mu_r theta).
TEST(Flying, AfterAHopMovesOnIfItOnlyGrazesTheGround) {
  const double speed = 10, angle = 14 * std::numbers::pi / 180, phi = 0.4;
  const Vec3 velocity = speed * Vec3(std::cos(angle), 0, -std::sin(angle));
  for (const bool hops : {false, true}) {
    Laws laws = laws_of(RockModel::lumped_mass);
    laws.impact = PlainImpact{};
    RockOn rock(level(), {.rn = 0, .rt = 0.5, .phi = phi}, laws, launched({10, 0, 0}, velocity));
    Flying state;
    if (hops) state.ground = GroundSoFar{{.mu = std::tan(phi)}, MaterialId{0}};
    const Phase next = fly(*rock, state);
    ASSERT_TRUE(std::holds_alternative<OnFacet>(next));
    const double kept = hops ? speed * std::exp(-std::tan(phi) * angle) : 0.5 * velocity.x();
    EXPECT_NEAR(rock->motion.velocity.x(), kept, 10 * rounding) << hops;
    EXPECT_EQ(std::get<OnFacet>(next).friction.mu, std::tan(phi));
  }

  const Rock body = sphere_of_mass(1000, 2700);
  const Vec3 rolling = unit_z.cross(Vec3(speed, 0, 0)) / body.radius;
  RockOn sphere(level(), {.rn = 0.5}, laws_of(RockModel::rigid_sphere), {{10, 0, body.radius}, velocity, rolling},
                body);
  Flying rolled;
  rolled.ground = GroundSoFar{{.sphere = {.dynamic = 0.5, .rolling = 0.3}}, MaterialId{0}};
  ASSERT_TRUE(std::holds_alternative<OnFacet>(fly(*sphere, rolled)));
  const double kept = speed * (1 - 5.0 / 7 * 0.3 * angle);
  EXPECT_NEAR(sphere->motion.velocity.x(), kept, 100 * rounding);
  EXPECT_NEAR(sphere->motion.spin.y() * body.radius, kept, 100 * rounding);
}

TEST(Flying, AfterAHopHasTheFrictionOfOtherGround) {
  const Soil soil{.rn = 0.5, .rt = 0.5, .phi = 0.4};
  const Laws laws = laws_of(RockModel::lumped_mass);
  RockOn rock(level(), soil, laws, launched({10, 0, 0}, {10, 0, -1}));
  Flying state;
  state.ground = GroundSoFar{{.mu = 0.1}, MaterialId{1}};
  const Phase next = fly(*rock, state);
  ASSERT_TRUE(std::holds_alternative<OnFacet>(next));
  EXPECT_DOUBLE_EQ(std::get<OnFacet>(next).friction.mu, std::tan(0.4));
}

TEST(Flying, EndsAtTheEdgeOfTheModelOrAtTheMaximumTime) {
  const Laws laws = laws_of(RockModel::lumped_mass);
  RockOn leaves(level(), {}, laws, launched({99, 0, 5}, {10, 0, 0}));
  const Phase beyond = fly(*leaves, Flying{});
  ASSERT_TRUE(std::holds_alternative<Ended>(beyond));
  EXPECT_EQ(std::get<Ended>(beyond).reason, EndReason::left_model);
  EXPECT_NEAR(leaves->motion.position.x(), 100, 100 * rounding);

  Laws short_time = laws;
  short_time.max_time = 0.25;
  RockOn is_late(level(), {}, short_time, launched({10, 0, 50}, {1, 0, 0}));
  const Phase late = fly(*is_late, Flying{});
  ASSERT_TRUE(std::holds_alternative<Ended>(late));
  EXPECT_EQ(std::get<Ended>(late).reason, EndReason::maximum_time);
  EXPECT_EQ(is_late->motion.time, 0.25);
}

}  // namespace
}  // namespace talus::flying_test
