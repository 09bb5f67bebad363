// The division of ground into many facets does not affect a slide if plane and properties are the same.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "support/meshes.hpp"
#include "support/scenes.hpp"

namespace talus::slides_over_vertices_test {
namespace {

using namespace testing_tools;

constexpr double grade = 0.3, rim = 10;

/// A disc of this many facets around a vertex at the origin, on a plane that falls along y.
TriangleMesh fan(std::uint32_t facets) {
  Shape shape;
  shape.vertices.emplace_back(0, 0, 0);
  for (std::uint32_t k = 0; k < facets; ++k) {
    const double angle = 2 * std::numbers::pi * k / facets;
    shape.vertices.emplace_back(rim * std::cos(angle), rim * std::sin(angle), -grade * rim * std::sin(angle));
    shape.triangles.push_back({0, k + 1, (k + 1) % facets + 1});
  }
  return shape.mesh();
}

/// One material everywhere, or two equal ones in alternation.
Ground ground_of_fan(std::uint32_t facets, bool by_turns, const Soil& soil) {
  std::vector<std::uint8_t> of_facet(facets);
  for (std::uint32_t k = 0; k < facets; ++k) of_facet[k] = by_turns ? k % 2 : 0;
  return Ground({material_of(soil), material_of(soil)}, of_facet);
}

// At the vertex the rock crosses all facets between its first and its last one, each in no time: if its velocity turned
// by a whole step on each of them, that would be up to 36 steps.
TEST(SlideOverAVertex, TurnsTheVelocityByTimeNotByFacets) {
  constexpr std::uint32_t facets = 72;
  const TriangleMesh mesh = fan(facets);
  const Soil soil{.rn = 0, .rt = 1, .phi = 0.05};
  Laws laws;
  laws.sliding = SlidingMethod::stepped;
  laws.impact = PlainImpact{};
  for (int k = 0; k < 24; ++k) {
    const double heading = 0.1 + 2 * std::numbers::pi * k / 24;
    Release release;
    release.rock = sphere_of_mass(1000, 2700);
    release.motion.velocity = 0.5 * Vec3(std::cos(heading), std::sin(heading), -grade * std::sin(heading));
    const Followed whole = follow(mesh, ground_of_fan(facets, false, soil), laws, release);
    const Followed cut = follow(mesh, ground_of_fan(facets, true, soil), laws, release);
    ASSERT_EQ(whole.outcome.reason, EndReason::left_model);
    ASSERT_EQ(cut.outcome.reason, EndReason::left_model);
    // A step that an edge cuts short shifts the later ones: a few hundredths of a second of the pull, 2.7 m/s2, over
    // the 2.7 s to the rim.
    EXPECT_LT((cut.outcome.end.position - whole.outcome.end.position).norm(), 0.1) << "heading " << heading;
    EXPECT_LT((cut.outcome.end.velocity - whole.outcome.end.velocity).norm(), 0.1) << "heading " << heading;
  }
}

}  // namespace
}  // namespace talus::slides_over_vertices_test
