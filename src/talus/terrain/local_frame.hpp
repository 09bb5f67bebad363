#pragma once
// The kernel's local origin, near the terrain, so that coordinates such as 2,600,000 m keep all their digits.

#include <cmath>

#include "talus/core/vec.hpp"

namespace talus {

struct LocalFrame {
  Vec3 origin;  // in the user's coordinates [m]

  /// The origin at the multiple of 1024 m nearest to `middle`: subtracting it from a nearby coordinate is exact, and a
  /// small model near zero is not moved.
  [[nodiscard]] static LocalFrame near(const Vec3& middle) { return {(middle / 1024).rounded() * 1024}; }
  [[nodiscard]] Vec3 local_from_global(const Vec3& p) const { return p - origin; }
  [[nodiscard]] Vec3 global_from_local(const Vec3& p) const { return p + origin; }
};

}  // namespace talus
