#pragma once
// Vertices that lie at the same place found to be one.

#include <cstdint>
#include <vector>

#include "talus/core/vec.hpp"

namespace talus {

/// For each vertex the one that stands for it; a vertex that stands for itself is kept. Coordinates must be finite.
/// With no tolerance (0), equal coordinates are one place, and the first vertex there stands for all. With one [m],
/// each vertex in turn is stood for by the nearest kept one that is at most so far away, the first of equally near
/// ones, or else is kept itself; kept vertices are thus further apart than the tolerance, and nothing moves further
/// than it.
[[nodiscard]] std::vector<std::uint32_t> welded(const std::vector<Vec3>& vertices, double tolerance_m);

}  // namespace talus
