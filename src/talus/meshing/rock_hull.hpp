#pragma once
// The convex hull of points as the shape of a rock, with its volume and its moments of inertia.

#include <span>

#include "talus/rocks/shape.hpp"

namespace talus {

/// A hull as it was given.
struct Hull {
  RockShape shape;
  double volume = 0;  // of the points, in the cube of their unit
};

/// The hull of points in any unit and place. Throws BadInput if there are fewer than four, if one is not a number, or
/// if they lie in a plane.
[[nodiscard]] Hull hull_of(std::span<const Vec3> points);

/// A hull with at most so many corners (four or more): from the six points that reach farthest along the axes, the
/// point farthest outside is added again and again. Throws as hull_of().
[[nodiscard]] Hull thinned_hull_of(std::span<const Vec3> points, std::size_t max_corners);

}  // namespace talus
