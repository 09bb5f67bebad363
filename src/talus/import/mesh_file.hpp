#pragma once
// Triangle meshes from files. The format is told by the name's ending: .obj, .stl or .ply.

#include <filesystem>

#include "talus/core/problems.hpp"
#include "talus/meshing/raw_mesh.hpp"

namespace talus {

/// Reads a mesh, its coordinates in metres and to the last bit of what the file holds. Faces of more than three corners
/// become several triangles, in the order of the faces. Throws BadInput, which names the line or the face.
/// What is only doubtful (for example, coordinates too large for their single precision) is added to `warnings`.
[[nodiscard]] RawMesh read_mesh_file(const std::filesystem::path& path, Problems& warnings);
[[nodiscard]] RawMesh read_mesh_file(const std::filesystem::path& path);

}  // namespace talus
