#pragma once
// Flight without drag: position p + v t + a t^2 / 2 with a = (0, 0, -g). Source: verification manual, equations 2.1
// (which omits the term v_z t; it is included here) and 2.2.

#include "talus/core/vec.hpp"

namespace talus {

struct Parabola {
  Vec3 p;  // position at t = 0 [m]
  Vec3 v;  // velocity at t = 0 [m/s]
  Vec3 a;  // acceleration [m/s2]: along z in flight, along the facet in a leg of sliding or rolling

  [[nodiscard]] Vec3 at(double t) const { return p + t * v + (0.5 * t * t) * a; }
  [[nodiscard]] Vec3 velocity(double t) const { return v + t * a; }
  [[nodiscard]] double z(double t) const { return p.z() + t * (v.z() + 0.5 * t * a.z()); }
};

/// A part of a path [s].
struct TimeWindow {
  double enter, leave;
  [[nodiscard]] bool is_empty() const { return enter > leave; }
};

}  // namespace talus
