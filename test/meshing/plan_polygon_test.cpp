#include "talus/meshing/plan_polygon.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "support/dice.hpp"
#include "talus/meshing/point_buckets.hpp"

namespace talus::plan_polygon_test {
namespace {

using namespace testing_tools;
using Ring = std::vector<Vec3>;

/// A star-shaped ring of n corners, which does not cross itself.
Ring star(Dice& dice, const Vec2& centre, double radius, int n, bool clockwise = false) {
  Ring ring;
  for (int k = 0; k < n; ++k) {
    const double angle = (clockwise ? -1 : 1) * 2 * std::numbers::pi * (k + dice.between(0, 0.9)) / n;
    const double r = radius * dice.between(0.3, 1);
    ring.emplace_back(centre.x() + r * std::cos(angle), centre.y() + r * std::sin(angle), dice.unit());
  }
  return ring;
}

/// Whether a ring contains p, from the angle it turns about p: independent of the method under test.
bool winds_about(const Ring& ring, const Vec2& p) {
  double turned = 0;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Vec2 a = Vec2(ring[k].xy()) - p, b = Vec2(ring[(k + 1) % ring.size()].xy()) - p;
    turned += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
  }
  return std::abs(turned) > std::numbers::pi;
}

TEST(PlanPolygon, ContainsWhatItsOuterRingWindsAboutExceptHoles) {
  Dice dice(3);
  for (int round = 0; round < 60; ++round) {
    const Vec2 centre(dice.between(-5, 5), dice.between(-5, 5));
    const Ring outer = star(dice, centre, 100, 3 + static_cast<int>(dice.below(200)), dice.chance(0.5));
    const Ring hole = star(dice, centre, 8, 3 + static_cast<int>(dice.below(20)), dice.chance(0.5));
    const PlanPolygon polygon(std::vector<Ring>{outer, hole});
    for (int k = 0; k < 500; ++k) {
      const Vec2 p(dice.between(-110, 110), dice.between(-110, 110));
      EXPECT_EQ(polygon.contains(p), winds_about(outer, p) != winds_about(hole, p)) << round;
    }
  }
}

TEST(PlanPolygon, AnAnnulusHasItsArea) {
  // Radii of 10 and 5 m, as polygons of 720 corners; grid points 0.05 m apart.
  std::vector<Ring> rings(2);
  for (int k = 0; k < 720; ++k) {
    const double a = k * std::numbers::pi / 360;
    rings[0].emplace_back(10 * std::cos(a), 10 * std::sin(a), 0);
    rings[1].emplace_back(5 * std::cos(a), 5 * std::sin(a), 0);
  }
  const PlanGrid grid{Vec2(-11.02, -11.01), 0.05, 0.05, 441, 441};
  std::uint64_t points = 0;
  visit_points_within(PlanPolygon(rings), grid,
                      [&](std::uint32_t, std::uint32_t from, std::uint32_t to) { points += to - from; });
  // Points on the borders (94 m in all, one every 0.05 m) may fall on either side: less than 1 %.
  EXPECT_NEAR(static_cast<double>(points) * 0.0025, 75 * std::numbers::pi, 1);
}

TEST(PlanPolygon, VisitsTheGridPointsThatItContains) {
  Dice dice(5);
  for (int round = 0; round < 40; ++round) {
    const PlanPolygon polygon(
        std::vector<Ring>{star(dice, {2600000, 1200000}, 40, 3 + static_cast<int>(dice.below(60)))});
    const PlanGrid grid{Vec2(2600000 - dice.between(0, 60), 1200000 - dice.between(0, 60)), dice.between(0.5, 4),
                        dice.between(0.5, 4), 1 + static_cast<std::uint32_t>(dice.below(40)),
                        1 + static_cast<std::uint32_t>(dice.below(40))};
    std::set<std::pair<std::uint32_t, std::uint32_t>> visited;
    visit_points_within(polygon, grid, [&](std::uint32_t row, std::uint32_t from, std::uint32_t to) {
      for (std::uint32_t column = from; column < to; ++column) {
        EXPECT_TRUE(visited.emplace(row, column).second);
      }
    });
    for (std::uint32_t row = 0; row < grid.rows; ++row) {
      for (std::uint32_t column = 0; column < grid.columns; ++column) {
        EXPECT_EQ(visited.contains({row, column}), polygon.contains({grid.x(column), grid.y(row)}));
      }
    }
  }
}

// A square cut by a crooked line: every grid point, also on corners and on the cut, is in exactly one half. Points on
// the southern and western borders belong to the square, those on the northern and eastern borders do not.
TEST(PlanPolygon, NeighboursShareNoPointAndMissNone) {
  const Ring cut{{4, 0, 0}, {6, 3, 0}, {3, 5, 0}, {5, 5, 0}, {2, 8, 0}, {7, 10, 0}};
  Ring left = cut, right(cut.rbegin(), cut.rend());
  left.insert(left.end(), {{0, 10, 0}, {0, 0, 0}});
  right.insert(right.end(), {{10, 0, 0}, {10, 10, 0}});
  const PlanPolygon a(std::vector<Ring>{left}), b(std::vector<Ring>{right});
  for (int i = 0; i <= 400; ++i) {
    for (int j = 0; j <= 400; ++j) {
      const Vec2 p(0.025 * i, 0.025 * j);
      EXPECT_EQ(int{a.contains(p)} + int{b.contains(p)}, i < 400 && j < 400 ? 1 : 0) << p;
    }
  }
}

TEST(PlanPolygon, WithoutAreaContainsNothing) {
  EXPECT_FALSE(PlanPolygon(std::vector<Ring>{}).contains({0, 0}));
  EXPECT_FALSE(PlanPolygon(std::vector<Ring>{{{0, 0, 0}, {5, 0, 0}, {2, 0, 0}}}).contains({1, 0}));
}

TEST(PlanPolygon, TallEdgesDoNotTakeMuchMemory) {
  // A comb of 20,000 teeth, each as high as the polygon: the entries in bands must stay few.
  Ring comb;
  for (int k = 0; k < 20'000; ++k) {
    comb.emplace_back(k, 0, 0);
    comb.emplace_back(k + 0.5, 100, 0);
  }
  comb.emplace_back(20'000, -1, 0);
  comb.emplace_back(0, -1, 0);
  const PlanPolygon polygon(std::vector<Ring>{comb});
  EXPECT_TRUE(polygon.contains({10'000.5, 50}));
  EXPECT_FALSE(polygon.contains({10'000.01, 50}));
}

TEST(SelfCrossing, IsFoundAtItsPlace) {
  using Points = std::vector<Vec2>;
  EXPECT_EQ(self_crossing(Points{{0, 0}, {1, 0}, {1, 1}, {0, 1}}), std::nullopt);
  EXPECT_EQ(self_crossing(Points{{0, 0}, {1, 0}, {1, 1}}), std::nullopt);
  EXPECT_LT((self_crossing(Points{{0, 0}, {10, 10}, {10, 0}, {0, 10}}).value() - Vec2(5, 5)).norm(), 1e-12);
  // A corner that touches another side; a side that doubles back over the one before.
  EXPECT_EQ(self_crossing(Points{{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}).value(), Vec2(2, 0));
  EXPECT_EQ(self_crossing(Points{{0, 0}, {4, 0}, {2, 0}, {2, 3}}).value(), Vec2(4, 0));
  // The result does not depend on the first corner.
  EXPECT_TRUE(self_crossing(Points{{2, 0}, {2, 3}, {0, 0}, {4, 0}}));
  EXPECT_TRUE(self_crossing(Points{{4, 0}, {2, 0}, {2, 3}, {0, 0}}));
  Dice dice(8);
  for (int round = 0; round < 50; ++round) {
    Points ring;
    for (const Vec3& p : star(dice, {0, 0}, 10, 30)) ring.emplace_back(p.xy());
    EXPECT_EQ(self_crossing(ring), std::nullopt);
    std::swap(ring[3], ring[12]);
    EXPECT_NE(self_crossing(ring), std::nullopt);
  }
}

TEST(LineCrossing, IsFoundAtItsPlace) {
  using Points = std::vector<Vec2>;
  EXPECT_EQ(line_crossing(Points{}), std::nullopt);
  EXPECT_EQ(line_crossing(Points{{0, 0}, {10, -5}}), std::nullopt);
  EXPECT_EQ(line_crossing(Points{{0, 0}, {10, 0}, {10, -10}, {8, -12}, {20, -20}}), std::nullopt) << "an overhang";
  EXPECT_LT((line_crossing(Points{{0, 0}, {10, -10}, {10, 0}, {0, -10}}).value() - Vec2(5, -5)).norm(), 1e-12);
  EXPECT_EQ(line_crossing(Points{{0, 0}, {10, 0}, {5, 0}}).value(), Vec2(10, 0)) << "doubles back";
  EXPECT_EQ(line_crossing(Points{{0, 0}, {10, 0}, {10, 5}, {0, 0}}).value(), Vec2(0, 0)) << "its ends touch";
  // Open rings, whose pieces begin in any order along x.
  Dice dice(9);
  for (int round = 0; round < 50; ++round) {
    Points line;
    for (const Vec3& p : star(dice, {0, 0}, 10, 30)) line.emplace_back(p.xy());
    EXPECT_EQ(line_crossing(line), std::nullopt);
    std::swap(line[3], line[12]);
    EXPECT_NE(line_crossing(line), std::nullopt);
  }
}

TEST(LineCrossing, IsFastForASlopeOfAMillionVertices) {
  std::vector<Vec2> line;
  for (int k = 0; k < 1'000'000; ++k) line.emplace_back(k, k % 2);
  EXPECT_EQ(line_crossing(line), std::nullopt);
}

TEST(PointBuckets, VisitEveryPointOfABoxOnceAndFewOthers) {
  Dice dice(21);
  std::vector<Vec2> points;
  for (int k = 0; k < 5000; ++k) points.emplace_back(dice.between(0, 1000), dice.between(0, 20));
  const PointBuckets buckets(points);
  for (int round = 0; round < 100; ++round) {
    const Vec2 low(dice.between(-50, 900), dice.between(-5, 18)), high = low + Vec2(dice.between(0, 150), dice.unit());
    std::multiset<std::uint32_t> visited;
    buckets.visit_near(low, high, [&](std::uint32_t k) { visited.insert(k); });
    std::size_t within = 0;
    for (std::uint32_t k = 0; k < points.size(); ++k) {
      const bool is_in = low.is_at_most(points[k]) && points[k].is_at_most(high);
      within += is_in ? 1 : 0;
      if (is_in) {
        EXPECT_EQ(visited.count(k), 1U);
      }
    }
    EXPECT_LT(visited.size(), 500 + 2 * within);
  }
  const PointBuckets one(std::span<const Vec2>(points).first(1)), none(std::span<const Vec2>{});
  int found = 0;
  one.visit_near(points[0], points[0], [&](std::uint32_t) { ++found; });
  none.visit_near({0, 0}, {1, 1}, [&](std::uint32_t) { ++found; });
  EXPECT_EQ(found, 1);
}

// A comb with so many teeth that a grid row has more crossings than points.
TEST(PlanPolygon, VisitsTheSamePointsWithMoreCrossingsThanPoints) {
  Dice dice(11);
  Ring comb;
  for (int k = 0; k < 4000; ++k)
    comb.emplace_back(0.01 * k + dice.between(0, 0.009), dice.between(0, 1) + 20 * (k % 2), 0);
  comb.emplace_back(41, -5, 0);
  comb.emplace_back(-1, -5, 0);
  const PlanPolygon polygon(std::vector<Ring>{comb});
  const PlanGrid grid{{-3, -7}, 0.31, 0.27, 150, 120};
  std::vector<std::vector<bool>> within(grid.rows, std::vector<bool>(grid.columns));
  std::size_t runs = 0;
  visit_points_within(polygon, grid, [&](std::uint32_t row, std::uint32_t from, std::uint32_t to) {
    ++runs;
    ASSERT_LT(from, to);
    ASSERT_LE(to, grid.columns);
    for (std::uint32_t column = from; column < to; ++column) {
      EXPECT_FALSE(within[row][column]) << "twice";
      within[row][column] = true;
    }
  });
  EXPECT_GT(runs, 1000U);
  for (std::uint32_t row = 0; row < grid.rows; ++row) {
    for (std::uint32_t column = 0; column < grid.columns; ++column)
      ASSERT_EQ(within[row][column], polygon.contains({grid.x(column), grid.y(row)})) << row << ' ' << column;
  }
}

}  // namespace
}  // namespace talus::plan_polygon_test
