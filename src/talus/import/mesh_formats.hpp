#pragma once
// The mesh formats, each read from the bytes of a whole file. They throw BadInput; what they only warn of is left in
// `problems`. Bytes from anywhere are safe: counts are believed only as far as the file is long.

#include <string_view>

#include "talus/files/mesh_problems.hpp"
#include "talus/meshing/raw_mesh.hpp"

namespace talus {

/// Files are shorter than this, so that every count of vertices and corners fits 32 bits.
inline constexpr std::uint64_t largest_mesh_file_bytes = 0xFFFFFFFF;

/// Wavefront OBJ (Wavefront Technologies, Advanced Visualizer manual, appendix B1): vertices and faces, with relative
/// indices and continued lines. Texture, normals, colours, groups, materials, lines and points are left out;
/// free-form surfaces too, with a warning.
[[nodiscard]] RawMesh read_obj(std::string_view bytes, MeshProblems& problems);

/// STL, text or binary (3D Systems, StereoLithography Interface Specification, 1989). Every triangle has its own three
/// vertices; the normals in the file are left out, for they are often wrong and say nothing that the corners do not.
[[nodiscard]] RawMesh read_stl(std::string_view bytes, MeshProblems& problems);

/// PLY 1.0, text or binary of either byte order (G. Turk, The PLY polygon file format, 1994): the elements `vertex` and
/// `face`; others are left out. Numbers of a text file are read as doubles, whatever type its header names.
[[nodiscard]] RawMesh read_ply(std::string_view bytes, MeshProblems& problems);

}  // namespace talus
