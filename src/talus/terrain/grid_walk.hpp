#pragma once
// The cells of a grid that a flight passes on plan, one after the other: a straight line, since only the height is
// curved (J. Amanatides and A. Woo, "A fast voxel traversal algorithm", Eurographics 1987). Each border's time is
// computed from the border itself, so that no error adds up over long flights.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "talus/flight/parabola.hpp"

namespace talus {

class GridWalk {
 public:
  /// The part of the flight in [0, t_max] over `columns` x `rows` cells of dx x dy whose south-west corner is (x0, y0).
  GridWalk(const Parabola& path, double t_max, double x0, double y0, double dx, double dy, std::int64_t columns,
           std::int64_t rows)
      : x_(axis(path.p.x() - x0, path.v.x(), dx, columns)), y_(axis(path.p.y() - y0, path.v.y(), dy, rows)) {
    enter_ = std::max({0.0, x_.enter, y_.enter});
    end_ = std::min({t_max, x_.leave, y_.leave});
    if (!(enter_ <= end_)) {
      is_over_ = true;
      return;
    }
    start(x_);
    start(y_);
    find_leave();
  }

  /// Whether there is no cell left.
  [[nodiscard]] bool is_over() const { return is_over_; }
  [[nodiscard]] std::int64_t column() const { return x_.cell; }
  [[nodiscard]] std::int64_t row() const { return y_.cell; }
  /// When the flight is over this cell [s].
  [[nodiscard]] double enter() const { return enter_; }
  [[nodiscard]] double leave() const { return leave_; }
  /// Where it is in the cell at a time: 0 at its west and south sides, 1 at its east and north sides.
  [[nodiscard]] double u(double t) const { return x_.origin + t * x_.speed - static_cast<double>(x_.cell); }
  [[nodiscard]] double v(double t) const { return y_.origin + t * y_.speed - static_cast<double>(y_.cell); }
  /// How fast these grow [cells/s].
  [[nodiscard]] double u_speed() const { return x_.speed; }
  [[nodiscard]] double v_speed() const { return y_.speed; }
  /// Whether the flight's time, or the grid, ends in this cell.
  [[nodiscard]] bool is_last() const { return leave_ >= end_; }
  /// Through which side it leaves: the east or west one, or the north or south one.
  [[nodiscard]] bool leaves_along_x() const { return x_.next <= y_.next; }
  [[nodiscard]] bool goes_east() const { return x_.step > 0; }
  [[nodiscard]] bool goes_north() const { return y_.step > 0; }

  // Which border comes first changes from cell to cell like the toss of a coin: both axes are worked out each time, so
  // that there is nothing to guess.
  void advance() {
    const bool along_x = leaves_along_x();
    x_.cell += along_x ? x_.step : 0;
    y_.cell += along_x ? 0 : y_.step;
    // (Beyond the grid only by rounding: `end` is there.)
    is_over_ = is_last() || static_cast<std::uint64_t>(x_.cell) >= static_cast<std::uint64_t>(x_.cells) ||
               static_cast<std::uint64_t>(y_.cell) >= static_cast<std::uint64_t>(y_.cells);
    if (is_over_) return;
    find_next(x_);
    find_next(y_);
    enter_ = leave_;
    find_leave();
  }

 private:
  // In units of cells.
  struct Axis {
    double origin, speed;
    double inverse = 0;   // of the speed; 0 where it stands still, which it does for
    double standing = 0;  // for ever then, and otherwise not at all
    double enter, leave;  // when it is over the grid along this axis
    std::int64_t cells, cell = 0, step = 0;
    double border = 0;  // 1 where the border ahead is the upper one
    double next = 0;    // when it crosses that
  };

  static Axis axis(double distance, double speed, double size, std::int64_t cells) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    Axis a{.origin = distance / size, .speed = speed / size, .enter = -infinite, .leave = infinite, .cells = cells};
    const auto width = static_cast<double>(cells);
    if (a.speed == 0) {
      a.standing = infinite;
      if (a.origin < 0 || a.origin > width) a.enter = infinite;
    } else {
      a.inverse = 1 / a.speed;
      const double t1 = -a.origin * a.inverse, t2 = (width - a.origin) * a.inverse;
      a.enter = std::min(t1, t2);
      a.leave = std::max(t1, t2);
      a.step = a.speed > 0 ? 1 : -1;
      a.border = a.speed > 0 ? 1 : 0;
    }
    return a;
  }
  void start(Axis& a) const {
    const auto at = static_cast<std::int64_t>(std::floor(a.origin + enter_ * a.speed));
    a.cell = std::clamp<std::int64_t>(at, 0, a.cells - 1);
    find_next(a);
  }
  static void find_next(Axis& a) {
    a.next = (static_cast<double>(a.cell) + a.border - a.origin) * a.inverse + a.standing;
  }
  void find_leave() { leave_ = std::max(enter_, std::min({x_.next, y_.next, end_})); }

  Axis x_, y_;
  double enter_ = 0, leave_ = 0, end_ = 0;
  bool is_over_ = false;
};

}  // namespace talus
