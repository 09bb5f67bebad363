#pragma once
// The cells of a grid that a flight passes on plan, one after the other: a straight line, since only the height is
// curved (J. Amanatides and A. Woo, "A fast voxel traversal algorithm", Eurographics 1987). Each border's time is
// computed from the border itself, so that no error adds up over long flights.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "talus/core/pair.hpp"
#include "talus/flight/parabola.hpp"

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

  /// Whether there is no cell left.
  [[nodiscard]] bool is_over() const { return is_over_; }
  [[nodiscard]] std::int64_t column() const { return static_cast<std::int64_t>(cell_[0]); }
  [[nodiscard]] std::int64_t row() const { return static_cast<std::int64_t>(cell_[1]); }
  /// The number of the cell's south-west node, where nodes are counted row by row.
  [[nodiscard]] std::size_t node() const { return static_cast<std::size_t>(node_); }
  /// When the flight is over this cell [s].
  [[nodiscard]] double enter() const { return enter_; }
  [[nodiscard]] double leave() const { return leave_; }
  /// Where it is in the cell at a time: 0 at its west and south sides, 1 at its east and north sides.
  [[nodiscard]] double u(double t) const { return origin_[0] + t * speed_[0] - cell_[0]; }
  [[nodiscard]] double v(double t) const { return origin_[1] + t * speed_[1] - cell_[1]; }
  /// How fast these grow [cells/s].
  [[nodiscard]] double u_speed() const { return speed_[0]; }
  [[nodiscard]] double v_speed() const { return speed_[1]; }
  /// Whether the flight's time, or the grid, ends in this cell.
  [[nodiscard]] bool is_last() const { return leave_ >= end_; }
  /// Through which side it leaves: the east or west one, or the north or south one.
  [[nodiscard]] bool leaves_along_x() const { return next_[0] <= next_[1]; }
  [[nodiscard]] bool goes_east() const { return step_[0] > 0; }
  [[nodiscard]] bool goes_north() const { return step_[1] > 0; }

  // Which border comes first changes from cell to cell like the toss of a coin: both axes are worked out each time, so
  // that there is nothing to guess. (It cannot step off the grid: the border that ends the grid has the same time here
  // as in `end_`, to the bit.)
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
  /// Sets what is the same in all cells; gives when it comes over the grid along this axis, and in `next_` when it
  /// leaves it.
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
  /// All bits for the axis along which it leaves, none for the other one.
  [[nodiscard]] PairMask leaving_axis() const {
    const PairMask along_x = next_ <= swapped(next_);
    return PairMask{along_x[0], along_x[0]} ^ PairMask { 0, -1 };
  }
  void look_ahead() {
    next_ = (cell_ + border_ - origin_) * inverse_ + standing_;
    leave_ = std::max(enter_, std::min(std::min(next_[0], next_[1]), end_));
  }

  // Along x and along y, in units of cells, which are counted in numbers with a fraction: all that is done with them
  // is.
  Pair origin_{}, speed_{};
  Pair inverse_{};   // of the speed; 0 where it stands still, which it does for
  Pair standing_{};  // for ever then, and otherwise not at all
  Pair cells_{}, cell_{}, step_{};
  Pair border_{};  // 1 where the border ahead is the upper one
  Pair next_{};    // when it crosses that
  PairMask node_step_{};
  std::int64_t node_ = 0;
  double enter_ = 0, leave_ = 0, end_ = 0;
  bool is_over_ = false;
};

}  // namespace talus
