// A rock in a valley, leg by leg.

#include "talus/trajectory/in_valley.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "support/meshes.hpp"
#include "support/moving_rocks.hpp"

namespace talus::in_valley_test {
namespace {

using namespace testing_tools;

constexpr double g = standard_gravity;
constexpr double fall = 0.5, side = 1;

/// z = fall (10 - x) + side |y|, 10 m long.
TriangleMesh trough() {
  return net(
             2, 2,
             [](std::uint32_t i, std::uint32_t j) {
               const double x = 5.0 * i, y = 10.0 * j - 10;
               return Vec3(x, y, fall * (10 - x) + side * std::abs(y));
             },
             [](std::uint32_t, std::uint32_t) { return true; })
      .mesh();
}
const Vec3 along = Vec3(1, 0, -fall).normalized();

/// The facets on both sides of the bottom.
InValley valley_at(const TriangleMesh& mesh, const Vec3& place, double mu) {
  InValley state{};
  bool has_first = false;
  mesh.supports(place, 0, 1e-9, [&](const Vec3&, const Vec3&, double, FacetId facet) {
    const Support support{mesh.normal(facet), facet};
    if (!has_first) {
      state.other = support;
      has_first = true;
    } else if (support.normal.dot(state.other.normal) < 0.999) {
      state.on = support;
    }
  });
  state.is_on_facet = true;
  state.friction.mu = mu;
  return state;
}

Motion in_the_bottom(double x, double speed) { return {Vec3(x, 0, fall * (10 - x)), Vec3(speed * along)}; }

// Both sides press: a = g_par - mu (N1 + N2), with N1 + N2 = g_perp / cos of half the angle between the normals.
TEST(InValley, SlidesBetweenBothSides) {
  const TriangleMesh mesh = trough();
  const double mu = 0.2;
  Laws laws = laws_of(RockModel::lumped_mass);
  laws.sliding = SlidingMethod::closed_form;
  RockOn rock(mesh, {}, laws, in_the_bottom(1, 2));
  InValley state = valley_at(mesh, rock->motion.position, mu);
  const double half = 0.5 * std::acos(state.on.normal.dot(state.other.normal));
  const double pull = g * fall / std::sqrt(1 + fall * fall), across = g / std::sqrt(1 + fall * fall);
  const double acceleration = pull - mu * across / std::cos(half);
  const auto next = take_leg(*rock, state);  // to the end of the first facets, 5 m along x
  ASSERT_TRUE(next);
  ASSERT_TRUE(std::holds_alternative<InValley>(next->phase));
  EXPECT_NEAR(rock->motion.position.x(), 5, 1e-9);
  EXPECT_NEAR(rock->motion.position.y(), 0, 1e-9);
  const double way = 4 * std::sqrt(1 + fall * fall);
  EXPECT_NEAR(rock->motion.velocity.squared_norm(), 4 + 2 * acceleration * way, 1e-8);
  EXPECT_NEAR(rock->motion.velocity.normalized().dot(along), 1, 1e-12);
}

TEST(InValley, EndsAtTheEdgeOfTheModel) {
  const TriangleMesh mesh = trough();
  Laws laws = laws_of(RockModel::lumped_mass);
  laws.sliding = SlidingMethod::closed_form;
  RockOn rock(mesh, {}, laws, in_the_bottom(7, 2));
  InValley state = valley_at(mesh, rock->motion.position, 0.2);
  const auto next = take_leg(*rock, state);
  ASSERT_TRUE(next);
  ASSERT_TRUE(std::holds_alternative<Ended>(next->phase));
  EXPECT_EQ(std::get<Ended>(next->phase).reason, EndReason::left_model);
  EXPECT_NEAR(rock->motion.position.x(), 10, 1e-9);
}

TEST(InValley, KeepsOnlyTheVelocityAlongIt) {
  const TriangleMesh mesh = trough();
  RockOn rock(mesh, {}, laws_of(RockModel::lumped_mass), in_the_bottom(1, 0));
  const InValley state = valley_at(mesh, rock->motion.position, 0.2);
  rock->motion.velocity = Vec3(3, 1, 2);
  keep_along_valley(*rock, state);
  EXPECT_NEAR((rock->motion.velocity - Vec3(3, 1, 2).dot(along) * along).norm(), 0, 1e-12);
  const GroundBeneath beneath = ground_beneath(*rock, state, rock->valley_of(state).footing);
  EXPECT_NEAR((beneath.along_ground(Vec3(3, 1, 2)) - rock->motion.velocity).norm(), 0, 1e-12);
}

// If only one side continues, the rock moves on over it with its friction, and still touches the other for a moment.
TEST(InValley, ContinuesOverOneSide) {
  const TriangleMesh mesh = trough();
  RockOn rock(mesh, {.phi = 0.3}, laws_of(RockModel::lumped_mass), in_the_bottom(1, 2));
  const InValley state = valley_at(mesh, rock->motion.position, 0.2);
  const Phase next = leave_other_side(*rock, state);
  ASSERT_TRUE(std::holds_alternative<OnFacet>(next));
  EXPECT_EQ(std::get<OnFacet>(next).on.facet, state.on.facet);
  EXPECT_EQ(std::get<OnFacet>(next).friction.mu, 0.2);  // the same material on both sides
  ASSERT_TRUE(std::holds_alternative<LeftFacet>(std::get<OnFacet>(next).side_contact));
  EXPECT_EQ(std::get<LeftFacet>(std::get<OnFacet>(next).side_contact).normal, state.other.normal);
}

}  // namespace
}  // namespace talus::in_valley_test
