#pragma once
// Vectors of the kernel: fixed-size, SI units. Global frame: x and y on plan, z up, right-handed.

#include <Eigen/Dense>

namespace talus {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;

/// Standard gravity [m/s2], the default of RocFall2 and RocFall3.
inline constexpr double standard_gravity = 9.80665;

/// The part of `v` normal to the unit vector `n`, taken away.
[[nodiscard]] inline Vec3 tangential(const Vec3& v, const Vec3& n) { return v - v.dot(n) * n; }

/// Turns `v` about the vertical by an angle whose cosine and sine are given (counter-clockwise seen from above).
[[nodiscard]] inline Vec3 turned(const Vec3& v, double cosine, double sine) {
  return {cosine * v.x() - sine * v.y(), sine * v.x() + cosine * v.y(), v.z()};
}

}  // namespace talus
