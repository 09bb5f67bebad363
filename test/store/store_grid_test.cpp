// The cells of lines, boxes and pieces of paths.

#include "talus/store/store_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/dice.hpp"

namespace talus {
namespace {

using testing_tools::Dice;

std::uint32_t cell_at(const StoreGrid& grid, const Vec2& place) {
  CellSet cells(grid.count());
  grid.add_box({place, place}, cells);
  std::vector<std::uint32_t> found;
  cells.for_runs([&](std::uint32_t first, std::uint32_t last) { found.insert(found.end(), {first, last}); });
  EXPECT_EQ(found, (std::vector<std::uint32_t>{found.front(), found.front()}));
  return found.front();
}
std::size_t count_of(const CellSet& cells) {
  std::size_t count = 0;
  cells.for_runs([&](std::uint32_t first, std::uint32_t last) { count += last - first + 1; });
  return count;
}

TEST(StoreGrid, HasCellsOfAPowerOfTwo) {
  const StoreGrid grid = StoreGrid::over({{-100, 50}, {900, 300}}, false);  // 8 m
  EXPECT_EQ(grid.count(), 125U * 32U);
  EXPECT_EQ(cell_at(grid, {-99, 51}), cell_at(grid, {-93, 57}));
  EXPECT_NE(cell_at(grid, {-99, 51}), cell_at(grid, {-91, 51}));
  EXPECT_EQ(cell_at(grid, {-1e9, -1e9}), 0U) << "beside the grid";
  EXPECT_EQ(cell_at(grid, {1e9, 1e9}), grid.count() - 1);
}

TEST(StoreGrid, OfASectionIsARow) {
  const StoreGrid grid = StoreGrid::over({{0, 0}, {26, 0}}, true);  // 0.5 m
  EXPECT_EQ(grid.count(), 52U);
  EXPECT_EQ(cell_at(grid, {10.2, 0}), cell_at(grid, {10.2, 77}));
}

TEST(StoreGrid, LinesHaveTheCellsOfAllTheirPoints) {
  Dice dice(3);
  const StoreGrid grid = StoreGrid::over({{0, 0}, {100, 60}}, false);
  std::size_t cells_of_lines = 0, cells_of_boxes = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const auto any = [&] { return Vec2(dice.between(-20, 120), dice.between(-20, 80)); };
    const Vec2 from = any(), to = dice.chance(0.1) ? Vec2(from.x(), any().y()) : dice.chance(0.1) ? from : any();
    const double reach = dice.chance(0.3) ? 0 : dice.between(0, 6);
    CellSet cells(grid.count()), box(grid.count());
    grid.add_line(from, to, reach, cells);
    for (int k = 0; k <= 50; ++k) {
      const Vec2 place = from + k / 50.0 * (to - from);
      const double angle = dice.between(0, 7);
      const Vec2 near = place + dice.unit() * reach * Vec2(std::cos(angle), std::sin(angle));
      ASSERT_TRUE(cells.has(cell_at(grid, place)));
      ASSERT_TRUE(cells.has(cell_at(grid, near)));
    }
    if (reach > 0) continue;
    grid.add_box({from.min(to), from.max(to)}, box);
    cells_of_lines += count_of(cells);
    cells_of_boxes += count_of(box);
  }
  EXPECT_LT(5 * cells_of_lines, cells_of_boxes);
}

TEST(StoreGrid, PiecesHaveTheCellsOfTheirWay) {
  Dice dice(4);
  const StoreGrid grid = StoreGrid::over({{0, 0}, {100, 60}}, false);
  for (int trial = 0; trial < 1000; ++trial) {
    PathPiece piece;
    piece.on_ground = dice.chance(0.5);
    piece.path = {Vec3(dice.between(0, 100), dice.between(0, 60), 5), dice.in_cube(20), {0, 0, -10}};
    if (piece.on_ground) piece.path.a = dice.in_cube(5);
    if (dice.chance(0.2)) piece.path.a = dice.between(-2, 2) * piece.path.v;
    piece.duration = dice.chance(0.1) ? 0 : dice.between(0, 4);
    CellSet cells(grid.count());
    grid.add_piece(piece, cells);
    for (int k = 0; k <= 100; ++k) {
      const Vec2 place = piece.path.at(piece.duration * k / 100).xy();
      ASSERT_TRUE(cells.has(cell_at(grid, place)));
    }
  }
}

}  // namespace
}  // namespace talus
