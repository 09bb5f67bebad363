#pragma once
// Shapes of rocks by name and by proportions.

#include <span>
#include <vector>

#include "talus/core/vec.hpp"
#include "talus/rocks/shape.hpp"

namespace talus {

/// Of any three edges or axes that are given in the same unit.
[[nodiscard]] RockShape box_shape(const Vec3& edges);
/// With so many corners on the ellipsoid, evenly spread on the sphere that it is stretched from.
[[nodiscard]] RockShape ellipsoid_shape(const Vec3& axes, int corners = 24);

enum class RegularSolid { tetrahedron, cube, octahedron, dodecahedron, icosahedron };
[[nodiscard]] RockShape regular_shape(RegularSolid solid);
/// A ball of 32 triangles from an octahedron, or of 80 from an icosahedron: the middles of the edges moved out to the
/// sphere.
[[nodiscard]] RockShape icosphere_shape(RegularSolid solid);

// Outlines of sections: points in the plane of x and z, in order.

/// Of a regular polygon whose first side is below.
[[nodiscard]] std::vector<Vec2> regular_outline(int sides);
/// |x/a|^p + |z/b|^p = 1 with a = 1 and b = `b_over_a`, at 48 points between which it turns by equal angles. An ellipse
/// for a power of 2; a rectangle with rounded corners for more.
[[nodiscard]] std::vector<Vec2> superellipse_outline(double b_over_a, double power);
[[nodiscard]] std::vector<Vec2> rectangle_outline(double b_over_a);

/// An outline extruded along y, by `length` times the square root of its area. The outline is taken as convex: its
/// hull. Throws BadInput if it has no area.
[[nodiscard]] RockShape prism_shape(std::span<const Vec2> outline, double length = 1);
/// The same for rocks that move in a section only: a corner for each of the outline, in the frame of the outline, and
/// the moment of the prism about y. Those about x and z are the same: they play no part.
[[nodiscard]] RockShape section_shape(std::span<const Vec2> outline);

/// Hulls of so many points, evenly spread on a sphere and then moved at random by up to a third of their distance: to
/// be stretched to blocks of given axes, no two alike (seeding/rock_shapes.hpp). The same list every time.
[[nodiscard]] std::vector<RockShape> irregular_balls(int corners);

}  // namespace talus
