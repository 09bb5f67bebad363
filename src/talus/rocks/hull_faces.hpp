#pragma once
// The faces of a convex rock, for what of the ground may touch them: edges and vertices (ridge.hpp).

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "talus/core/tolerances.hpp"
#include "talus/core/vec.hpp"

namespace talus {

/// Points of the rock have normal . x <= offset.
struct HullFace {
  Vec3 normal;        // unit, out of the rock
  double offset = 0;  // [m]
};

/// A face of a section is a side of its polygon.
struct HullFaces {
  /// A face that ends in a corner, and an edge of the rock from there. Triangles in one plane are one face: edges may
  /// lie in it.
  struct AtCorner {
    std::uint32_t face, along;  // along: the corner to which the edge leads
  };

  std::vector<HullFace> faces;
  std::vector<std::uint32_t> all;    // 0, 1, ...: the numbers of the faces
  std::vector<AtCorner> at_corners;  // those of corner i from first[i] to first[i + 1]
  std::vector<std::uint32_t> first;

  [[nodiscard]] bool is_empty() const { return faces.empty(); }
  [[nodiscard]] std::span<const AtCorner> at(std::size_t corner) const {
    return {at_corners.data() + first[corner], first[corner + 1] - first[corner]};
  }
};

/// Of a hull with `triangles`, counter-clockwise from outside, or, if there are none and all corners lie in the plane y
/// = 0, of a convex polygon about the origin. Otherwise there are none.
void find_faces(std::span<const Vec3> corners, std::span<const std::array<std::uint32_t, 3>> triangles,
                HullFaces& into);

}  // namespace talus
