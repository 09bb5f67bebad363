#pragma once
// A triangle mesh as read from outside, unchecked: not even its indices need exist. cleaning.hpp turns it into one that
// the rest of the terrain can rely on.

#include <array>
#include <cstdint>
#include <vector>

#include "talus/core/vec.hpp"

namespace talus {

struct RawMesh {
  std::vector<Vec3> vertices;                           // global coordinates [m]
  std::vector<std::array<std::uint32_t, 3>> triangles;  // zero-based indices of vertices; any winding
};

}  // namespace talus
