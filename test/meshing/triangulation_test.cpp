#include "talus/meshing/triangulation.hpp"

#include <gtest/gtest.h>

#include <array>
#include <boost/polygon/voronoi.hpp>
#include <map>
#include <set>

#include "support/dice.hpp"
#include "support/triangulations.hpp"

template <>
struct boost::polygon::geometry_concept<talus::GridPoint> {
  using type = point_concept;
};
template <>
struct boost::polygon::point_traits<talus::GridPoint> {
  using coordinate_type = int;
  static int get(const talus::GridPoint& p, orientation_2d axis) { return axis == HORIZONTAL ? p.x : p.y; }
};

namespace talus::triangulation_test {
namespace {

using namespace testing_tools;
using Vertex = Triangulation::Vertex;

// ---- the grid ----

TEST(ExactGrid, KeepsCoordinatesThatAreWholeSteps) {
  const ExactGrid grid = ExactGrid::over({2600000, -1200000}, {2610000, -1190000});
  EXPECT_EQ(grid.spacing_m(), 0x1p-16);
  Dice dice(1);
  for (int i = 0; i < 1000; ++i) {
    const Vec2 at(2600000 + 0.125 * static_cast<double>(dice.below(80001)),
                  -1200000 + 0.125 * static_cast<double>(dice.below(80001)));
    EXPECT_EQ(grid.place(grid.snapped(at.x(), at.y())), at);
  }
}

TEST(ExactGrid, MovesOtherCoordinatesByHalfAStepAtMost) {
  Dice dice(2);
  for (int i = 0; i < 1000; ++i) {
    const Vec2 low(dice.between(-3e6, 3e6), dice.between(-3e6, 3e6));
    const double width = dice.magnitude(0.1, ExactGrid::widest_m);
    const ExactGrid grid = ExactGrid::over(low, low + Vec2(width, width));
    const Vec2 at = low + Vec2(dice.unit(), dice.unit()) * width;
    const GridPoint p = grid.snapped(at.x(), at.y());
    EXPECT_GE(std::min(p.x, p.y), 0);
    EXPECT_LE(std::max(p.x, p.y), grid_end);
    EXPECT_LE((grid.place(p) - at).abs().largest(), grid.spacing_m() / 2);
    EXPECT_LE(grid.spacing_m(), std::max(0x1p-20, 2.001 * width * 0x1p-30));
    EXPECT_EQ(grid.snapped(grid.place(p).x(), grid.place(p).y()), p);
  }
  EXPECT_LE(ExactGrid::over({0, 0}, {ExactGrid::widest_m, 1}).spacing_m(), 0x1p-9);
}

// ---- the predicates ----

TEST(ExactPlan, DistinguishesPointsOnACircleFromTheirNeighbours) {
  // Integer points on a circle about as wide as the grid, from the triple (3, 4, 5).
  constexpr std::int32_t s = 100'000'000, m = 5 * s;
  const GridPoint a{m + 3 * s, m + 4 * s}, b{m - 4 * s, m + 3 * s}, c{m - 3 * s, m - 4 * s}, d{m + 5 * s, m};
  EXPECT_GT(doubled_area(a, b, c), 0);
  EXPECT_FALSE(in_circle(a, b, c, d));
  EXPECT_TRUE(in_circle(a, b, c, {d.x - 1, d.y}));
  EXPECT_FALSE(in_circle(a, b, c, {d.x + 1, d.y}));
  EXPECT_FALSE(in_circle(a, b, c, {d.x, d.y + 1}));
  EXPECT_EQ(doubled_area({0, 0}, {grid_end, grid_end - 1}, {grid_end - 1, grid_end - 2}), -1);
}

TEST(ExactPlan, PredicatesDoNotOverflowBetweenCornersOfTheGrid) {
  const GridPoint sw{0, 0}, se{grid_end, 0}, ne{grid_end, grid_end}, nw{0, grid_end};
  EXPECT_EQ(doubled_area(sw, se, ne), std::int64_t{1} << 60);
  EXPECT_FALSE(in_circle(sw, se, ne, nw));
  EXPECT_TRUE(in_circle(sw, se, ne, {1, grid_end}));
  EXPECT_TRUE(in_circle({0, 1}, {grid_end, 0}, {grid_end, grid_end}, {grid_end - 1, 1}));
}

TEST(ExactPlan, OnASegmentMeansWithinTwoStepsAndTheBox) {
  EXPECT_TRUE(is_on_way({0, 0}, {100, 50}, {40, 20}));
  EXPECT_TRUE(is_on_way({100, 50}, {0, 0}, {40, 23}));  // three steps above the line
  EXPECT_FALSE(is_on_way({0, 0}, {100, 50}, {40, 24}));
  EXPECT_FALSE(is_on_way({0, 0}, {100, 50}, {102, 51}));
  EXPECT_FALSE(is_on_way({0, 0}, {100, 0}, {40, 1}));
  constexpr std::int32_t far = 1 << ExactGrid::bits;
  EXPECT_TRUE(is_on_way({0, 0}, {far, far}, {far / 2 + 1, far / 2 - 1}));
  EXPECT_FALSE(is_on_way({0, 0}, {far, far}, {0, far}));
  EXPECT_FALSE(is_on_way({far, 0}, {0, far}, {far, far}));
}

TEST(ExactPlan, ACrossingIsTheNearestGridPointWithinBothBoxes) {
  EXPECT_EQ(crossing({0, 0}, {10, 10}, {0, 10}, {10, 0}), (GridPoint{5, 5}));
  EXPECT_EQ(crossing({0, 0}, {3, 1}, {2, 0}, {2, 2}), (GridPoint{2, 1}));
  Dice dice(3);
  int found = 0;
  while (found < 2000) {
    const std::int32_t end = dice.chance(0.5) ? 20 : grid_end;
    const auto p = scattered(dice, 4, end);
    const auto sign = [](std::int64_t x) { return x > 0 ? 1 : x < 0 ? -1 : 0; };
    if (sign(doubled_area(p[0], p[1], p[2])) * sign(doubled_area(p[0], p[1], p[3])) >= 0) continue;
    if (sign(doubled_area(p[2], p[3], p[0])) * sign(doubled_area(p[2], p[3], p[1])) >= 0) continue;
    ++found;
    const GridPoint at = crossing(p[0], p[1], p[2], p[3]);
    for (const int first : {0, 2}) {
      const GridPoint a = p[static_cast<std::size_t>(first)], b = p[static_cast<std::size_t>(first) + 1];
      EXPECT_TRUE(at.x >= std::min(a.x, b.x) && at.x <= std::max(a.x, b.x));
      EXPECT_TRUE(at.y >= std::min(a.y, b.y) && at.y <= std::max(a.y, b.y));
      // At most half a step along x and along y from the line.
      const double length = std::hypot(double{1} * b.x - a.x, double{1} * b.y - a.y);
      EXPECT_LE(std::abs(static_cast<double>(doubled_area(a, b, at))) / length, 0.70710679);
    }
  }
}

// ---- Delaunay ----

TEST(Triangulation, ThreePointsMakeATriangle) {
  const Triangulation t({{0, 0}, {0, 5}, {5, 0}});
  expect_sound(t);
}

TEST(Triangulation, PointsOnALineSpanNoPlane) {
  std::vector<GridPoint> points;
  for (std::int32_t i = 0; i < 100; ++i) points.push_back({3 * i, 7 * i});
  EXPECT_FALSE(Triangulation::span_a_plane(points));
  points.push_back({3, 8});
  EXPECT_TRUE(Triangulation::span_a_plane(points));
  const Triangulation t(points);
  expect_sound(t);
}

TEST(Triangulation, IsSoundForRandomPoints) {
  Dice dice(4);
  for (int i = 0; i < 300; ++i) {
    const std::size_t count = 3 + dice.below(200);
    const std::int32_t end = dice.chance(0.3) ? 15 : dice.chance(0.5) ? 1000 : grid_end;
    const auto points = scattered(dice, count, end);
    if (!Triangulation::span_a_plane(points)) continue;
    const Triangulation t(points);
    expect_sound(t);
    for (Vertex v = 0; v < points.size(); ++v) EXPECT_EQ(t.point(v), points[v]);
    if (HasFailure()) FAIL() << "run " << i;
  }
}

// The global property: no triangle's circumcircle contains any point.
TEST(Triangulation, EveryCircumcircleIsEmpty) {
  Dice dice(5);
  for (const std::int32_t end : {12, 3000, grid_end}) {
    const Triangulation t(scattered(dice, 150, end));
    for (std::uint32_t i = 0; i < t.triangles().size(); ++i) {
      if (!t.is_real(i)) continue;
      const auto& c = t.triangles()[i].corner;
      for (Vertex v = 0; v < t.vertex_count(); ++v) {
        EXPECT_FALSE(in_circle(t.point(c[0]), t.point(c[1]), t.point(c[2]), t.point(v)));
      }
    }
  }
}

// The dual of Boost's Voronoi diagram has an edge, possibly of zero length, for each side.
TEST(Triangulation, AgreesWithTheVoronoiDiagramOfBoost) {
  Dice dice(6);
  const auto points = scattered(dice, 20000, grid_end);
  const Triangulation t(points);
  std::set<std::array<Vertex, 2>> ours, theirs;
  for (std::uint32_t i = 0; i < t.triangles().size(); ++i) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const Vertex a = t.from({i, k}), b = t.to({i, k});
      if (a < b && b != Triangulation::infinity) ours.insert({a, b});
    }
  }
  boost::polygon::voronoi_diagram<double> diagram;
  boost::polygon::construct_voronoi(points.begin(), points.end(), &diagram);
  for (const auto& edge : diagram.edges()) {
    const auto a = static_cast<Vertex>(edge.cell()->source_index());
    const auto b = static_cast<Vertex>(edge.twin()->cell()->source_index());
    if (a < b) theirs.insert({a, b});
  }
  EXPECT_EQ(ours, theirs);
}

TEST(Triangulation, IsSoundForGridsOfCocircularPoints) {
  for (const std::int32_t step : {1, 1000, 10'000'000}) {
    std::vector<GridPoint> points;
    for (std::int32_t i = 0; i < 40; ++i) {
      for (std::int32_t j = 0; j < 60; ++j) points.push_back({i * step, j * step});
    }
    const Triangulation t(points);
    expect_sound(t);
    // Every square is cut once: no side is longer than its diagonal.
    for (std::uint32_t i = 0; i < t.triangles().size(); ++i) {
      if (!t.is_real(i)) continue;
      for (std::uint32_t k = 0; k < 3; ++k) {
        const GridPoint a = t.point(t.from({i, k})), b = t.point(t.to({i, k}));
        EXPECT_LE(std::max(std::abs(a.x - b.x), std::abs(a.y - b.y)), step);
      }
    }
  }
}

TEST(Triangulation, IsSoundForPointsOfOneCircle) {
  std::vector<GridPoint> points;
  // All integer points on the circle of radius 5 x 13 x 17 x 29.
  constexpr std::int32_t r = 5 * 13 * 17 * 29;
  for (std::int32_t x = -r; x <= r; ++x) {
    const auto y = static_cast<std::int32_t>(std::lround(std::sqrt(double{1} * r * r - double{1} * x * x)));
    if (std::int64_t{x} * x + std::int64_t{y} * y != std::int64_t{r} * r) continue;
    points.push_back({x + r, r + y});
    if (y != 0) points.push_back({x + r, r - y});
  }
  EXPECT_EQ(points.size(), 324U);  // 4 (2 + 1)^4
  expect_sound(Triangulation(points));
}

TEST(Triangulation, IsSoundForDistantLinesOfPoints) {
  std::vector<GridPoint> points;
  for (std::int32_t i = 0; i < 2000; ++i) {
    points.push_back({i, 0});
    points.push_back({grid_end / 2 + 3 * i, grid_end});
  }
  expect_sound(Triangulation(points));
}

TEST(Triangulation, InsertsFurtherPointsOnce) {
  Dice dice(7);
  for (int i = 0; i < 100; ++i) {
    const std::int32_t end = dice.chance(0.5) ? 20 : grid_end;
    auto points = scattered(dice, 100, end);
    if (!Triangulation::span_a_plane({points.data(), 50})) continue;
    Triangulation t({points.begin(), points.begin() + 50});
    for (std::size_t k = 50; k < 100; ++k) {
      const auto inserted = t.insert(points[k]);
      EXPECT_TRUE(inserted.is_new);
      EXPECT_EQ(inserted.vertex, k);
    }
    for (Vertex v = 0; v < 100; ++v) {
      const auto again = t.insert(points[v]);
      EXPECT_FALSE(again.is_new);
      EXPECT_EQ(again.vertex, v);
    }
    expect_sound(t);
  }
}

// Enough points to notice a quadratic step.
TEST(Triangulation, IsSoundForManyPoints) {
  Dice dice(8);
  expect_sound(Triangulation(scattered(dice, 100'000, grid_end)));
}

// The check itself must be able to fail.
TEST(Triangulation, ASideThatIsNotDelaunayIsFound) {
  Triangulation t({{0, 0}, {10, 0}, {12, 10}, {0, 10}, {5, 4}});
  expect_sound(t);
  std::size_t flipped = 0;
  for (std::uint32_t i = 0; i < t.triangles().size() && flipped == 0; ++i) {
    for (std::uint32_t k = 0; k < 3 && flipped == 0; ++k) {
      if (!t.can_flip({i, k})) continue;
      t.flip({i, k});
      ++flipped;
      bool found = false;
      for (std::uint32_t j = 0; j < t.triangles().size(); ++j) {
        for (std::uint32_t m = 0; m < 3; ++m) found = found || t.needs_flip({j, m});
      }
      EXPECT_TRUE(found);
    }
  }
  EXPECT_EQ(flipped, 1U);
}

}  // namespace
}  // namespace talus::triangulation_test
