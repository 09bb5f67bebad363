#pragma once
// Corners of facets that lie on the side of another, where surfaces meet that were cut without regard to each other: a
// crack, across which nothing goes on, until the side has that corner too.

#include <array>
#include <cstdint>
#include <vector>

#include "talus/meshing/findings.hpp"

namespace talus {

/// Facets, and of each its number before it was cut; ascending.
struct CutFacets {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint32_t> original;
};

/// Cuts facets where their boundary edges pass a corner of the boundary within the tolerance [m], so that the edge
/// leads through the corner, which bends it by as much. Facets must have area; one that the bend would turn over stays
/// whole. Returns the corners, once for each edge.
Findings put_corners_into_sides(const std::vector<Vec3>& vertices, CutFacets& facets, double tolerance_m);

}  // namespace talus
