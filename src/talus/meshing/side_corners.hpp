#pragma once
// Corners of facets on the side of another facet, where surfaces meet that were triangulated independently. There is a
// crack along such a side until it has that corner, too.

#include <array>
#include <cstdint>
#include <vector>

#include "talus/meshing/findings.hpp"

namespace talus {

/// Facets, each with its number before the cut; ascending.
struct CutFacets {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint32_t> original;
};

/// Splits facets where their boundary edges pass a corner of the boundary within the tolerance [m]. The edge then leads
/// through the corner, and bends by up to the tolerance. Facets must have area; one that the bend would turn over is
/// not split. Returns the corners, once for each edge.
Findings put_corners_into_sides(const std::vector<Vec3>& vertices, CutFacets& facets, double tolerance_m);

}  // namespace talus
