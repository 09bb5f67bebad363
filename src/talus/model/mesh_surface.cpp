#include "talus/model/mesh_surface.hpp"

#include <vector>

namespace talus::project {

TriangleMesh mesh_surface(const CleanMesh& mesh, const LocalFrame& frame) {
  std::vector<Vec3> local;
  local.reserve(mesh.vertices.size());
  for (const Vec3& v : mesh.vertices) local.push_back(frame.local_from_global(v));
  std::vector<TriangleMesh::Corners> neighbours;
  neighbours.reserve(mesh.neighbours.size());
  for (const auto& sides : mesh.neighbours) {
    TriangleMesh::Corners beyond;
    for (std::size_t k = 0; k < 3; ++k) beyond[k] = sides[k] ? (*sides[k]).index : TriangleMesh::no_neighbour;
    neighbours.push_back(beyond);
  }
  return {local, mesh.triangles, neighbours};
}

}  // namespace talus::project
