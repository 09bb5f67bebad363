#pragma once
// A triangle mesh as it came from outside: nothing about it is promised, not even that its indices exist. cleaning.hpp
// turns it into one that the rest of the terrain can trust.

#include <array>
#include <cstdint>
#include <vector>

#include "talus/core/vec.hpp"

namespace talus {

struct RawMesh {
  std::vector<Vec3> vertices;                           // global coordinates [m]
  std::vector<std::array<std::uint32_t, 3>> triangles;  // into the vertices, counted from 0; any winding
};

}  // namespace talus
