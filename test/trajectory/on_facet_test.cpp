// A rock on a facet: its legs, and the state at the end of its plane.

#include "talus/trajectory/on_facet.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "support/moving_rocks.hpp"
#include "talus/terrain/profile.hpp"

namespace talus::on_facet_test {
namespace {

using namespace testing_tools;

constexpr double g = standard_gravity;

/// A slope of 3 in 4 down to the origin, then of `grade`.
Profile bend(double grade) { return Profile(std::vector<Vec2>{{-40, 30}, {0, 0}, {40, 40 * grade}}); }
const Vec3 down(0.8, 0, -0.6);  // the first plane's

Laws closed_form() {
  Laws laws = laws_of(RockModel::lumped_mass);
  laws.sliding = SlidingMethod::closed_form;
  laws.impact = PlainImpact{};
  return laws;
}
OnFacet first_facet(const Profile& profile, double mu) {
  return {{{profile.normal(FacetId{0}), FacetId{0}}, {.mu = mu}, {}}};
}

/// A rock at rest, `way` above the bend, with one leg to the end of its facet.
Phase slide_to_the_bend(RockOn<Profile>& rock, const Profile& profile, double mu) {
  OnFacet state = first_facet(profile, mu);
  const auto next = take_leg(*rock, state);
  EXPECT_TRUE(next && !next->is_same_stretch);
  return next ? next->phase : Ended{EndReason::lost};
}

TEST(OnFacet, ASphereMovesALimitedNumberOfRadiiInOneStep) {
  const Profile profile = bend(-2);
  const Rock pebble = sphere_of_diameter(0.005, 2700);
  const Vec3 n = profile.normal(FacetId{0});
  RockOn rock(profile, {.mu = 0.6}, laws_of(RockModel::rigid_sphere, 1e6), {-40 * down + pebble.radius * n, Vec3{}},
              pebble);
  OnFacet state{{{n, FacetId{0}}, {.sphere = {0.6, 0.1}}, {}}};
  for (int k = 0; k < 20; ++k) {
    const Vec3 before = rock->motion.position;
    ASSERT_FALSE(take_leg(*rock, state));
    const double way = (rock->motion.position - before).norm();
    EXPECT_GT(way, 0);
    EXPECT_LE(way, 100 * pebble.radius * (1 + 1e-9));
  }
}

// v^2 = 2 s g (sin - mu cos).
TEST(OnFacet, ReachesTheEndWithTheSpeedFromEnergy) {
  const double way = 20, mu = 0.25;
  const Profile profile = bend(-2);
  RockOn rock(profile, {}, closed_form(), {Vec3(-way * down), Vec3{}});
  const Phase next = slide_to_the_bend(rock, profile, mu);
  const double speed = std::sqrt(2 * way * g * (0.6 - mu * 0.8));
  EXPECT_NEAR(rock->motion.velocity.dot(down), speed, 1e-9);
  EXPECT_NEAR(rock->motion.position.norm(), 0, 1e-9);
  // The ground falls away: it takes off from its facet.
  ASSERT_TRUE(std::holds_alternative<Flying>(next));
  EXPECT_EQ(std::get<Flying>(next).left.count, 1);
  ASSERT_TRUE(std::get<Flying>(next).ground);
  EXPECT_EQ(std::get<Flying>(next).ground->friction.mu, mu);
}

TEST(OnFacet, StrikesRisingGroundAndSlidesOnWithinAPlane) {
  const Profile rising = bend(0.5), straight = bend(-0.75);
  RockOn strikes(rising, {.rn = 0.5, .rt = 1}, closed_form(), {Vec3(-20 * down), Vec3{}});
  const Phase flies = slide_to_the_bend(strikes, rising, 0.25);
  ASSERT_TRUE(std::holds_alternative<Flying>(flies));
  EXPECT_FALSE(std::get<Flying>(flies).ground);
  EXPECT_EQ(strikes->last_contact.with.facet, FacetId{1});

  // Within one plane and one material the leg continues past the vertex to the end of the model.
  RockOn slides(straight, {}, closed_form(), {Vec3(-20 * down), Vec3{}});
  const Phase leaves = slide_to_the_bend(slides, straight, 0.25);
  ASSERT_TRUE(std::holds_alternative<Ended>(leaves));
  EXPECT_EQ(std::get<Ended>(leaves).reason, EndReason::left_model);
  EXPECT_NEAR(slides->motion.position.x(), 40, 1e-9);
}

TEST(OnFacet, RestsOnlyIfFrictionHoldsIt) {
  const Profile profile = bend(-2);
  for (const double mu : {0.74, 0.76}) {  // the slope is 0.75
    RockOn rock(profile, {}, closed_form(), {Vec3(-20 * down), Vec3{}});
    OnFacet state = first_facet(profile, mu);
    const auto next = take_leg(*rock, state);
    ASSERT_TRUE(next);
    const auto* const end = std::get_if<Ended>(&next->phase);
    EXPECT_EQ(end != nullptr && end->reason == EndReason::at_rest, mu > 0.75);
  }
}

// a = 5/7 g sin: the velocity after a step of 0.01 s is 0.01 a, and the spin that of rolling.
TEST(OnFacet, ASphereRollsWithFiveSeventhsOfThePull) {
  const Profile profile = bend(-2);
  const Rock ball = sphere_of_diameter(1, 2700);
  const Vec3 n = profile.normal(FacetId{0});
  RockOn rock(profile, {.mu = 10, .rolling = 0}, laws_of(RockModel::rigid_sphere),
              {Vec3(-20 * down + ball.radius * n), Vec3{}}, ball);
  OnFacet state{{{n, FacetId{0}}, {.sphere = {10, 0}}, {}}};
  ASSERT_FALSE(take_leg(*rock, state));
  const double speed = 0.01 * 5.0 / 7 * g * 0.6;
  EXPECT_NEAR(rock->motion.velocity.dot(down), speed, 1e-12);
  EXPECT_NEAR(rock->motion.spin.y(), speed / ball.radius, 1e-12);
  EXPECT_NEAR(gap_to_plane(*rock, n, profile.point_of(FacetId{0})), 0, 1e-12);
}

// A facet that the rock has left is not struck for a millimetre, and then again.
TEST(OnFacet, AFacetThatWasLeftOnlyLimitsTheNextLeg) {
  const Profile profile = bend(-2);
  const Rock ball = sphere_of_diameter(1, 2700);
  const Vec3 n = profile.normal(FacetId{0});
  RockOn rock(profile, {.mu = 10, .rolling = 0}, laws_of(RockModel::rigid_sphere),
              {Vec3(-20 * down + ball.radius * n), Vec3(5 * down)}, ball);
  rock->motion.spin = rolling_spin(rock->motion.velocity, Vec3{}, n, ball.radius);
  OnFacet state{{{n, FacetId{0}}, {.sphere = {10, 0}}, LeftFacet{unit_x}}};
  const Vec3 start = rock->motion.position;
  ASSERT_FALSE(take_leg(*rock, state));
  EXPECT_NEAR((rock->motion.position - start).norm(), tolerance::past_the_end, 1e-6);
  EXPECT_TRUE(std::holds_alternative<std::monostate>(state.side_contact));
  const Vec3 then = rock->motion.position;
  ASSERT_FALSE(take_leg(*rock, state));
  EXPECT_GT((rock->motion.position - then).norm(), 0.04);
}

}  // namespace
}  // namespace talus::on_facet_test
