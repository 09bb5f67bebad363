#pragma once
// Which way the ground falls.

#include "talus/core/vec.hpp"

namespace talus {

/// Down the facet below a place, or over it where the place is in the ground: unit, along the steepest descent. +x
/// where that is level, or where there is none.
template <class Surface>
[[nodiscard]] Vec3 fall_line(const Surface& surface, Vec3 place) {
  constexpr double level = 1e-9;  // of a slope
  if (const auto ground = surface.ground_over(place)) place.z() = *ground;
  const auto below = surface.ground_below(place);
  const Vec3 down = below ? tangential(-Vec3::UnitZ(), surface.normal(below->facet)) : Vec3(Vec3::Zero());
  return down.norm() > level ? Vec3(down.normalized()) : Vec3(Vec3::UnitX());
}

}  // namespace talus
