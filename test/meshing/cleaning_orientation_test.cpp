// Winding and neighbours of cleaned meshes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/raw_meshes.hpp"

namespace talus::cleaning_orientation_test {
namespace {

using namespace testing_tools;
using ::testing::ElementsAre;

TEST(CleaningOrientation, RandomWindingsOfATinAreRestored) {
  std::mt19937_64 random{1};
  for (int trial = 0; trial < 20; ++trial) {
    RawMesh mesh = random_tin(12, random, Vec3{2'600'000, 1'200'000, 500});
    const RawMesh original = mesh;
    flip_at_random(mesh, random);
    std::size_t flipped = 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) flipped += mesh.triangles[i] != original.triangles[i];
    const CleanMesh cleaned = clean(mesh);
    expect_sound(cleaned);
    EXPECT_EQ(cleaned.report.flipped.count, flipped);
    EXPECT_TRUE(cleaned.report.every_facet_faces_up());
    EXPECT_EQ(cleaned.report.components, 1U);
    EXPECT_EQ(cleaned.report.closed_components, 0U);
    EXPECT_EQ(cleaned.report.boundary_edges, 48U);
    EXPECT_FALSE(cleaned.report.has_warnings());
    for (std::size_t i = 0; i < cleaned.triangles.size(); ++i) ASSERT_GT(normal(cleaned, i).z(), 0);
  }
}

TEST(CleaningOrientation, NeighboursAreFoundAcrossEachEdge) {
  // The second triangle has the wrong winding: flipping it reorders its edges.
  const CleanMesh mesh = clean({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {2, 0, 3}, {0, 3, 2}}});
  expect_sound(mesh);
  EXPECT_THAT(mesh.triangles, ElementsAre(RawTriangle{0, 1, 2}, RawTriangle{2, 3, 0}));
  const Neighbour none;
  EXPECT_EQ(mesh.neighbours[0], (std::array<Neighbour, 3>{none, none, Neighbour{FacetId{1}}}));
  EXPECT_EQ(mesh.neighbours[1], (std::array<Neighbour, 3>{none, none, Neighbour{FacetId{0}}}));
  EXPECT_FALSE(none.has_value());
}

TEST(CleaningOrientation, ABoxFacesOut) {
  std::mt19937_64 random{2};
  for (int trial = 0; trial < 20; ++trial) {
    const Vec3 at{2'600'000, 1'200'000, 500};
    RawMesh mesh = raw_box(at, {1, 2, 3});
    if (trial > 0) flip_at_random(mesh, random);
    const CleanMesh cleaned = clean(mesh);
    expect_sound(cleaned);
    EXPECT_EQ(cleaned.report.closed_components, 1U);
    EXPECT_EQ(cleaned.report.boundary_edges, 0U);
    EXPECT_EQ(cleaned.report.vertical.count, 8U);
    EXPECT_EQ(cleaned.report.overhanging.count, 2U);
    EXPECT_FALSE(cleaned.report.every_facet_faces_up());
    const Vec3 middle = at + Vec3{0.5, 1, 1.5};
    for (std::size_t i = 0; i < cleaned.triangles.size(); ++i) {
      EXPECT_GT(normal(cleaned, i).dot(cleaned.vertices[cleaned.triangles[i][0]] - middle), 0);
    }
  }
}

TEST(CleaningOrientation, ABowlFacesUpAndIn) {
  RawMesh bowl{{{0, 0, -10}, {10, 0, 0}, {-5, 8, 0}, {-5, -8, 0}}, {{0, 2, 1}, {0, 2, 3}, {3, 0, 1}}};
  const CleanMesh cleaned = clean(bowl);
  expect_sound(cleaned);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_GT(normal(cleaned, i).z(), 0);
    EXPECT_GT(normal(cleaned, i).dot(Vec3{0, 0, 0} - cleaned.vertices[0]), 0);
  }
}

TEST(CleaningOrientation, AnOverhangFacesDown) {
  // A plateau, a lip that overhangs the foot of a cliff, and the ground below it: along x, z goes 10, 10, 4, 0, 0.
  std::mt19937_64 random{3};
  RawMesh cliff = raw_extrusion({{0, 10}, {6, 10}, {4, 4}, {4, 0}, {20, 0}});
  flip_at_random(cliff, random);
  const CleanMesh cleaned = clean(cliff);
  expect_sound(cleaned);
  EXPECT_EQ(cleaned.report.overhanging.count, 2U);
  EXPECT_EQ(cleaned.report.vertical.count, 2U);
  EXPECT_GT(normal(cleaned, 0).z(), 0.99);
  EXPECT_LT(normal(cleaned, 2).z(), 0);
  EXPECT_GT(normal(cleaned, 2).x(), 0);  // the overhang faces away from the rock, towards the valley
  EXPECT_GT(normal(cleaned, 4).x(), 0.99);
  EXPECT_GT(normal(cleaned, 6).z(), 0.99);
}

TEST(CleaningOrientation, AnArchIsASolidAndFacesOut) {
  // The outline of a gate (x, z) with its opening, extruded and closed at both ends by strips from outer to inner line.
  const std::vector<Vec2> gate{{0, 0}, {0, 4}, {6, 4}, {6, 0}, {4, 0}, {4, 3}, {2, 3}, {2, 0}};
  RawMesh arch = raw_extrusion(gate, true);
  for (const std::uint32_t side : {0U, 1U}) {
    const auto at = [&](std::uint32_t i) { return 2 * i + side; };
    add_quad(arch, at(0), at(1), at(6), at(7));
    add_quad(arch, at(1), at(2), at(5), at(6));
    add_quad(arch, at(2), at(3), at(4), at(5));
  }
  std::mt19937_64 random{4};
  flip_at_random(arch, random);
  const CleanMesh cleaned = clean(arch);
  expect_sound(cleaned);
  EXPECT_EQ(cleaned.report.closed_components, 1U);
  double volume = 0;
  for (const RawTriangle& t : cleaned.triangles) {
    volume += cleaned.vertices[t[0]].dot(cleaned.vertices[t[1]].cross(cleaned.vertices[t[2]])) / 6;
  }
  EXPECT_NEAR(volume, 6 * 4 - 2 * 3, 1e-12);
  EXPECT_LT(normal(cleaned, 10).z(), -0.99);  // the soffit of the opening
}

TEST(CleaningOrientation, ComponentsAreOrientedIndependently) {
  std::mt19937_64 random{5};
  RawMesh mesh = random_tin(4, random);
  for (RawTriangle& t : mesh.triangles) std::swap(t[0], t[1]);
  const CleanMesh cleaned = clean(joined(mesh, raw_box({0, 0, 20}, {1, 1, 1})));
  expect_sound(cleaned);
  EXPECT_EQ(cleaned.report.components, 2U);
  EXPECT_EQ(cleaned.report.closed_components, 1U);
  EXPECT_EQ(cleaned.report.flipped.count, 32U);
}

TEST(CleaningOrientation, AWallKeepsTheWindingOfMostFacetsAndIsReported) {
  RawMesh wall = raw_extrusion({{0, 0}, {0, 1}, {0, 2}, {0, 3}});
  std::swap(wall.triangles[0][0], wall.triangles[0][1]);
  const CleanMesh cleaned = clean(wall);
  expect_sound(cleaned);
  EXPECT_EQ(cleaned.report.flipped.count, 1U);
  for (std::size_t i = 0; i < cleaned.triangles.size(); ++i) EXPECT_EQ(normal(cleaned, i), Vec3(-1, 0, 0));
  EXPECT_EQ(cleaned.report.undecided_components.count, 1U);
  EXPECT_TRUE(cleaned.report.has_warnings());
}

TEST(CleaningOrientation, AMoebiusStripIsReportedAndEachFacetFacesUp) {
  const CleanMesh cleaned = clean(moebius_strip(40));
  expect_sound(cleaned);
  EXPECT_EQ(cleaned.triangles.size(), 80U);
  EXPECT_EQ(cleaned.report.components, 1U);
  EXPECT_EQ(cleaned.report.one_sided_components.count, 1U);
  EXPECT_TRUE(cleaned.report.has_warnings());
  for (std::size_t i = 0; i < cleaned.triangles.size(); ++i) EXPECT_GE(normal(cleaned, i).z(), -vertical_n_z);
}

TEST(CleaningOrientation, AFinOnASlopeIsNonManifold) {
  // Two facets of ground, and a fin that stands on the edge between them.
  const RawMesh mesh{{{0, -1, 0}, {0, 1, 0}, {-1, 0, 0}, {1, 0, 0}, {0, 0, 1}}, {{0, 1, 2}, {0, 3, 1}, {0, 1, 4}}};
  const CleanMesh cleaned = clean(mesh);
  expect_sound(cleaned);
  EXPECT_EQ(cleaned.report.non_manifold_edges.count, 1U);
  EXPECT_THAT(cleaned.report.non_manifold_edges.examples, ElementsAre(Vec3{0, 0, 0}));
  EXPECT_EQ(cleaned.report.components, 3U);
  EXPECT_EQ(cleaned.report.boundary_edges, 6U);
  EXPECT_EQ(cleaned.report.vertical.count, 1U);
  EXPECT_GT(normal(cleaned, 0).z(), 0.99);
  EXPECT_GT(normal(cleaned, 1).z(), 0.99);
  for (const auto& neighbours : cleaned.neighbours) {
    EXPECT_EQ(neighbours, (std::array<Neighbour, 3>{}));
  }
}

}  // namespace
}  // namespace talus::cleaning_orientation_test
