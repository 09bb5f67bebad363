#pragma once
// Slope roughness: the ground that a rock strikes is tilted against the facet by a random angle. Source: verification
// manual, the materials' "slope roughness" (standard deviation of an angle). For the rigid sphere also as spacing and
// amplitude: the heights a1, a2 of two neighbouring points, `spacing` apart, above the facet are independent and
// normally distributed, so that the local angle is atan((a2 - a1) / spacing).

#include <algorithm>
#include <cmath>

#include "talus/core/tolerances.hpp"
#include "talus/core/vec.hpp"

namespace talus {

/// The normal `n`, tilted by `ahead` against the heading (positive: the ground rises against the rock) and by `aside`
/// about it [rad]. `heading`: a tangential unit vector. Angles are limited to tolerance::max_tilt.
[[nodiscard]] inline Vec3 tilted_normal(const Vec3& n, const Vec3& heading, double ahead, double aside) {
  const auto slope = [](double angle) {
    return std::tan(std::clamp(angle, -tolerance::max_tilt, tolerance::max_tilt));
  };
  return (n - slope(ahead) * heading + slope(aside) * n.cross(heading)).normalized();
}

/// A rebound from tilted ground must not lead into the facet: the velocity component into it is removed.
[[nodiscard]] inline Vec3 kept_outside(const Vec3& velocity, const Vec3& n) {
  const double vn = velocity.dot(n);
  return vn < 0 ? velocity - vn * n : velocity;
}

}  // namespace talus
