#pragma once
// Boundary edges where the ground continues on facets that are not their neighbours. A rock that slides or rolls to one
// falls through: from an edge above other ground it falls onto that ground; from one next to it or below it, it leaves
// the model.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "talus/meshing/findings.hpp"
#include "talus/meshing/mesh_edges.hpp"

namespace talus {

/// The widest gap or step to another facet with which a boundary edge counts as a crack [m].
inline constexpr double widest_crack_m = 0.01;

struct LooseEdges {
  Findings cracks;   // next to another facet, over a gap or a step
  Findings covered;  // below another facet, and above none
};

/// Probes a place just in front of the middle of each boundary edge: half a crack's width away, for short edges an
/// eighth of their length, so that a notch of the rim is no crack. A crack between two chains of edges is thus found
/// from one side or both; an edge that faces another over less than half its length is not reported.
[[nodiscard]] LooseEdges loose_edges(const std::vector<Vec3>& vertices,
                                     std::span<const std::array<std::uint32_t, 3>> triangles,
                                     std::span<const MeshEdge> boundary, double crack_m);

}  // namespace talus
