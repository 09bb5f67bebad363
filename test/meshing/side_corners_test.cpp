#include "talus/meshing/side_corners.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "support/dice.hpp"
#include "talus/meshing/cleaning.hpp"

namespace talus::side_corners_test {
namespace {

using namespace testing_tools;
using ::testing::ElementsAre;
using Triangle = std::array<std::uint32_t, 3>;

double area(const std::vector<Vec3>& vertices, const std::vector<Triangle>& triangles) {
  double sum = 0;
  for (const auto& [a, b, c] : triangles)
    sum += 0.5 * (vertices[b] - vertices[a]).cross(vertices[c] - vertices[a]).norm();
  return sum;
}

// A facet, and two more beyond its second edge that meet at the middle of that edge.
const std::vector<Vec3> junction{{0, 0, 0}, {2, 0, 0}, {2, 4, 0}, {2, 2, 0}, {5, 2, 1}};

TEST(SideCorners, ASideIsSplitAtACornerOnIt) {
  CutFacets facets{{{0, 1, 2}, {1, 4, 3}, {3, 4, 2}}, {0, 1, 2}};
  const Findings found = put_corners_into_sides(junction, facets, 0.001);
  EXPECT_EQ(found.count, 1U);
  EXPECT_THAT(found.examples, ElementsAre(Vec3{2, 2, 0}));
  EXPECT_THAT(facets.triangles,
              ElementsAre(Triangle{0, 1, 3}, Triangle{0, 3, 2}, Triangle{1, 4, 3}, Triangle{3, 4, 2}));
  EXPECT_THAT(facets.original, ElementsAre(0U, 0U, 1U, 2U));
}

TEST(SideCorners, OnlyWithinTheTolerance) {
  for (const double off : {0.0009, 0.0011}) {
    std::vector<Vec3> vertices = junction;
    vertices[3].z() = off;
    CutFacets facets{{{0, 1, 2}, {1, 4, 3}, {3, 4, 2}}, {0, 1, 2}};
    EXPECT_EQ(put_corners_into_sides(vertices, facets, 0.001).count, off < 0.001 ? 1U : 0U);
    EXPECT_EQ(facets.triangles.size(), off < 0.001 ? 4U : 3U);
  }
}

TEST(SideCorners, OnlyOnTheBoundary) {
  // A fin that stands with one corner on an edge between two facets.
  const std::vector<Vec3> vertices{{0, 0, 0}, {4, 0, 0}, {2, 3, 0}, {2, -3, 0}, {2, 0, 0}, {1, 1, 5}, {3, 1, 5}};
  CutFacets facets{{{0, 1, 2}, {1, 0, 3}, {4, 5, 6}}, {0, 1, 2}};
  EXPECT_EQ(put_corners_into_sides(vertices, facets, 0.001).count, 0U);
  EXPECT_EQ(facets.triangles.size(), 3U);
}

TEST(SideCorners, AFacetIsSplitOnAllItsSides) {
  const std::vector<Vec3> vertices{{0, 0, 0}, {6, 0, 0}, {0, 6, 0}, {3, 0, 0}, {3, -3, 0},
                                   {3, 3, 0}, {5, 5, 0}, {0, 3, 0}, {-3, 3, 0}};
  CutFacets facets{{{0, 1, 2}, {0, 4, 3}, {3, 4, 1}, {1, 6, 5}, {5, 6, 2}, {2, 8, 7}, {7, 8, 0}},
                   {0, 1, 2, 3, 4, 5, 6}};
  const double before = area(vertices, facets.triangles);
  EXPECT_EQ(put_corners_into_sides(vertices, facets, 0.001).count, 3U);
  EXPECT_EQ(facets.triangles.size(), 10U);
  EXPECT_NEAR(area(vertices, facets.triangles), before, 1e-12);
}

TEST(SideCorners, AFacetThatWouldTurnOverIsNotSplit) {
  // The facet is lower than the tolerance, and the corner lies beyond its apex.
  const std::vector<Vec3> vertices{{0, 0, 0}, {4, 0, 0}, {2, 0.0005, 0}, {2, 0.0009, 0}, {1, 3, 0}, {3, 3, 0}};
  CutFacets facets{{{0, 1, 2}, {3, 5, 4}}, {0, 1}};
  EXPECT_EQ(put_corners_into_sides(vertices, facets, 0.001).count, 0U);
  EXPECT_EQ(facets.triangles.size(), 2U);
}

// Two fans that divide their common side independently become one component with the same area.
TEST(SideCorners, SidesDividedIndependentlyAreJoined) {
  Dice dice(31);
  for (int run = 0; run < 50; ++run) {
    RawMesh mesh;
    for (const double apex : {-10.0, 10.0}) {
      std::vector<double> places{0, 20};
      for (std::size_t k = dice.below(30); k > 0; --k) places.push_back(20 * dice.unit());
      std::sort(places.begin(), places.end());
      const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
      mesh.vertices.emplace_back(2'600'000 + apex, 1'200'010, 500);
      for (const double y : places) mesh.vertices.emplace_back(2'600'000 + 1e-4 * dice.unit(), 1'200'000 + y, 490);
      for (std::uint32_t k = 1; k < places.size(); ++k) mesh.triangles.push_back({first, first + k, first + k + 1});
    }
    const double before = area(mesh.vertices, mesh.triangles);
    const CleanMesh cleaned = clean(mesh, {.source = "", .weld_tolerance_m = 0.001});
    EXPECT_EQ(cleaned.report.components, 1U) << run;
    EXPECT_EQ(cleaned.report.boundary_edges, 4U) << run;
    EXPECT_EQ(cleaned.report.loose_edges.cracks.count, 0U) << run;
    EXPECT_NEAR(area(cleaned.vertices, cleaned.triangles), before, 0.05) << run;
  }
}

}  // namespace
}  // namespace talus::side_corners_test
