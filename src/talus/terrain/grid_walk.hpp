#pragma once
// The cells of a grid that a flight passes on plan, in order. On plan a flight is a straight line (J. Amanatides and A.
// Woo, "A fast voxel traversal algorithm", Eurographics 1987). The time of each border is computed from the border
// itself, so that errors do not add up over long flights.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "talus/core/pair.hpp"
#include "talus/rocks/parabola.hpp"

namespace talus {

class GridWalk {
 public:
  /// The part of the flight in [0, t_max] over `columns` x `rows` cells of dx x dy whose south-west corner is (x0, y0).
  GridWalk(const Parabola& path, double t_max, double x0, double y0, double dx, double dy, std::int64_t columns,
           std::int64_t rows) {
    const double from_x = begin(0, path.p.x() - x0, path.v.x(), dx, columns);
    const double from_y = begin(1, path.p.y() - y0, path.v.y(), dy, rows);
    enter_ = std::max({0.0, from_x, from_y});
    end_ = std::min({t_max, next_[0], next_[1]});
    if (!(enter_ <= end_)) {
      is_over_ = true;
      return;
    }
    for (int axis : {0, 1}) {
      cell_[axis] = std::clamp(std::floor(origin_[axis] + enter_ * speed_[axis]), 0.0, cells_[axis] - 1);
    }
    node_step_ = PairMask{static_cast<std::int64_t>(step_[0]), static_cast<std::int64_t>(step_[1]) * (columns + 1)};
    node_ = row() * (columns + 1) + column();
    look_ahead();
  }

  /// Whether the last cell has been passed.
  [[nodiscard]] bool is_over() const { return is_over_; }
  [[nodiscard]] std::int64_t column() const { return static_cast<std::int64_t>(cell_[0]); }
  [[nodiscard]] std::int64_t row() const { return static_cast<std::int64_t>(cell_[1]); }
  /// The number of the cell's south-west node, counted row by row.
  [[nodiscard]] std::size_t node() const { return static_cast<std::size_t>(node_); }
  /// When the flight is over this cell [s].
  [[nodiscard]] double enter() const { return enter_; }
  [[nodiscard]] double leave() const { return leave_; }
  /// Where the flight is in the cell at a time: 0 at its west and south sides, 1 at its east and north sides.
  [[nodiscard]] double u(double t) const { return origin_[0] + t * speed_[0] - cell_[0]; }
  [[nodiscard]] double v(double t) const { return origin_[1] + t * speed_[1] - cell_[1]; }
  /// Their rates [cells/s].
  [[nodiscard]] double u_speed() const { return speed_[0]; }
  [[nodiscard]] double v_speed() const { return speed_[1]; }
  /// Whether the flight, or the grid, ends in this cell.
  [[nodiscard]] bool is_last() const { return leave_ >= end_; }
  /// Whether it leaves through the east or west side, not through the north or south side.
  [[nodiscard]] bool leaves_along_x() const { return next_[0] <= next_[1]; }
  [[nodiscard]] bool goes_east() const { return step_[0] > 0; }
  [[nodiscard]] bool goes_north() const { return step_[1] > 0; }

  // Which border comes first cannot be predicted: both axes are computed each time, without a branch. (The walk cannot
  // step off the grid: the border that ends the grid has the same time here as in `end_`, bit for bit.)
  void advance() {
    const PairMask axis = leaving_axis();
    cell_ += chosen(axis, step_);
    const PairMask nodes = axis & node_step_;
    node_ += nodes[0] | nodes[1];
    is_over_ = is_last();
    enter_ = leave_;
    look_ahead();
  }

 private:
  /// Sets what is the same in all cells. Returns when the flight enters the grid along this axis, and sets `next_` to
  /// when it leaves.
  double begin(int axis, double distance, double speed, double size, std::int64_t cells) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    origin_[axis] = distance / size;
    speed_[axis] = speed / size;
    cells_[axis] = static_cast<double>(cells);
    next_[axis] = infinite;
    if (speed_[axis] == 0) {
      standing_[axis] = infinite;
      return origin_[axis] < 0 || origin_[axis] > cells_[axis] ? infinite : -infinite;
    }
    inverse_[axis] = 1 / speed_[axis];
    const double t1 = -origin_[axis] * inverse_[axis], t2 = (cells_[axis] - origin_[axis]) * inverse_[axis];
    next_[axis] = std::max(t1, t2);
    step_[axis] = speed_[axis] > 0 ? 1 : -1;
    border_[axis] = speed_[axis] > 0 ? 1 : 0;
    return std::min(t1, t2);
  }
  /// All bits set for the axis along which it leaves the cell, none for the other.
  [[nodiscard]] PairMask leaving_axis() const {
    const PairMask along_x = next_ <= swapped(next_);
    return PairMask{along_x[0], along_x[0]} ^ PairMask { 0, -1 };
  }
  void look_ahead() {
    next_ = (cell_ + border_ - origin_) * inverse_ + standing_;
    leave_ = std::max(enter_, std::min(std::min(next_[0], next_[1]), end_));
  }

  // Along x and along y, in units of cells. Cells are counted in floating point, like everything computed with them.
  Pair origin_{}, speed_{};
  Pair inverse_{};   // of the speed; 0 for standstill
  Pair standing_{};  // added to the time of the next border: infinite for standstill, else 0
  Pair cells_{}, cell_{}, step_{};
  Pair border_{};  // 1 where the border ahead is the upper one
  Pair next_{};    // when it crosses the border ahead
  PairMask node_step_{};
  std::int64_t node_ = 0;
  double enter_ = 0, leave_ = 0, end_ = 0;
  bool is_over_ = false;
};

}  // namespace talus
