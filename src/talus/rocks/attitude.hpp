#pragma once
// How a body is turned along its trajectory: known at some times, and between two of them as it turns freely.

#include <algorithm>
#include <iterator>
#include <span>

#include "talus/rocks/free_rotation.hpp"

namespace talus {

/// How a rock with a shape is turned at a time, and its own spin, with which it turns freely until the next.
struct Attitude {
  double time = 0;  // since release [s]
  Orientation orientation;
  Vec3 spin;  // in the frame of the terrain [rad/s]
};

/// How it is turned at a time [s], and its spin; before the first of the attitudes as there. They are in the order of
/// time, at least one. `inertia`: principal moments [kg m2].
[[nodiscard]] inline FreeRotation::State turned_at(std::span<const Attitude> attitudes, const Vec3& inertia,
                                                   double time) {
  const auto next = std::ranges::upper_bound(attitudes, time, {}, &Attitude::time);
  const Attitude& from = next == attitudes.begin() ? *next : *std::prev(next);
  if (time <= from.time) return {from.orientation, from.spin};
  return FreeRotation(inertia, from.orientation, from.spin).at(time - from.time);
}
[[nodiscard]] inline Orientation orientation_at(std::span<const Attitude> attitudes, const Vec3& inertia, double time) {
  return turned_at(attitudes, inertia, time).orientation;
}

/// The angle between two orientations [rad].
[[nodiscard]] inline double angle_between(const Orientation& a, const Orientation& b) {
  const Vec3 v = a.w() * b.xyz() - b.w() * a.xyz() - a.xyz().cross(b.xyz());
  return 2 * std::atan2(v.norm(), std::abs(a.w() * b.w() + a.xyz().dot(b.xyz())));
}

}  // namespace talus
