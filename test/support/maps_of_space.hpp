#pragma once
// Rotations, reflections and three equations with three unknowns, for tests of invariance.

#include <cmath>

#include "talus/core/vec.hpp"

namespace talus::testing_tools {

/// A linear map, by the images of the axes.
struct Map3 {
  Vec3 of_x, of_y, of_z;
  friend Vec3 operator*(const Map3& map, const Vec3& v) {
    return v.x() * map.of_x + v.y() * map.of_y + v.z() * map.of_z;
  }
};

/// The rotation about a unit vector by an angle [rad] (Rodrigues).
inline Map3 turn_about(const Vec3& axis, double angle) {
  const auto turn = [&](const Vec3& v) {
    const double c = std::cos(angle);
    return c * v + std::sin(angle) * axis.cross(v) + (1 - c) * axis.dot(v) * axis;
  };
  return {turn(unit_x), turn(unit_y), turn(unit_z)};
}

/// The reflection in the plane through the origin with this unit normal.
inline Map3 mirror_across(const Vec3& normal) {
  const auto mirror = [&](const Vec3& v) { return v - 2 * v.dot(normal) * normal; };
  return {mirror(unit_x), mirror(unit_y), mirror(unit_z)};
}

/// The coordinates of `v` along a, b and c (Cramer).
inline Vec3 solved(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& v) {
  return Vec3(v.dot(b.cross(c)), v.dot(c.cross(a)), v.dot(a.cross(b))) / a.dot(b.cross(c));
}

}  // namespace talus::testing_tools
