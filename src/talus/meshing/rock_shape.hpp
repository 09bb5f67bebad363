#pragma once
// Shapes of rocks: the convex hull of points, with its volume and its moments of inertia.

#include <span>

#include "talus/rocks/shape.hpp"

namespace talus {

/// A hull as it was given.
struct Hull {
  RockShape
      shape;  // scaled to 1 m3, about its centre of mass, its longest axis of inertia along x, the shortest along z
  double volume = 0;  // before that, in the cube of the points' unit
};

/// The hull of points in any unit and place. Throws BadInput if there are fewer than four, if one is not a number, or
/// if they lie in a plane.
///
/// The moments are exact, summed over the tetrahedra between the centre and the triangles of the hull: F. Tonon,
/// "Explicit exact formulas for the 3-D tetrahedron inertia tensor in terms of its vertex coordinates", Journal of
/// Mathematics and Statistics 1 (2004).
[[nodiscard]] Hull hull_of(std::span<const Vec3> points);

/// Of any three edges or axes that are given in the same unit.
[[nodiscard]] RockShape box_shape(const Vec3& edges);
/// With so many corners on the ellipsoid, evenly spread on the sphere that it is stretched from.
[[nodiscard]] RockShape ellipsoid_shape(const Vec3& axes, int corners = 24);

enum class RegularSolid { tetrahedron, cube, octahedron, dodecahedron, icosahedron };
[[nodiscard]] RockShape regular_shape(RegularSolid solid);

/// Over a regular polygon with so many sides, at least three; `length` over the diameter of the circle about it.
[[nodiscard]] RockShape prism_shape(int sides, double length);

}  // namespace talus
