#include "talus/terrain/grid_walk.hpp"

#include <gtest/gtest.h>

#include "support/dice.hpp"

namespace talus::grid_walk_test {
namespace {

using testing_tools::Dice;

// From anywhere, also along axes and diagonals, over grids of any shape: consecutive cells are neighbours, up to where
// the flight leaves the grid, and the flight is over each cell between its enter() and leave().
TEST(GridWalk, VisitsTheCellsUnderAFlightAndNoneOutsideTheGrid) {
  Dice dice(5);
  std::size_t steps = 0, walks = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    const auto columns = static_cast<std::int64_t>(1 + dice.below(12)),
               rows = static_cast<std::int64_t>(1 + dice.below(12));
    const double dx = dice.chance(0.5) ? 1 : dice.magnitude(0.1, 30),
                 dy = dice.chance(0.5) ? dx : dice.magnitude(0.1, 30);
    const double x0 = dice.between(-1e3, 1e3), y0 = dice.chance(0.3) ? 0 : dice.between(-1e3, 1e3);
    const double width = static_cast<double>(columns) * dx, depth = static_cast<double>(rows) * dy;
    Vec3 p(x0 + dice.between(-0.3, 1.3) * width, y0 + dice.between(-0.3, 1.3) * depth, 0);
    if (dice.chance(0.3))
      p = {x0 + static_cast<double>(dice.below(13)) * dx, y0 + static_cast<double>(dice.below(13)) * dy, 0};
    Vec3 v(dice.between(-20, 20), dice.between(-20, 20), 0);
    if (dice.chance(0.2)) v.y() = 0;
    if (dice.chance(0.2)) v.x() = 0;
    if (dice.chance(0.2)) v = {dx, dice.chance(0.5) ? dy : -dy, 0};
    const double t_max = dice.chance(0.5) ? 1e6 : dice.between(0, 1);

    GridWalk at({p, v, Vec3{}}, t_max, x0, y0, dx, dy, columns, rows);
    walks += at.is_over() ? 0 : 1;
    double left_at = at.enter();
    std::int64_t column = at.column(), row = at.row();
    for (std::int64_t k = 0; !at.is_over(); at.advance(), ++k) {
      ASSERT_LT(k, columns + rows + 2);
      ASSERT_TRUE(at.column() >= 0 && at.column() < columns && at.row() >= 0 && at.row() < rows);
      ASSERT_EQ(at.node(), static_cast<std::size_t>(at.row() * (columns + 1) + at.column()));
      ASSERT_EQ(std::abs(at.column() - column) + std::abs(at.row() - row), k == 0 ? 0 : 1);
      ASSERT_EQ(at.enter(), left_at);
      ASSERT_LE(at.enter(), at.leave());
      ASSERT_LE(at.leave(), t_max);
      if (v.x() != 0 || v.y() != 0) {
        const double t = 0.5 * (at.enter() + at.leave());
        ASSERT_GE(std::min(at.u(t), at.v(t)), -1e-9);
        ASSERT_LE(std::max(at.u(t), at.v(t)), 1 + 1e-9);
      }
      left_at = at.leave();
      column = at.column();
      row = at.row();
      ++steps;
    }
  }
  EXPECT_GT(walks, 5000U);
  EXPECT_GT(steps, 20000U);
}

}  // namespace
}  // namespace talus::grid_walk_test
