#include "talus/results/map_grid.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "support/dice.hpp"

namespace talus::map_grid_test {
namespace {

using testing_tools::Dice;

struct Stay {
  MapCell cell;
  double enter, leave;
};

std::vector<Stay> stays(const MapGrid& grid, const PathPiece& piece) {
  std::vector<Stay> list;
  walk(grid, piece, [&](MapCell cell, double enter, double leave) { list.push_back({cell, enter, leave}); });
  return list;
}

PathPiece piece_of(const Vec3& p, const Vec3& v, const Vec3& a, double duration) {
  return {{p, v, a}, duration, 0, Vec3{}, false};
}

TEST(MapGrid, HasBordersAtMultiplesOfTheCellInUserCoordinates) {
  LocalFrame frame;
  frame.origin = {2600 * 1024.0, -1024, 0};
  const MapGrid grid = MapGrid::at_multiples(2.5, frame, Vec2(-311.3, 7.1));
  EXPECT_LE(grid.border(0, 0), -311.3);
  EXPECT_GT(grid.border(0, 1), -311.3);
  EXPECT_EQ(grid.index(1, 7.1), 0);
  EXPECT_EQ(std::remainder(grid.border(0, 7) + frame.origin.x(), 2.5), 0);
  EXPECT_EQ(std::remainder(grid.border(1, -3) + frame.origin.y(), 2.5), 0);
  EXPECT_EQ(grid.origin().x(), grid.border(0, 0) + frame.origin.x());
}

TEST(MapGrid, OfARasterHasItsNodesAtCellCentres) {
  LocalFrame frame;
  frame.origin = {2600 * 1024.0, -1024, 0};
  const MapGrid grid = MapGrid::around_nodes({-311.25, 7.5}, {2.5, 5}, frame);
  EXPECT_EQ(grid.origin(), Vec2(2600 * 1024.0 - 312.5, -1024 + 5));
  for (const int column : {0, 1, 7}) {
    for (const int row : {0, 1, 9}) {
      EXPECT_EQ(grid.cell_at({-311.25 + 2.5 * column, 7.5 + 5 * row, 0}), (MapCell{column, row}));
    }
  }
  EXPECT_EQ(grid.cell_at({-312.5, 5, 0}), (MapCell{0, 0}));
  EXPECT_EQ(grid.cell_at({-312.51, 4.99, 0}), (MapCell{-1, -1}));
  EXPECT_FALSE(grid == MapGrid::around_nodes({-311.25, 7.5}, {2.5, 2.5}, frame));
}

TEST(MapGrid, CellsIncludeTheirLowerBordersOnly) {
  const MapGrid grid({10, 20}, 0.5, {});
  EXPECT_EQ(grid.cell_at({10, 20, 0}), (MapCell{0, 0}));
  EXPECT_EQ(grid.cell_at({10.5, 20.49, 7}), (MapCell{1, 0}));
  EXPECT_EQ(grid.cell_at({9.99, 19.5, 0}), (MapCell{-1, -1}));
}

TEST(MapWalk, FollowsAFlightStraightOverTheCells) {
  const MapGrid grid({0, 0}, 1, {});
  const auto list = stays(grid, piece_of({0.5, 0.5, 9}, {1, 0.5, 3}, {0, 0, -9.81}, 2));
  ASSERT_EQ(list.size(), 4U);
  EXPECT_EQ(list[0].cell, (MapCell{0, 0}));
  EXPECT_DOUBLE_EQ(list[0].leave, 0.5);
  EXPECT_EQ(list[1].cell, (MapCell{1, 0}));
  EXPECT_DOUBLE_EQ(list[1].leave, 1);
  EXPECT_EQ(list[2].cell, (MapCell{1, 1}));
  EXPECT_EQ(list[3].cell, (MapCell{2, 1}));
  EXPECT_EQ(list[3].leave, 2);
}

TEST(MapWalk, CrossesACornerToTheOppositeCell) {
  const MapGrid grid({0, 0}, 1, {});
  const auto list = stays(grid, piece_of({0.5, 0.5, 0}, {1, 1, 0}, {0, 0, 0}, 1));
  ASSERT_EQ(list.size(), 2U);
  EXPECT_EQ(list[1].cell, (MapCell{1, 1}));
}

TEST(MapWalk, DoesNotVisitCellsThatAreOnlyTouched) {
  const MapGrid grid({0, 0}, 1, {});
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      const MapCell ahead{x > 0 ? 4 : 3, y > 0 ? 7 : 6};
      for (const double beside : {0.0, 1e-15, -1e-15, 1e-10, -1e-10}) {
        const Vec3 corner(4 + beside, 7 - beside, 0), way(0.5 * x, 0.3 * y, 0);
        const auto from_it = stays(grid, piece_of(corner, way, Vec3{}, 1));
        ASSERT_EQ(from_it.size(), 1U) << x << ' ' << y << ' ' << beside;
        EXPECT_EQ(from_it[0].cell, ahead);
        EXPECT_EQ(from_it[0].enter, 0);
        const auto to_it = stays(grid, piece_of(corner + way, -way, Vec3{}, 1));
        ASSERT_EQ(to_it.size(), 1U) << x << ' ' << y << ' ' << beside;
        EXPECT_EQ(to_it[0].cell, ahead);
        EXPECT_EQ(to_it[0].leave, 1);
        // Through it, slowed or not.
        for (const double braked : {0.0, -0.4}) {
          const PathPiece piece = piece_of(corner - way, way, braked * way, 2);
          const auto through = stays(grid, piece);
          ASSERT_EQ(through.size(), 2U) << x << ' ' << y << ' ' << beside;
          EXPECT_EQ(through[1].cell, ahead);
          EXPECT_EQ(through[0].leave, through[1].enter);
        }
      }
    }
  }
}

TEST(MapWalk, StaysInOneCellForARockThatStandsOrFallsVertically) {
  const MapGrid grid({0, 0}, 1, {});
  const auto list = stays(grid, piece_of({1, 3, 5}, {0, 0, 2}, {0, 0, -9.81}, 1.5));
  ASSERT_EQ(list.size(), 1U);
  EXPECT_EQ(list[0].cell, (MapCell{1, 3}));
  EXPECT_EQ(list[0].enter, 0);
  EXPECT_EQ(list[0].leave, 1.5);
}

TEST(MapWalk, CrossesTheSameBordersUphillAndBackDown) {
  const MapGrid grid({0, 0}, 1, {});
  const auto list = stays(grid, piece_of({0.5, 0.5, 0}, {-2, 0, 0}, {1, 0, 0}, 4));  // to x = -1.5 and back
  ASSERT_EQ(list.size(), 5U);
  const std::int32_t columns[] = {0, -1, -2, -1, 0};
  for (std::size_t k = 0; k < 5; ++k) EXPECT_EQ(list[k].cell.column, columns[k]);
  EXPECT_NEAR(list[0].leave + list[3].leave, 4, 1e-12);
}

// Compared with sampling at very many times, on trajectories like those on the ground: curved, turning, from rest.
TEST(MapWalk, AgreesWithDenseSampling) {
  Dice dice(5);
  std::size_t seen = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    LocalFrame frame;
    if (trial % 2 == 0) frame.origin = {2'600'960, 1'199'104, 0};
    const Vec2 low(dice.between(-40, 0), -20), sides(dice.magnitude(0.1, 10), dice.magnitude(0.1, 10));
    const MapGrid grid =
        trial % 3 == 0 ? MapGrid::around_nodes(low, sides, frame) : MapGrid::at_multiples(sides.x(), frame, low);
    const bool flies = dice.chance(0.4);
    Vec3 v = dice.in_cube(8), a = flies ? Vec3(0, 0, -9.81) : dice.in_cube(6);
    if (dice.chance(0.1)) v = {};
    if (dice.chance(0.1)) v.x() = 0;
    if (dice.chance(0.1)) a.y() = 0;
    if (dice.chance(0.2)) a = Vec3(-dice.between(0.2, 2) * v.xy(), a.z());  // decelerated: comes back on its own track
    Vec3 p = dice.in_cube(30);
    if (dice.chance(0.2)) p.x() = grid.border(0, grid.index(0, p.x()));  // starts on a border
    const PathPiece piece = piece_of(p, v, a, dice.magnitude(1e-3, 4));
    const auto list = stays(grid, piece);

    EXPECT_EQ(list.front().enter, 0);
    EXPECT_EQ(list.back().leave, piece.duration);
    for (std::size_t k = 0; k < list.size(); ++k) {
      ASSERT_LE(list[k].enter, list[k].leave);
      if (k == 0) continue;
      ASSERT_EQ(list[k].enter, list[k - 1].leave);
      ASSERT_LE(std::abs(list[k].cell.column - list[k - 1].cell.column), 1);
      ASSERT_LE(std::abs(list[k].cell.row - list[k - 1].cell.row), 1);
    }
    std::size_t k = 0;
    constexpr int looks = 400;
    for (int i = 0; i <= looks; ++i) {
      const double t = piece.duration * i / looks;
      while (k + 1 < list.size() && list[k].leave < t) ++k;
      const Vec3 q = piece.path.at(t);
      const MapCell there = list[k].cell;
      // Within rounding of a border either side is correct.
      const double slack = 1e-8;
      const auto inside = [&](std::size_t axis, std::int32_t place) {
        return q[axis] >= grid.border(axis, place) - slack && q[axis] <= grid.border(axis, place + 1) + slack;
      };
      ASSERT_TRUE(inside(0, there.column) && inside(1, there.row))
          << "trial " << trial << " t " << t << " x " << q.x() << " y " << q.y() << " cell " << there.column << ' '
          << there.row;
      ++seen;
    }
  }
  EXPECT_EQ(seen, 3000U * 401);
}

}  // namespace
}  // namespace talus::map_grid_test
