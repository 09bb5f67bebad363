#pragma once
// Plan coordinates as integers on a fine square grid, so that "left of", "on" and "within the circle" are decided
// exactly. The grid has up to 2^30 steps: 10 km in steps of 15 micrometres.

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstdint>

#include "talus/core/vec.hpp"

namespace talus {

/// A place on plan in grid steps, each coordinate in [0, 2^30].
struct GridPoint {
  std::int32_t x = 0, y = 0;
  friend constexpr bool operator==(GridPoint, GridPoint) = default;
  friend constexpr auto operator<=>(GridPoint, GridPoint) = default;
};

/// The step is a power of two of a metre and the origin a whole number of steps. So a grid point's coordinates in
/// metres are exact, and coordinates that are whole steps already (integers, halves, ...) do not move.
class ExactGrid {
 public:
  static constexpr int bits = 30;
  /// The smallest step: 2^-20 m, a micrometre.
  static constexpr int finest = -20;
  /// The largest step: 2^-10 m, a millimetre.
  static constexpr int coarsest = -10;
  /// The widest terrain: 2^20 m.
  static constexpr double widest_m = 1048576;

  ExactGrid() = default;
  /// Over the box from `low` to `high` [m], at most widest_m wide.
  [[nodiscard]] static ExactGrid over(const Vec2& low, const Vec2& high) {
    const double width = (high - low).largest();
    ExactGrid grid;
    int power = finest;
    // One step is kept free on each side because both ends are rounded.
    while (power < coarsest && std::ldexp(width, -power) > (1 << bits) - 2) ++power;
    grid.power_ = power;
    grid.x0_ = std::floor(std::ldexp(low.x(), -power));
    grid.y0_ = std::floor(std::ldexp(low.y(), -power));
    return grid;
  }

  [[nodiscard]] double spacing_m() const { return std::ldexp(1.0, power_); }

  /// The grid point nearest to a place in the box: at most half a step away along x and along y.
  [[nodiscard]] GridPoint snapped(double x, double y) const {
    return {static_cast<std::int32_t>(std::round(std::ldexp(x, -power_)) - x0_),
            static_cast<std::int32_t>(std::round(std::ldexp(y, -power_)) - y0_)};
  }
  /// Exact.
  [[nodiscard]] Vec2 place(GridPoint p) const { return {std::ldexp(x0_ + p.x, power_), std::ldexp(y0_ + p.y, power_)}; }

 private:
  int power_ = 0;
  double x0_ = 0, y0_ = 0;  // of the grid's origin, in steps
};

// ---- exact predicates ----

/// 128 bits, which g++ and clang have beyond the standard.
__extension__ using Wide = __int128;

/// Twice the area of the triangle: positive if `c` is to the left of the line from `a` to `b`, 0 on it. Exact: 62 bits
/// at most.
[[nodiscard]] constexpr std::int64_t doubled_area(GridPoint a, GridPoint b, GridPoint c) {
  const std::int64_t bx = std::int64_t{b.x} - a.x, by = std::int64_t{b.y} - a.y;
  const std::int64_t cx = std::int64_t{c.x} - a.x, cy = std::int64_t{c.y} - a.y;
  return bx * cy - by * cx;
}

/// Whether `d` is strictly within the circle through the counter-clockwise triangle a, b, c. Exact: with
/// coordinates below 2^30 the determinant (Guibas and Stolfi 1985) is less than 3 x 2^122.
[[nodiscard]] constexpr bool in_circle(GridPoint a, GridPoint b, GridPoint c, GridPoint d) {
  const std::int64_t ax = std::int64_t{a.x} - d.x, ay = std::int64_t{a.y} - d.y;
  const std::int64_t bx = std::int64_t{b.x} - d.x, by = std::int64_t{b.y} - d.y;
  const std::int64_t cx = std::int64_t{c.x} - d.x, cy = std::int64_t{c.y} - d.y;
  const Wide sum = Wide{ax * ax + ay * ay} * (bx * cy - by * cx) + Wide{bx * bx + by * by} * (cx * ay - cy * ax) +
                   Wide{cx * cx + cy * cy} * (ax * by - ay * bx);
  return sum > 0;
}

/// Whether `p` is on the segment from `a` to `b` within the rounding to the grid: in its bounding box, and at most two
/// steps along x and y from its line. A segment bends by half a step at each crossing, and its pieces again at theirs;
/// two steps are enough for a line along the original segment to find the bent one.
[[nodiscard]] constexpr bool is_on_way(GridPoint a, GridPoint b, GridPoint p) {
  const bool is_in_box =
      std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y && p.y <= std::max(a.y, b.y);
  if (!is_in_box) return false;
  const std::int64_t dx = std::int64_t{b.x} - a.x, dy = std::int64_t{b.y} - a.y, area = doubled_area(a, b, p);
  return (area < 0 ? -area : area) <= 2 * ((dx < 0 ? -dx : dx) + (dy < 0 ? -dy : dy));
}

/// The grid point nearest to where the segments a-b and c-d cross, which they must. It is in the bounding boxes of
/// both.
[[nodiscard]] constexpr GridPoint crossing(GridPoint a, GridPoint b, GridPoint c, GridPoint d) {
  const std::int64_t ux = std::int64_t{b.x} - a.x, uy = std::int64_t{b.y} - a.y;
  const std::int64_t vx = std::int64_t{d.x} - c.x, vy = std::int64_t{d.y} - c.y;
  std::int64_t whole = ux * vy - uy * vx;
  std::int64_t part = (std::int64_t{c.x} - a.x) * vy - (std::int64_t{c.y} - a.y) * vx;
  if (whole < 0) {
    whole = -whole;
    part = -part;
  }
  const auto along = [&](std::int64_t length) {
    const Wide doubled = Wide{2} * part * length + whole, divisor = Wide{2} * whole;
    Wide quotient = doubled / divisor;
    if (doubled % divisor < 0) --quotient;  // round down, also below zero
    return static_cast<std::int32_t>(quotient);
  };
  return {a.x + along(ux), a.y + along(uy)};
}

}  // namespace talus
