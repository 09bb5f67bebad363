#pragma once
// The mesh formats, each read from the bytes of a whole file. They throw BadInput and add warnings to `problems`. Any
// bytes are safe: declared counts are checked against the length of the file.

#include <array>
#include <string_view>

#include "talus/files/mesh_problems.hpp"
#include "talus/meshing/raw_mesh.hpp"

namespace talus {

/// Files must be shorter than this, so that every count of vertices and corners fits into 32 bits.
inline constexpr std::uint64_t largest_mesh_file_bytes = 0xFFFFFFFF;

/// Wavefront OBJ (Wavefront Technologies, Advanced Visualizer manual, appendix B1): vertices and faces, with relative
/// indices and continued lines. Textures, normals, colours, groups, materials, lines and points are ignored; free-form
/// surfaces, too, with a warning.
[[nodiscard]] RawMesh read_obj(std::string_view bytes, MeshProblems& problems);

/// STL, text or binary (3D Systems, StereoLithography Interface Specification, 1989). Every triangle has its own three
/// vertices. The normals in the file are ignored: they are often wrong, and redundant.
[[nodiscard]] RawMesh read_stl(std::string_view bytes, MeshProblems& problems);

/// PLY 1.0, text or binary in either byte order (G. Turk, The PLY polygon file format, 1994): the elements `vertex` and
/// `face`; others are ignored. Numbers of a text file are read as doubles, whatever their type in the header.
[[nodiscard]] RawMesh read_ply(std::string_view bytes, MeshProblems& problems);

struct MeshFormat {
  std::string_view ending;  // one of files/file_formats.hpp
  RawMesh (*read)(std::string_view bytes, MeshProblems& problems);
};
inline constexpr std::array mesh_formats{MeshFormat{".obj", read_obj}, MeshFormat{".stl", read_stl},
                                         MeshFormat{".ply", read_ply}};

}  // namespace talus
