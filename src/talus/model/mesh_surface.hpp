#pragma once
// A cleaned mesh as a surface.

#include "talus/meshing/cleaning.hpp"
#include "talus/terrain/local_frame.hpp"
#include "talus/terrain/triangle_mesh.hpp"

namespace talus::project {

[[nodiscard]] TriangleMesh mesh_surface(const CleanMesh& mesh, const LocalFrame& frame);

}  // namespace talus::project
