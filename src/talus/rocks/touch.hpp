#pragma once
// When a parabola first touches a plane, a line or a point at a given distance, while approaching it.
//
// Along the parabola the height over a plane is a quadratic function of time, and the squared distance from a line or a
// point a quartic. Each function returns the earliest t in [0, t_max] at which the distance falls through `radius`. A
// rock that touches a surface at t = 0 and moves away from it has no contact there.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "talus/core/tolerances.hpp"
#include "talus/rocks/parabola.hpp"

namespace talus {

/// The time at which h0 + vn t + an t^2/2 falls through zero: the root with a negative derivative. Numerically stable
/// (no difference of nearly equal numbers). `slack`: how far below zero h0 may be and still count as touching. From a
/// deeper start there is no approach from above, unless the rock first rises above zero.
[[nodiscard]] inline std::optional<double> falling_root(double h0, double vn, double an, double slack) {
  const double discriminant = vn * vn - 2 * an * h0;
  if (vn <= 0) {
    if (h0 <= 0) {
      // At or in the surface at the start: touching unless it moves away.
      // (vn and an may be rounding. A path that would not sink by the slack before it bends away, or within the time of
      // a run, moves away.)
      constexpr double long_time = 1e3;  // [s]
      const double depth = std::min(slack, contact_slack);
      const bool pressing = an > 0 ? vn * vn > 2 * an * depth : -long_time * (vn + 0.5 * long_time * an) > depth;
      return h0 >= -slack && pressing ? std::optional(0.0) : std::nullopt;
    }
    if (discriminant < 0) return std::nullopt;  // curved upwards, it turns before it arrives
    const double denominator = -vn + std::sqrt(discriminant);
    return denominator > 0 ? std::optional(2 * h0 / denominator) : std::nullopt;
  }
  if (an >= 0) return std::nullopt;
  if (discriminant < 0 && h0 < -slack) return std::nullopt;  // its top is below the surface
  return (vn + std::sqrt(std::max(discriminant, 0.0))) / -an;
}

/// Times, in ascending order, at which a polynomial of degree 4 falls through zero: at most two, and the start.
struct Falls {
  std::array<double, 3> t{};
  int count = 0;
  [[nodiscard]] const double* begin() const { return t.data(); }
  [[nodiscard]] const double* end() const { return t.data() + count; }
};

/// The times in [0, t_max] at which c0 + c1 t + ... + c4 t^4 falls through zero. If it is not above `slack` (> 0) at t
/// = 0, it touches at the start: the contact is where it begins to sink, unless it rises by the slack before it sinks
/// by the slack. Roots are found between the roots of the derivative, where the polynomial is monotone (Yuksel,
/// "High-performance polynomial root finding for graphics", HPG 2022), so that none is missed or invented.
[[nodiscard]] Falls falls(const std::array<double, 5>& c, double t_max, double slack);

/// When the parabola comes within `radius` of the segment from `a` along the unit vector `e`, of `length`, without its
/// ends (for these, touch_point()). Searched only in `window`, which is part of a path that begins at t = 0.
[[nodiscard]] std::optional<double> touch_edge(const Parabola& path, const Vec3& a, const Vec3& e, double length,
                                               double radius, const TimeWindow& window);

/// When the parabola comes within `radius` of the point `q`, in a window.
[[nodiscard]] std::optional<double> touch_point(const Parabola& path, const Vec3& q, double radius,
                                                const TimeWindow& window);

}  // namespace talus
