#pragma once
// A release point below the surface is lifted onto it.

#include <algorithm>
#include <optional>

#include "talus/core/id.hpp"
#include "talus/flight/parabola.hpp"

namespace talus {

/// The height at which a rock of this radius (0: a point) may start at a place, if that is higher than the place:
/// on the surface that the place is beneath, and far enough out of it for the rock to fit.
template <class Surface>
[[nodiscard]] std::optional<double> lifted(const Surface& surface, const Vec3& place, double radius) {
  Vec3 centre = place;
  if (const auto ground = surface.ground_over(place)) centre.z() = *ground;
  // A sphere that reaches into a facet is raised until it only touches; each round clears the deepest one.
  for (int round = 0; radius > 0 && round < 64; ++round) {
    double rise = 0;
    surface.supports(centre, radius, 0, [&](const Vec3& away, const Vec3&, double distance, FacetId) {
      if (distance < radius - 1e-9) rise = std::max(rise, (radius - distance) / std::max(away.z(), 0.1));
    });
    if (rise == 0) break;
    centre.z() += rise;
  }
  const double raised = centre.z() - place.z();
  if (!(raised > 0)) return std::nullopt;
  if (radius > 0) {
    // Beside an edge or a corner that was too far. From there it is let down again until it touches.
    const auto touched = surface.first_contact({centre, {0, 0, -1}, Vec3::Zero()}, radius, raised);
    constexpr double by_rounding = 1e-9;  // [m]
    const double down = touched ? touched->t : raised;
    if (down > by_rounding) centre.z() -= down;
  }
  return centre.z() > place.z() ? std::optional(centre.z()) : std::nullopt;
}

}  // namespace talus
