#pragma once
// How far a sphere that rolls on a plane can move before it can touch anything that is not in that plane. Checked by
// test/terrain/clear_way_test.cpp.

#include <algorithm>
#include <cmath>
#include <limits>

#include "talus/terrain/contact.hpp"

namespace talus {

/// The distance [m] that a sphere rolling on a plane of unit normal `n` can move, in any direction, before it can touch
/// a facet that is now `distance` from its centre. A facet in the plane on which it rolls is no contact.
[[nodiscard]] inline double clear_way(const Vec3& n, const Vec3& centre, double radius, const Outline& facet,
                                      double distance) {
  using tolerance::touching_plane;
  const double height = facet.normal.dot(centre - facet.point) - radius;               // over its plane
  const double rate = std::max(facet.normal.cross(n).norm(), tolerance::least_speed);  // at most, of that height
  double way = std::max(distance - radius, height / rate) - tolerance::widest_slack;
  // The plane that carries it is no contact as long as the sphere is in it.
  if (facet.normal.dot(n) > 1 - same_plane) way = std::max(way, (touching_plane - std::abs(height)) / rate);
  double highest = -std::numeric_limits<double>::infinity();  // over the plane on which it rolls
  for (std::size_t k = 0; k < static_cast<std::size_t>(facet.edge_count); ++k) {
    highest = std::max(highest, n.dot(facet.edges[k].point - centre) + radius);
  }
  if (highest <= touching_plane) {
    // A facet that does not rise above the plane is touched only where the sphere stands on it.
    const double nearest = distance * distance - (radius + touching_plane) * (radius + touching_plane);
    way = std::max(
        way, std::sqrt(std::max(nearest, 0.0)) - std::sqrt(4 * radius * touching_plane) - tolerance::widest_slack);
  }
  return way;
}

}  // namespace talus
