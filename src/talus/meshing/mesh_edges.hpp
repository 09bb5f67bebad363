#pragma once
// The edges of a mesh's facets, sorted so that those between the same two vertices are adjacent.

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace talus {

/// An edge of one facet: edge k joins corners k and k + 1.
struct MeshEdge {
  std::uint64_t ends;  // the smaller vertex in the upper half
  std::uint32_t triangle;
  std::uint32_t edge;
  bool operator<(const MeshEdge& o) const { return ends != o.ends ? ends < o.ends : triangle < o.triangle; }
};

[[nodiscard]] inline std::vector<MeshEdge> sorted_edges(std::span<const std::array<std::uint32_t, 3>> triangles) {
  std::vector<MeshEdge> edges;
  edges.reserve(3 * triangles.size());
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    const auto& t = triangles[i];
    for (std::uint32_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(t[k], t[(k + 1) % 3]);
      edges.push_back({std::uint64_t{low} << 32 | high, i, k});
    }
  }
  tbb::parallel_sort(edges);
  return edges;
}

/// Calls take(edges) for each group of `edges` (sorted) that join the same two vertices.
template <class Take>
void each_shared(std::span<const MeshEdge> edges, Take&& take) {
  for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
    while (end < edges.size() && edges[end].ends == edges[begin].ends) ++end;
    take(edges.subspan(begin, end - begin));
  }
}

/// Edges of one facet only.
[[nodiscard]] inline std::vector<MeshEdge> free_edges(std::span<const std::array<std::uint32_t, 3>> triangles) {
  std::vector<MeshEdge> out;
  each_shared(sorted_edges(triangles), [&](std::span<const MeshEdge> of) {
    if (of.size() == 1) out.push_back(of.front());
  });
  return out;
}

}  // namespace talus
