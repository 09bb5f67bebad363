#pragma once
// The length of a parabola: the integral of the speed, whose square is w^2 + (u + a t)^2 with u the velocity along the
// acceleration a, and w that across it. With s = sqrt(u^2 + w^2) it is the difference of (u s + w^2 ln(u + s)) / 2
// between the ends, over a. Checked by test/rocks/arc_length_test.cpp.

#include <algorithm>
#include <cmath>
#include <optional>

#include "talus/rocks/parabola.hpp"

namespace talus {

/// Of its first t seconds [m].
[[nodiscard]] inline double arc_length(const Parabola& path, double t) {
  const double chord = (path.at(t) - path.p).norm(), a = path.a.norm();
  if (!(a * t > 0)) return chord;
  const double u0 = path.v.dot(path.a) / a, u1 = u0 + a * t, ww = path.v.cross(path.a).squared_norm() / (a * a);
  const double s0 = std::sqrt(u0 * u0 + ww), s1 = std::sqrt(u1 * u1 + ww);
  double twice = u1 * s1 - u0 * s0;
  constexpr double negligible = 1e-200;  // [m2/s2], so that the quotient does not overflow
  if (ww > negligible) {
    const auto sum = [ww](double u, double s) { return u < 0 ? ww / (s - u) : s + u; };  // without cancellation
    twice += ww * std::log(sum(u1, s1) / sum(u0, s0));
  }
  return std::max(chord, 0.5 * twice / a);  // cancels where the path is almost straight
}

/// When a path has the length `way` [s]; nullopt if not before `t`. Expects a path that does not turn back before `t`.
[[nodiscard]] inline std::optional<double> time_at_length(const Parabola& path, double way, double t) {
  if (std::isfinite(t) && arc_length(path, t) < way) return std::nullopt;
  const double speed = path.v.norm();
  const double gain = speed > 0 ? path.a.dot(path.v) / speed : path.a.norm();
  const double square = speed * speed + 2 * gain * way;
  if (!(square > 0)) return std::nullopt;  // it stands still before, or never moves
  double at = std::min(t, 2 * way / (speed + std::sqrt(square)));
  constexpr int corrections = 3;  // of the straight line's time, for curved legs
  for (int k = 0; k < corrections; ++k) {
    const double error = arc_length(path, at) - way;
    if (error == 0) break;
    at = std::clamp(at - error / path.velocity(at).norm(), 0.0, t);
  }
  return at;
}

}  // namespace talus
