#pragma once
// How far a body is from a convex polygon, such as the panel of a barrier.
//
// Of all differences between a point of the body and one of the polygon, the shortest is sought among simplices of at
// most four of them. Source: E. Gilbert, D. Johnson and S. Keerthi, "A fast procedure for computing the distance
// between complex objects in three-dimensional space", IEEE Journal on Robotics and Automation 4 (1988),
// doi 10.1109/56.2083. Accurate to a millionth of the distance; distances below 1e-9 m count as 0. Checked by
// test/rocks/separation_test.cpp.

#include <optional>
#include <span>

#include "talus/rocks/shape.hpp"

namespace talus {

struct Separation {
  double distance;  // [m]
  Vec3 direction;   // unit, from the polygon to the body
  Vec3 nearest;     // a point of the polygon
};

/// nullopt if they overlap or touch. `polygon`: the corners of a convex one, or a segment, or a point.
[[nodiscard]] std::optional<Separation> separation(const Posture& body, std::span<const Vec3> polygon);

}  // namespace talus
