#pragma once
// The direction of steepest descent.

#include "talus/core/vec.hpp"

namespace talus {

/// The steepest descent on the facet below a place, or above it if the place is in the ground; unit. +x if the facet is
/// level, or there is none.
template <class Surface>
[[nodiscard]] Vec3 fall_line(const Surface& surface, Vec3 place) {
  constexpr double level = 1e-9;  // of a slope
  if (const auto ground = surface.ground_over(place)) place.z() = *ground;
  const auto below = surface.ground_below(place);
  const Vec3 down = below ? tangential(-unit_z, surface.normal(below->facet)) : Vec3{};
  return down.norm() > level ? down.normalized() : unit_x;
}

}  // namespace talus
