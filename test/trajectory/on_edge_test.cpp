// A sphere on an edge, step by step.

#include "talus/trajectory/on_edge.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/moving_rocks.hpp"
#include "talus/terrain/profile.hpp"

namespace talus::on_edge_test {
namespace {

using namespace testing_tools;

constexpr double g = standard_gravity;
const Rock ball = sphere_of_diameter(1, 2700);

/// A plateau that ends at the origin, at a slope of `grade`.
Profile brow(double grade) { return Profile(std::vector<Vec2>{{-10, 0}, {0, 0}, {50, -50 * grade}}); }

OnEdge on_the_brow(double mu) { return {{{unit_z, FacetId{0}}, {.sphere = {mu, 0}}, {}}}; }

// A step turns by at most edge_step, energy is constant, and the contact does not move.
TEST(OnEdge, TurnsInSmallStepsAtConstantEnergy) {
  const Profile profile = brow(1);
  const double speed = 0.3;
  RockOn<Profile> rock(profile, {.rn = 0, .mu = 1e6, .rolling = 0}, laws_of(RockModel::rigid_sphere),
                       {Vec3(0, 0, ball.radius), Vec3(speed, 0, 0)}, ball);
  rock->motion.spin = Vec3(0, speed / ball.radius, 0);
  const double energy = rock->kinetic_energy() + ball.mass * g * ball.radius;
  OnEdge state = on_the_brow(1);  // 2/7 g sin / N is at most 0.75: it does not slip
  int steps = 0;
  while (true) {
    const Vec3 before = state.on.normal;
    const auto next = take_leg(*rock, state);
    if (next) {
      // The plane of the slope carries the sphere after the edge, within the same stretch.
      EXPECT_TRUE(next->is_same_stretch);
      ASSERT_TRUE(std::holds_alternative<OnFacet>(next->phase));
      EXPECT_EQ(std::get<OnFacet>(next->phase).on.facet, FacetId{1});
      break;
    }
    EXPECT_LE(std::acos(std::min(1.0, before.dot(state.on.normal))), 1.01 * tolerance::edge_step);
    EXPECT_NEAR(rock->motion.position.norm(), ball.radius, 1e-9);
    const double now = rock->kinetic_energy() + ball.mass * g * rock->motion.position.z();
    ASSERT_NEAR(now, energy, 1e-3 * energy);  // second order in the step's angle
    ASSERT_LT(++steps, 1000);
  }
  EXPECT_GT(steps, 0.9 * std::atan(1.0) / tolerance::edge_step);
}

TEST(OnEdge, TakesOffWhereItsWeightNoLongerTurnsIt) {
  const Profile profile = brow(20);
  const double froude = 0.2, speed = std::sqrt(froude * g * ball.radius);
  RockOn<Profile> rock(profile, {.rn = 0, .mu = 1e6, .rolling = 0}, laws_of(RockModel::rigid_sphere),
                       {Vec3(0, 0, ball.radius), Vec3(speed, 0, 0)}, ball);
  rock->motion.spin = Vec3(0, speed / ball.radius, 0);
  OnEdge state = on_the_brow(1e6);  // never slips; legs are short because of the possible friction
  std::optional<NextPhase> next;
  for (int steps = 0; !next; ++steps) {
    ASSERT_LT(steps, 1'000'000);
    next = take_leg(*rock, state);
  }
  ASSERT_TRUE(std::holds_alternative<Flying>(next->phase));
  // cos = (10 + 7 F) / 17, to within the angle of a step.
  EXPECT_NEAR(std::acos(state.on.normal.z()), std::acos((10 + 7 * froude) / 17), 2 * tolerance::edge_step);
}

TEST(OnEdge, AFastSphereIsNotPressedOnIt) {
  const Profile profile = brow(1);
  for (const double froude : {0.25, 1.0, 4.0}) {
    const double speed = std::sqrt(froude * g * ball.radius);
    RockOn<Profile> rock(profile, {}, laws_of(RockModel::rigid_sphere), {Vec3(0, 0, ball.radius), Vec3(speed, 0, 0)},
                         ball);
    EXPECT_NEAR(normal_acceleration_on_edge(*rock, on_the_brow(1).on), g * (1 - froude), 1e-12 * g);
  }
}

}  // namespace
}  // namespace talus::on_edge_test
