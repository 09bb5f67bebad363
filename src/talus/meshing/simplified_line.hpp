#pragma once
// Lines without the vertices that tell little.

#include <cstddef>
#include <span>
#include <vector>

#include "talus/core/vec.hpp"

namespace talus {

/// The numbers of the vertices that a line keeps, ascending, with the first and the last: the others lie within
/// `tolerance` of the line through them. The method of D. H. Douglas and T. K. Peucker, "Algorithms for the reduction
/// of the number of points required to represent a digitized line or its caricature", Cartographica 10 (1973).
[[nodiscard]] std::vector<std::size_t> vertices_to_keep(std::span<const Vec2> line, double tolerance);

}  // namespace talus
