#pragma once
// Triangulates faces of three or more corners, as in OBJ and PLY.

#include <cstdint>
#include <vector>

#include "talus/files/mesh_problems.hpp"
#include "talus/meshing/raw_mesh.hpp"

namespace talus {

struct PolygonMesh {
  std::vector<Vec3> vertices;          // global coordinates [m]
  std::vector<std::uint32_t> corners;  // of all faces in turn: zero-based indices of vertices
  std::vector<std::uint32_t> ends;     // the end of each face in `corners`, exclusive
  std::vector<std::uint32_t> lines;    // the line of each face in the file; empty for binary files
  std::uint32_t first_number = 0;      // the format's number of the first vertex, for messages
};

/// Checks that every corner exists and cuts the faces into triangles, in the order of the faces. A face is cut into a
/// fan from its first corner if that covers it (a quadrilateral that is not plane then bends along that diagonal), or
/// else by clipping ears (Meisters 1975) in the coordinate plane in which it appears largest, in at most O(corners^3).
/// A face that crosses itself is refused; one without area becomes triangles without area, which clean() removes.
[[nodiscard]] RawMesh triangulated(PolygonMesh mesh, MeshProblems& problems);

}  // namespace talus
