// The state after an impact: flight, or one of the states on the ground.

#include "talus/trajectory/striking.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "support/moving_rocks.hpp"
#include "talus/terrain/profile.hpp"

namespace talus::striking_test {
namespace {

using namespace testing_tools;

// Two planes of 45 degrees that meet at the origin.
const Profile& vee() {
  static const Profile profile(std::vector<Vec2>{{-10, 10}, {0, 0}, {10, 10}});
  return profile;
}
const Profile& roof() {
  static const Profile profile(std::vector<Vec2>{{-10, -10}, {0, 0}, {10, -10}});
  return profile;
}

Contact on_facet(const Profile& profile, std::uint32_t facet) {
  return {0, profile.normal(FacetId{facet}), FacetId{facet}, Feature::facet};
}

// With every law the rock leaves with Rn of its normal velocity, or stays on the ground if that is below the cutoff.
TEST(Striking, LeavesTheGroundOnlyAboveTheCutoff) {
  for (const auto model : {RockModel::lumped_mass, RockModel::rigid_sphere}) {
    for (const double into : {0.1, 0.3}) {
      const Vec3 n = vee().normal(FacetId{0});
      RockOn rock(vee(), {.rn = 0.5}, laws_of(model), {Vec3(-5, 0, 5), Vec3(-into * n)});
      const Phase next = strike(*rock, on_facet(vee(), 0));
      EXPECT_EQ(std::holds_alternative<Flying>(next), 0.5 * into >= 0.1);
      EXPECT_EQ(std::holds_alternative<OnFacet>(next), 0.5 * into < 0.1);
      if (0.5 * into >= 0.1) {
        EXPECT_NEAR(rock->motion.velocity.dot(n), 0.5 * into, 1e-15);
      }
    }
  }
}

TEST(Striking, ASecondContactInOnePlaceIsAValleyIfGravityHoldsTheRock) {
  const std::array normals{vee().normal(FacetId{0}), vee().normal(FacetId{1})};
  RockOn rock(vee(), {.rn = 0}, laws_of(RockModel::lumped_mass), {Vec3{}, Vec3(0, 0, -1)});
  ASSERT_TRUE(std::holds_alternative<OnFacet>(strike(*rock, on_facet(vee(), 0))));
  rock->motion.velocity = Vec3(0, 2, -1);
  const Phase next = strike(*rock, on_facet(vee(), 1));
  ASSERT_TRUE(std::holds_alternative<InValley>(next));
  const InValley& state = std::get<InValley>(next);
  EXPECT_EQ(state.on.normal, normals[1]);
  EXPECT_EQ(state.other.normal, normals[0]);
  EXPECT_TRUE(state.is_on_facet);
  EXPECT_NEAR(std::abs(rock->valley_of(state).direction.y()), 1, 1e-15);
  // Each side carries half: N = g / (2 cos 45).
  EXPECT_NEAR(rock->valley_of(state).footing.normal_acceleration, standard_gravity * std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(rock->motion.velocity.x(), 0, 1e-15);
  EXPECT_NEAR(rock->motion.velocity.z(), 0, 1e-15);
}

// The ridge of a roof carries a sphere at rest, but not one that crosses it faster than v^2 = g r.
TEST(Striking, ARidgeCarriesASlowSphere) {
  const Rock ball = sphere_of_diameter(1, 2700);
  for (const double froude : {0.5, 0.99, 1.01, 2.0}) {
    const double speed = std::sqrt(froude * standard_gravity * ball.radius);
    RockOn rock(roof(), {.rn = 0, .rt = 1, .mu = 0}, laws_of(RockModel::rigid_sphere),
                {Vec3(0, 0, ball.radius), Vec3(speed, 0, 0)}, ball);
    const Phase next = strike(*rock, {0, unit_z, FacetId{0}, Feature::vertex});
    EXPECT_EQ(std::holds_alternative<OnEdge>(next), froude < 1) << froude;
    EXPECT_EQ(std::holds_alternative<Flying>(next), froude > 1) << froude;
  }
}

}  // namespace
}  // namespace talus::striking_test
