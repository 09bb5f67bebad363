#pragma once

#include <cstdint>

namespace talus {

/// The revision of all that decides how a rock of a project moves: laws, terrain (the diagonals of a raster's cells,
/// the triangles of a survey), draws, releases. A change after which any rock of any project may take another path
/// raises it, so that no run, shard or study is continued with rocks of another revision (CONTRIBUTING.md).
inline constexpr std::uint64_t paths_revision = 5;

}  // namespace talus
