#include "talus/meshing/constrained_triangulation.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/dice.hpp"
#include "support/triangulations.hpp"

namespace talus::constrained_triangulation_test {
namespace {

using namespace testing_tools;
using Vertex = Triangulation::Vertex;

constexpr std::int32_t step = 1 << 20;  // grid steps of 2^-20 m in a metre

struct Scene {
  explicit Scene(std::vector<GridPoint> points, std::vector<double> z)
      : heights(std::move(z)), grid(ExactGrid::over({0, 0}, {1000, 1000})), triangulation(std::move(points)) {}

  std::vector<double> heights;
  ExactGrid grid;
  Triangulation triangulation;
  ConstrainedTriangulation lines{triangulation, heights, grid};
};

/// Whether fixed sides lead from `a` to `b`, never further than `slack` from the straight line.
bool is_chain(const Triangulation& t, GridPoint a, GridPoint b, double slack) {
  const double length = std::hypot(double{1} * b.x - a.x, double{1} * b.y - a.y);
  const auto along = [&](GridPoint p) {
    return ((double{1} * p.x - a.x) * (double{1} * b.x - a.x) + (double{1} * p.y - a.y) * (double{1} * b.y - a.y)) /
           length;
  };
  Vertex at = 0;
  while (t.point(at) != a) ++at;
  while (t.point(at) != b) {
    std::optional<Vertex> next;
    const auto first = t.side_from(at);
    auto side = first;
    do {
      const Vertex v = t.to(side);
      if (v != Triangulation::infinity && t.is_fixed(side)) {
        const double off = std::abs(static_cast<double>(doubled_area(a, b, t.point(v)))) / length;
        if (off <= slack && along(t.point(v)) > along(t.point(at))) next = v;
      }
      side = t.next_around(side);
    } while (side.triangle != first.triangle);
    if (!next) return false;
    at = *next;
  }
  return true;
}

bool is_fixed(const Scene& scene, Vertex a, Vertex b) {
  const auto side = scene.triangulation.side(a, b);
  return side && scene.triangulation.is_fixed(*side);
}

TEST(ConstrainedTriangulation, ASegmentAcrossAGridBecomesASide) {
  std::vector<GridPoint> points;
  for (std::int32_t i = 0; i <= 10; ++i) {
    for (std::int32_t j = 0; j <= 10; ++j) points.push_back({i * step, j * step});
  }
  Scene scene(points, std::vector<double>(121));
  scene.lines.add(0, 9 * 11 + 10);  // (0, 0) to (9, 10): passes no grid point
  EXPECT_TRUE(scene.triangulation.side(0, 9 * 11 + 10));
  EXPECT_EQ(scene.triangulation.vertex_count(), 121U);
  expect_sound(scene.triangulation);
  EXPECT_EQ(scene.lines.report().segments, 1U);
  EXPECT_EQ(scene.lines.report().crossings.count, 0U);
}

TEST(ConstrainedTriangulation, AVertexOnASegmentSplitsIt) {
  std::vector<GridPoint> points;
  std::vector<double> z;
  for (std::int32_t i = 0; i <= 10; ++i) {
    for (std::int32_t j = 0; j <= 10; ++j) {
      points.push_back({i * step, j * step});
      z.push_back(0.1 * i + (i == 5 && j == 5 ? 2 : 0));
    }
  }
  Scene scene(points, z);
  scene.lines.add(0, 120);
  for (std::uint32_t k = 0; k < 10; ++k)
    EXPECT_TRUE(scene.triangulation.is_fixed(*scene.triangulation.side(12 * k, 12 * k + 12)));
  expect_sound(scene.triangulation);
  // The vertex in the middle keeps its height, 2 m above the segment; the other eight are on it.
  EXPECT_EQ(scene.heights[60], 2.5);
  EXPECT_EQ(scene.lines.report().vertices_at_odds.count, 1U);
  EXPECT_NEAR(scene.lines.report().largest_vertex_difference_m, 2, 1e-12);
  ASSERT_EQ(scene.lines.report().vertices_at_odds.examples.size(), 1U);
  EXPECT_EQ(scene.lines.report().vertices_at_odds.examples[0], Vec3(5, 5, 2.5));
}

TEST(ConstrainedTriangulation, CrossingsGetAVertexAtTheMeanHeight) {
  Scene scene({{0, 0}, {10 * step, 10 * step}, {10 * step, 0}, {0, 10 * step}}, {0, 10, 2, 4});
  scene.lines.add(0, 1);
  scene.lines.add(2, 3);
  ASSERT_EQ(scene.triangulation.vertex_count(), 5U);
  EXPECT_EQ(scene.triangulation.point(4), (GridPoint{5 * step, 5 * step}));
  EXPECT_EQ(scene.heights[4], 0.5 * (5 + 3));
  for (Vertex v = 0; v < 4; ++v) EXPECT_TRUE(scene.triangulation.is_fixed(*scene.triangulation.side(v, 4)));
  expect_sound(scene.triangulation);
  EXPECT_EQ(scene.lines.report().crossings.count, 1U);
  EXPECT_EQ(scene.lines.report().crossings_at_odds.count, 1U);
  EXPECT_EQ(scene.lines.report().largest_difference_m, 2);
  EXPECT_EQ(scene.lines.report().crossings.examples.front(), Vec3(5, 5, 4));
}

TEST(ConstrainedTriangulation, CrossingsAtEqualHeightsAreNotAtOdds) {
  Scene scene({{0, 0}, {10 * step, 10 * step}, {10 * step, 0}, {0, 10 * step}}, {0, 10, 4, 6});
  scene.lines.add(0, 1);
  scene.lines.add(2, 3);
  EXPECT_EQ(scene.heights[4], 5);
  EXPECT_EQ(scene.lines.report().crossings.count, 1U);
  EXPECT_EQ(scene.lines.report().crossings_at_odds.count, 0U);
}

TEST(ConstrainedTriangulation, OverlappingSegmentsShareTheirSides) {
  Scene scene({{0, 0}, {4 * step, 0}, {7 * step, 0}, {10 * step, 0}, {5 * step, 5 * step}, {5 * step, -0 + 9 * step}},
              std::vector<double>(6));
  scene.lines.add(0, 2);
  scene.lines.add(1, 3);
  scene.lines.add(3, 0);
  EXPECT_EQ(scene.triangulation.vertex_count(), 6U);
  EXPECT_EQ(scene.lines.report().overlapping, 1U + 3U);
  expect_sound(scene.triangulation);
}

TEST(ConstrainedTriangulation, ASegmentWithoutLengthIsLeftOut) {
  Scene scene({{0, 0}, {step, 0}, {0, step}}, {0, 0, 0});
  scene.lines.add(1, 1);
  EXPECT_EQ(scene.lines.report().zero_length, 1U);
  EXPECT_EQ(scene.lines.report().segments, 0U);
}

// Crossings half a step from a vertex, and lines that almost coincide: the insertion terminates and stays sound.
TEST(ConstrainedTriangulation, CrossingsAtTheScaleOfTheGridTerminate) {
  Dice dice(21);
  for (int i = 0; i < 300; ++i) {
    const std::int32_t end = 4 + static_cast<std::int32_t>(dice.below(30));
    const auto points = scattered(dice, 4 + dice.below(10), end);
    if (!Triangulation::span_a_plane(points)) continue;
    Scene scene(points, std::vector<double>(points.size()));
    for (std::size_t k = 0; k < 12; ++k) {
      scene.lines.add(static_cast<Vertex>(dice.below(points.size())), static_cast<Vertex>(dice.below(points.size())));
    }
    expect_sound(scene.triangulation);
    if (HasFailure()) FAIL() << "run " << i;
  }
}

TEST(ConstrainedTriangulation, RandomSegmentsAreChainsOfSidesAndTheRestIsDelaunay) {
  Dice dice(22);
  for (int i = 0; i < 60; ++i) {
    const auto points = scattered(dice, 300, grid_end);
    Scene scene(points, std::vector<double>(points.size()));
    std::vector<std::array<Vertex, 2>> added;
    for (std::size_t k = 0; k < 25; ++k) {
      const auto a = static_cast<Vertex>(dice.below(points.size())), b = static_cast<Vertex>(dice.below(points.size()));
      if (a == b) continue;
      added.push_back({a, b});
      scene.lines.add(a, b);
    }
    expect_sound(scene.triangulation);
    EXPECT_EQ(scene.heights.size(), scene.triangulation.vertex_count());
    EXPECT_GT(scene.lines.report().crossings.count, 10U);
    for (const auto& [a, b] : added) {
      // Bent at every crossing by at most half a step along x and y.
      EXPECT_TRUE(is_chain(scene.triangulation, points[a], points[b], 2.0));
    }
    if (HasFailure()) FAIL() << "run " << i;
  }
}

// Crossings bend a line by less than a micrometre; a line drawn on it again, backwards or in part follows it.
TEST(ConstrainedTriangulation, LinesDrawnAgainAddNoCrossings) {
  Dice dice(24);
  for (int i = 0; i < 20; ++i) {
    auto points = scattered(dice, 240, grid_end);
    for (std::size_t k = 0; k < 60; ++k) {  // the midpoint of each line, rounded
      const GridPoint a = points[2 * k], b = points[2 * k + 1];
      points.push_back({a.x + (b.x - a.x) / 2, a.y + (b.y - a.y) / 2});
    }
    Scene scene(points, std::vector<double>(points.size()));
    for (Vertex k = 0; k < 60; ++k) scene.lines.add(2 * k, 2 * k + 1);
    const std::size_t once = scene.lines.report().crossings.count;
    EXPECT_GT(once, 100U);
    for (Vertex k = 60; k-- > 0;) scene.lines.add(2 * k + 1, 2 * k);
    EXPECT_EQ(scene.lines.report().overlapping, 2 * (60 + once));
    for (Vertex k = 0; k < 60; ++k) scene.lines.add(240 + k, 2 * k);
    EXPECT_EQ(scene.lines.report().crossings.count, once);
    EXPECT_EQ(scene.triangulation.vertex_count(), points.size() + once);
    expect_sound(scene.triangulation);
    if (HasFailure()) FAIL() << "run " << i;
  }
}

TEST(ConstrainedTriangulation, AVertexWithinRoundingIsOnTheSegment) {
  for (const std::int32_t off : {0, 2, 5}) {
    SCOPED_TRACE(off);
    Scene scene({{0, 0}, {10 * step, 5 * step}, {4 * step, 2 * step + off}, {9 * step, 0}, {0, 9 * step}},
                std::vector<double>(5));
    scene.lines.add(0, 1);
    EXPECT_EQ(is_fixed(scene, 0, 2) && is_fixed(scene, 2, 1), off < 5);
    EXPECT_EQ(is_fixed(scene, 0, 1), off == 5);
    EXPECT_EQ(scene.triangulation.vertex_count(), 5U);
    expect_sound(scene.triangulation);
  }
}

TEST(ConstrainedTriangulation, ALineThatEndsOnAnotherWithinRoundingBendsIt) {
  // The end is a grid step beyond the other line.
  Scene scene({{0, 0}, {10 * step, 5 * step}, {4 * step, 2 * step + 1}, {7 * step, 0}}, {0, 5, 2, 0});
  scene.lines.add(0, 1);
  scene.lines.add(3, 2);
  EXPECT_EQ(scene.triangulation.vertex_count(), 4U);
  EXPECT_TRUE(is_fixed(scene, 0, 2) && is_fixed(scene, 2, 1) && is_fixed(scene, 3, 2));
  expect_sound(scene.triangulation);
}

// The check of the tests above must be able to fail.
TEST(ConstrainedTriangulation, AMissingChainIsNotFound) {
  Dice dice(23);
  const auto points = scattered(dice, 300, grid_end);
  Scene scene(points, std::vector<double>(points.size()));
  scene.lines.add(0, 1);
  EXPECT_TRUE(is_chain(scene.triangulation, points[0], points[1], 2.0));
  EXPECT_FALSE(is_chain(scene.triangulation, points[0], points[2], 2.0));
}

// Closed contours of a cone and a line straight down, which crosses each of them once.
TEST(ConstrainedTriangulation, ALineDownAConeCrossesEachContour) {
  std::vector<GridPoint> points;
  std::vector<double> z;
  constexpr int rings = 40, around = 90;
  for (int ring = 1; ring <= rings; ++ring) {
    for (int k = 0; k < around; ++k) {
      const double angle = 2 * std::numbers::pi * (k + 0.37) / around, r = 10.0 * ring * step;
      points.push_back({static_cast<std::int32_t>(std::lround(500.0 * step + r * std::cos(angle))),
                        static_cast<std::int32_t>(std::lround(500.0 * step + r * std::sin(angle)))});
      z.push_back(-1.0 * ring);
    }
  }
  const auto top = static_cast<Vertex>(points.size());
  points.push_back({500 * step, 500 * step});
  z.push_back(0);
  points.push_back({950 * step, 500 * step});
  z.push_back(-45);
  Scene scene(points, z);
  for (Vertex ring = 0; ring < rings; ++ring) {
    for (Vertex k = 0; k < around; ++k) scene.lines.add(ring * around + k, ring * around + (k + 1) % around);
  }
  scene.lines.add(top, top + 1);
  EXPECT_EQ(scene.lines.report().crossings.count, static_cast<std::size_t>(rings));
  expect_sound(scene.triangulation);
  EXPECT_TRUE(is_chain(scene.triangulation, points[top], points[top + 1], 1.0));
}

}  // namespace
}  // namespace talus::constrained_triangulation_test
