#pragma once
// Places on a panel, and paths near it. Private to barriers/.

#include <algorithm>
#include <array>
#include <cmath>

#include "talus/barriers/barrier.hpp"
#include "talus/core/tolerances.hpp"
#include "talus/rocks/parabola.hpp"

namespace talus::on_panel {

/// A range that contains p + v t + a t^2 / 2 for all t in [0, t_max], widened by `margin`.
struct Range {
  Range(double p, double v, double a, double t_max, double margin)
      : low(p + std::min(v * t_max, 0.0) + std::min(0.5 * a * t_max * t_max, 0.0) - margin),
        high(p + std::max(v * t_max, 0.0) + std::max(0.5 * a * t_max * t_max, 0.0) + margin) {}
  double low, high;
};

/// The bounds on plan of a path, widened by `margin`.
[[nodiscard]] inline PlanBounds bounds_of(const Parabola& path, double t_max, double margin) {
  const Range x(path.p.x(), path.v.x(), path.a.x(), t_max, margin),
      y(path.p.y(), path.v.y(), path.a.y(), t_max, margin);
  return {{x.low, y.low}, {x.high, y.high}};
}

/// The times at which the quadratic h0 + v t + a t^2/2 is zero, in ascending order.
struct Times {
  std::array<double, 2> t{};
  int count = 0;
};

[[nodiscard]] inline Times zeros(double h0, double v, double a) {
  if (a == 0) {
    return v != 0 ? Times{{-h0 / v, 0}, 1} : Times{};
  }
  const double discriminant = v * v - 2 * a * h0;
  if (discriminant < 0) return {};
  const double q = -(v + std::copysign(std::sqrt(discriminant), v));
  const double t1 = q / a, t2 = q != 0 ? 2 * h0 / q : 0;
  return {{std::min(t1, t2), std::max(t1, t2)}, 2};
}

/// The place of a point on a panel: along its foot and up its face (which are not at right angles if the foot climbs).
struct Place {
  double along, up;
};

[[nodiscard]] inline Place place_on(const Panel& panel, const Vec3& q) {
  const Vec3 d = q - panel.foot;
  const double c = panel.along.dot(panel.up), x = d.dot(panel.along), y = d.dot(panel.up);
  return {(x - c * y) / (1 - c * c), (y - c * x) / (1 - c * c)};
}

[[nodiscard]] inline bool is_between_sides(const Panel& panel, const Place& place) {
  return !panel.has_sides || (place.along >= panel.start_at(place.up) - tolerance::panel_border &&
                              place.along <= panel.end_at(place.up) + tolerance::panel_border);
}

[[nodiscard]] inline Vec3 point_of(const Panel& panel, const Place& place) {
  return panel.foot + place.along * panel.along + place.up * panel.up;
}

/// Whether a distance does not decrease: neither by the speed nor, at standstill, by the acceleration.
[[nodiscard]] inline bool draws_away(double speed, double acceleration) {
  using tolerance::no_pressing;
  return speed > no_pressing || (speed > -no_pressing && acceleration >= -no_pressing);
}

}  // namespace talus::on_panel
