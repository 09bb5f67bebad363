#pragma once
// Merges vertices at the same place.

#include <cstdint>
#include <vector>

#include "talus/core/vec.hpp"

namespace talus {

/// The representative of each vertex; a vertex that is its own representative is kept. Coordinates must be finite.
/// With tolerance 0, vertices with equal coordinates are merged into the first of them. With a tolerance [m], each
/// vertex in turn is merged into the nearest kept vertex within it (the first of equally near ones), or else is kept.
/// Kept vertices are thus further apart than the tolerance, and no vertex moves further than it.
[[nodiscard]] std::vector<std::uint32_t> welded(const std::vector<Vec3>& vertices, double tolerance_m);

}  // namespace talus
