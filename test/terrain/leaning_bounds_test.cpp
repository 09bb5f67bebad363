#include "talus/terrain/leaning_bounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "support/dice.hpp"
#include "talus/terrain/facet_contact.hpp"

namespace talus::leaning_bounds_test {
namespace {

using testing_tools::Dice;

/// A tree over triangles, with or without leaning bounds.
struct Tree {
  Tree(const std::vector<Triangle>& triangles, bool leans) : bvh(boxes_of(triangles)) {
    if (leans) {
      add_leaning_bounds(bvh, [&](std::uint32_t place) -> const Triangle& { return triangles[bvh.order()[place]]; });
    }
  }
  static std::vector<Box> boxes_of(const std::vector<Triangle>& triangles) {
    std::vector<Box> boxes(triangles.size());
    for (std::size_t k = 0; k < triangles.size(); ++k) {
      for (const Vec3& corner : triangles[k]) boxes[k].grow(corner);
    }
    return boxes;
  }
  [[nodiscard]] std::set<std::uint32_t> along(const Parabola& path, double pad, double t_end) const {
    std::set<std::uint32_t> met;
    double t_max = t_end;
    bvh.visit_flight(path, pad, t_max, [&](std::uint32_t first, std::uint32_t last, double&) {
      met.insert(bvh.order().begin() + first, bvh.order().begin() + last);
    });
    return met;
  }
  [[nodiscard]] std::set<std::uint32_t> under(const Parabola& path, double t_end, double worth) const {
    std::set<std::uint32_t> met;
    bvh.visit_under(
        path, t_end, [&] { return worth; },
        [&](std::uint32_t first, std::uint32_t last) {
          met.insert(bvh.order().begin() + first, bvh.order().begin() + last);
        });
    return met;
  }
  Bvh bvh;
};

/// Facets of any direction about a slope of 45 degrees, including roofs and vertical ones.
std::vector<Triangle> broken_slope(Dice& dice, std::size_t count) {
  std::vector<Triangle> triangles(count);
  for (Triangle& triangle : triangles) {
    Vec3 middle = dice.in_cube(50);
    middle.z() = -middle.x() + dice.between(-2, 2);
    for (Vec3& corner : triangle) corner = middle + 2 * dice.in_cube(1);
  }
  return triangles;
}

/// 100 x 100 m of a slope of 45 degrees, two facets per square metre, rough by a tenth of a metre.
std::vector<Triangle> slope(Dice& dice) {
  constexpr int side = 100;
  std::vector<Vec3> nodes;
  for (int j = 0; j <= side; ++j) {
    for (int i = 0; i <= side; ++i) nodes.emplace_back(i, j, side - i + dice.between(0, 0.1));
  }
  std::vector<Triangle> triangles;
  for (int j = 0; j < side; ++j) {
    for (int i = 0; i < side; ++i) {
      const auto at = [&](int di, int dj) { return nodes[static_cast<std::size_t>((j + dj) * (side + 1) + i + di)]; };
      triangles.push_back({at(0, 0), at(1, 0), at(1, 1)});
      triangles.push_back({at(0, 0), at(1, 1), at(0, 1)});
    }
  }
  return triangles;
}

TEST(LeaningBounds, SkipNoFacetThatAFlightComesNear) {
  Dice dice(271);
  const auto triangles = broken_slope(dice, 2000);
  const Tree tree(triangles, true);
  std::size_t near = 0;
  for (int i = 0; i < 300; ++i) {
    Parabola path{dice.in_cube(50), dice.between(0, 40) * dice.direction(), {0, 0, dice.chance(0.8) ? -9.81 : 0.0}};
    path.p.z() = -path.p.x() + dice.between(-1, 8);
    const double pad = dice.between(0, 2), t_end = dice.between(0.1, 4);
    const auto met = tree.along(path, pad, t_end);
    for (int k = 0; k <= 100; ++k) {
      const Vec3 q = path.at(t_end * k / 100);
      for (std::uint32_t n = 0; n < triangles.size(); ++n) {
        if ((closest_point(triangles[n], q) - q).norm() >= 0.999 * pad) continue;
        ASSERT_TRUE(met.contains(n)) << "flight " << i << ", facet " << n;
        ++near;
      }
    }
  }
  EXPECT_GT(near, 1000U);
}

TEST(LeaningBounds, SkipNoFacetFarUnderAFlight) {
  Dice dice(828);
  const auto triangles = broken_slope(dice, 2000);
  const Tree tree(triangles, true);
  for (std::uint32_t n = 0; n < triangles.size(); ++n) {
    // A flight that passes over a point of the facet at `height`.
    const double first = dice.between(0, 1), second = dice.between(0, 1 - first);
    const auto& [a, b, c] = triangles[n];
    const double worth = dice.between(0, 6), height = worth + dice.between(0.01, 5);
    const Vec3 above = a + first * (b - a) + second * (c - a) + Vec3(0, 0, height);
    const double t_end = dice.between(0.1, 4), t = dice.between(0, t_end);
    Parabola path{above, dice.between(0, 40) * dice.direction(), {0, 0, -9.81}};
    path.p = above - t * path.v - (0.5 * t * t) * path.a;
    ASSERT_TRUE(tree.under(path, t_end, worth).contains(n)) << n;
  }
}

// A flight a metre above a slope passes through the boxes of all facets under it, but near none of these.
TEST(LeaningBounds, SkipTheSlopeUnderAFlight) {
  Dice dice(314);
  const auto triangles = slope(dice);
  const Tree leaning(triangles, true), boxes(triangles, false);
  const Parabola path{{10, 50, 91.5}, {20, 1, -20}, {0, 0, -0.01}};
  EXPECT_EQ(leaning.along(path, 0.5, 4).size(), 0U);
  EXPECT_GT(boxes.along(path, 0.5, 4).size(), 200U);
  EXPECT_EQ(leaning.under(path, 4, 2).size(), 0U);
  EXPECT_GT(boxes.under(path, 4, 2).size(), 10U);
}

}  // namespace
}  // namespace talus::leaning_bounds_test
