#pragma once
// Volume and moments of the solid within the triangles of a hull.

#include <array>
#include <cstdint>
#include <span>

#include "talus/core/matrix.hpp"
#include "talus/rocks/shape.hpp"

namespace talus {

/// Integrals over a solid, about the origin.
struct SolidMoments {
  double volume = 0;
  Vec3 first;   // of x
  Mat3 second;  // of x x^T

  [[nodiscard]] Vec3 centre() const { return first / volume; }
};

/// Exact, summed over the tetrahedra between the origin and the triangles, which must be counter-clockwise from
/// outside: F. Tonon, "Explicit exact formulas for the 3-D tetrahedron inertia tensor in terms of its vertex
/// coordinates", Journal of Mathematics and Statistics 1 (2004). The volume is negative if they are clockwise.
[[nodiscard]] SolidMoments moments_of(std::span<const Vec3> corners,
                                      std::span<const std::array<std::uint32_t, 3>> triangles);

/// Sets all of a shape from its corners, in any unit and frame, and its triangles: scales it to 1 m3 and moves it into
/// the frame of the body. Its volume must be more than 0. Returns the volume before, in the cube of the corners' unit.
double settle(RockShape& shape);

}  // namespace talus
