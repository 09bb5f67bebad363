#pragma once
// The length of a parabola: the integral of the speed, whose square is w^2 + (u + a t)^2 with u the velocity along the
// acceleration a, and w that across it. With s = sqrt(u^2 + w^2) it is the difference of (u s + w^2 asinh(u / w)) / 2
// between the ends, over a. Checked by test/flight/arc_length_test.cpp.

#include <algorithm>
#include <cmath>

#include "talus/flight/parabola.hpp"

namespace talus {

/// Of its first t seconds [m].
[[nodiscard]] inline double arc_length(const Parabola& path, double t) {
  const double chord = (path.at(t) - path.p).norm(), a = path.a.norm();
  if (!(a * t > 0)) return chord;
  const double u0 = path.v.dot(path.a) / a, u1 = u0 + a * t, w = path.v.cross(path.a).norm() / a;
  const auto primitive = [w](double u) {
    if (w == 0) return 0.5 * u * std::abs(u);
    return 0.5 * (u * std::sqrt(u * u + w * w) + w * w * std::asinh(u / w));
  };
  return std::max(chord, (primitive(u1) - primitive(u0)) / a);  // cancels where the path is almost straight
}

}  // namespace talus
