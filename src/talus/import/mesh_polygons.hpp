#pragma once
// Faces of three or more corners, as OBJ and PLY have them, cut into triangles.

#include <cstdint>
#include <vector>

#include "talus/files/mesh_problems.hpp"
#include "talus/meshing/raw_mesh.hpp"

namespace talus {

struct PolygonMesh {
  std::vector<Vec3> vertices;          // global coordinates [m]
  std::vector<std::uint32_t> corners;  // of all faces, one after the other; into the vertices, counted from 0
  std::vector<std::uint32_t> ends;     // of each face in `corners`, exclusive
  std::vector<std::uint32_t> lines;    // of each face in the file; empty for a file without lines
  std::uint32_t first_number = 0;      // how the format numbers its first vertex, for messages
};

/// Checks that every corner exists and cuts the faces into triangles, in the order of the faces. A face that a fan from
/// its first corner covers is cut so (a quadrilateral that is not plane is thereby bent along that diagonal); any other
/// by clipping ears (Meisters 1975) in the coordinate plane that shows most of it, in at most O(corners^3). A face that
/// crosses itself is refused; one without area is left to clean() as a triangle without area.
[[nodiscard]] RawMesh triangulated(PolygonMesh mesh, MeshProblems& problems);

}  // namespace talus
