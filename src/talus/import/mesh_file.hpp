#pragma once
// Triangle meshes from files. The extension gives the format (mesh_formats.hpp).

#include <filesystem>

#include "talus/core/problems.hpp"
#include "talus/meshing/raw_mesh.hpp"

namespace talus {

/// Reads a mesh; its coordinates are in metres and keep every bit of the file. Faces of more than three corners are cut
/// into triangles, in the order of the faces. Throws BadInput with the line or the face. Doubts, for example
/// coordinates too large for single precision, are added to `warnings`.
[[nodiscard]] RawMesh read_mesh_file(const std::filesystem::path& path, Problems& warnings);
[[nodiscard]] RawMesh read_mesh_file(const std::filesystem::path& path);

}  // namespace talus
