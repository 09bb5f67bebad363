#pragma once
// A convex rock: the corners of its hull, in the frame of the body - the principal axes of inertia through the centre
// of mass, the longest of the block along x. A shape has a volume of 1 m3; rocks scale it.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <span>
#include <vector>

#include "talus/core/matrix.hpp"
#include "talus/core/orientation.hpp"
#include "talus/core/vec.hpp"
#include "talus/rocks/hull_faces.hpp"
#include "talus/rocks/rock.hpp"

namespace talus {

struct RockShape {
  std::vector<Vec3> corners;                            // [m]
  std::vector<std::array<std::uint32_t, 3>> triangles;  // of the hull, counter-clockwise from outside
  Vec3 gyration;                                        // principal moments of inertia over the mass [m2]
  double reach = 0;                                     // from the centre to the farthest corner [m]
  Orientation as_given;                                 // from the body's frame to that in which it was given
  HullFaces hull;                                       // if none, only corners touch the ground
};

/// The corners of a body in one place.
struct Posture {
  std::span<const Vec3> corners;    // of the shape
  Mat3 turned;                      // from the shape's frame to that of the terrain, scaled
  Vec3 centre;                      // [m]
  double reach = 0;                 // from there to the farthest corner [m]
  const HullFaces* hull = nullptr;  // of the shape; null or none: only its corners are known

  [[nodiscard]] bool has_faces() const { return hull != nullptr && !hull->is_empty(); }
  [[nodiscard]] Vec3 arm(std::size_t i) const { return turned * corners[i]; }
  [[nodiscard]] Vec3 place(std::size_t i) const { return centre + arm(i); }
};

/// A rock of a shape, as its equations need it.
struct Body {
  std::span<const Vec3> corners;  // of the shape
  double scale = 0;               // from the shape to the rock
  double mass = 0;                // [kg]
  Vec3 inertia;                   // principal moments [kg m2]
  double reach = 0;               // [m]
  double inner = 0;  // the radius of a sphere about the centre within the hull; 0 if it has no triangles [m]
  const HullFaces* hull = nullptr;  // of the shape

  /// `turned`: from the body's frame to that of the terrain.
  [[nodiscard]] Posture at(const Vec3& centre, const Mat3& turned) const {
    return {corners, scale * turned, centre, reach, hull};
  }
};

/// The rock's radius is that of the sphere of the same volume. `shape` must live as long as the body.
[[nodiscard]] inline Body body_of(const RockShape& shape, const Rock& rock) {
  const double scale = std::cbrt(4 * std::numbers::pi / 3) * rock.radius;
  double inner = shape.triangles.empty() ? 0 : shape.reach;
  for (const auto& [a, b, c] : shape.triangles) {
    const Vec3& corner = shape.corners[a];
    const Vec3 out = (shape.corners[b] - corner).cross(shape.corners[c] - corner);
    inner = std::min(inner, corner.dot(out) / out.norm());
  }
  return {shape.corners,       scale,
          rock.mass,           rock.mass * scale * scale * shape.gyration,
          scale * shape.reach, scale * std::max(inner, 0.0),
          &shape.hull};
}

/// The lengths of a body along its principal axes, the longest first [m].
[[nodiscard]] inline Vec3 axes_of(const Body& body) {
  Vec3 low, high;  // the centre is within
  for (const Vec3& corner : body.corners) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], corner[k]);
      high[k] = std::max(high[k], corner[k]);
    }
  }
  std::array<double, 3> lengths{high[0] - low[0], high[1] - low[1], high[2] - low[2]};
  std::ranges::sort(lengths, std::greater());
  return body.scale * Vec3{lengths[0], lengths[1], lengths[2]};
}

}  // namespace talus
