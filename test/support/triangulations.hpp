#pragma once
// Checks what is true of every triangulation, in exact arithmetic; and points to triangulate.

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "support/dice.hpp"
#include "talus/meshing/triangulation.hpp"

namespace talus::testing_tools {

inline constexpr std::int32_t grid_end = 1 << ExactGrid::bits;

/// Distinct random points of a grid from 0 to `end`. On a small grid many are on common lines and circles.
[[nodiscard]] inline std::vector<GridPoint> scattered(Dice& dice, std::size_t count, std::int32_t end) {
  std::set<GridPoint> seen;
  std::vector<GridPoint> points;
  while (points.size() < count) {
    const auto coordinate = [&] { return static_cast<std::int32_t>(dice.below(static_cast<std::size_t>(end) + 1)); };
    const GridPoint p{coordinate(), coordinate()};
    if (seen.insert(p).second) points.push_back(p);
  }
  return points;
}

/// Andrew's monotone chain, counter-clockwise; corners only.
[[nodiscard]] inline std::vector<GridPoint> hull_of(std::vector<GridPoint> points) {
  std::sort(points.begin(), points.end());
  std::vector<GridPoint> hull;
  for (int half = 0; half < 2; ++half) {
    const std::size_t begin = hull.size();
    for (const GridPoint p : points) {
      while (hull.size() >= begin + 2 && doubled_area(hull[hull.size() - 2], hull.back(), p) <= 0) hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

[[nodiscard]] inline Wide doubled_area_of(const std::vector<GridPoint>& polygon) {
  Wide area = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const GridPoint a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    area += Wide{a.x} * b.y - Wide{a.y} * b.x;
  }
  return area;
}

/// Neighbours link to each other, triangles are counter-clockwise and cover the hull once, Euler's formula is true, and
/// every side that is not fixed is Delaunay.
inline void expect_sound(const Triangulation& t) {
  std::vector<GridPoint> points;
  for (std::uint32_t v = 0; v < t.vertex_count(); ++v) points.push_back(t.point(v));
  std::size_t real = 0, rim = 0, twins_apart = 0, clockwise = 0, not_delaunay = 0, half_fixed = 0;
  Wide area = 0;
  for (std::uint32_t i = 0; i < t.triangles().size(); ++i) {
    const auto& [corner, neighbour] = t.triangles()[i];
    for (std::uint32_t k = 0; k < 3; ++k) {
      const Triangulation::Side side{i, k}, twin = t.twin(side);
      twins_apart += t.from(twin) != t.to(side) || t.to(twin) != t.from(side) || t.twin(twin).triangle != i;
      half_fixed += t.is_fixed(side) != t.is_fixed(twin);
      not_delaunay += !t.is_fixed(side) && t.needs_flip(side);
      rim += t.is_real(i) && !t.is_real(neighbour[k]);
    }
    if (!t.is_real(i)) continue;
    ++real;
    const std::int64_t own = doubled_area(t.point(corner[0]), t.point(corner[1]), t.point(corner[2]));
    clockwise += own <= 0;
    area += own;
  }
  EXPECT_EQ(twins_apart, 0U);
  EXPECT_EQ(clockwise, 0U);
  EXPECT_EQ(half_fixed, 0U);
  EXPECT_EQ(not_delaunay, 0U);
  // V - E + F = 2 with the outside as a face: n vertices, h of them on the rim, make 2 n - 2 - h triangles.
  EXPECT_EQ(real, 2 * t.vertex_count() - 2 - rim);
  EXPECT_EQ(t.triangles().size(), 2 * t.vertex_count() - 2);
  EXPECT_TRUE(area == doubled_area_of(hull_of(points)));
}

}  // namespace talus::testing_tools
