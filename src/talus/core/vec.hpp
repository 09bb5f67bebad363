#pragma once
// Vectors of the kernel: fixed size, SI units. Frame: x and y on plan, z up, right-handed.

#include <Eigen/Dense>
#include <array>

namespace talus {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;

/// A vector as rows of tables have it, and back.
[[nodiscard]] inline std::array<double, 3> coordinates(const Vec3& v) { return {v.x(), v.y(), v.z()}; }
[[nodiscard]] inline Vec3 vector(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }

/// Standard gravity [m/s2], the default of RocFall2 and RocFall3.
inline constexpr double standard_gravity = 9.80665;

/// `v` without its component along the unit vector `n`.
[[nodiscard]] inline Vec3 tangential(const Vec3& v, const Vec3& n) { return v - v.dot(n) * n; }

/// `v` turned about the vertical by the angle with this cosine and sine (counter-clockwise seen from above).
[[nodiscard]] inline Vec3 turned(const Vec3& v, double cosine, double sine) {
  return {cosine * v.x() - sine * v.y(), sine * v.x() + cosine * v.y(), v.z()};
}

}  // namespace talus
