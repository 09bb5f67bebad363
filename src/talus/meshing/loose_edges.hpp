#pragma once
// Boundary edges where the ground goes on, over facets that are not their neighbours. What slides or rolls to one falls
// through: from an edge above other ground it falls on that, from one beside it or below it leaves the model.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "talus/meshing/findings.hpp"
#include "talus/meshing/mesh_edges.hpp"

namespace talus {

/// A gap or a step to the next facet up to which a boundary edge is taken for one side of a crack [m].
inline constexpr double widest_crack_m = 0.01;

struct LooseEdges {
  Findings cracks;   // next to another facet, over a gap or a step
  Findings covered;  // below another facet, and above none
};

/// Looks just in front of the middle of each boundary edge: half as far as a crack is wide, and where edges are short
/// an eighth of their length, so that a notch of the rim is none. So a crack between two chains of edges is found, on
/// one side of it or both, but not of an edge that lies beside another with less than its half.
[[nodiscard]] LooseEdges loose_edges(const std::vector<Vec3>& vertices,
                                     std::span<const std::array<std::uint32_t, 3>> triangles,
                                     std::span<const MeshEdge> boundary, double crack_m);

}  // namespace talus
