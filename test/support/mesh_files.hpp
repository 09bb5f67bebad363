#pragma once
// Small mesh files of each format, and reading them.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "support/input_folder.hpp"
#include "support/replaced.hpp"
#include "talus/import/mesh_file.hpp"

namespace talus::testing_tools {

class MeshFiles : public InputFolder {
 protected:
  [[nodiscard]] RawMesh read(const std::string& name, std::string_view bytes) {
    write(name, bytes);
    warnings_ = Problems{};
    return read_mesh_file(path(name), warnings_);
  }
  [[nodiscard]] std::string refusal(const std::string& name) const {
    return refusal_of([&] { static_cast<void>(read_mesh_file(path(name))); });
  }
  [[nodiscard]] std::string refusal(const std::string& name, std::string_view bytes) const {
    write(name, bytes);
    return refusal(name);
  }
};

/// The bytes of a number.
template <class T>
[[nodiscard]] std::string bytes_of(T value, std::endian order) {
  std::array<char, sizeof(T)> bytes{};
  std::memcpy(bytes.data(), &value, sizeof(T));
  if (order != std::endian::native) std::reverse(bytes.begin(), bytes.end());
  return {bytes.data(), bytes.size()};
}

[[nodiscard]] inline std::string binary_stl(std::uint32_t declared,
                                            const std::vector<std::array<std::array<float, 3>, 3>>& triangles,
                                            std::string head = "made by hand") {
  head.resize(80, ' ');
  std::string out = head + bytes_of(declared, std::endian::little);
  for (const auto& triangle : triangles) {
    out += std::string(12, '\0');
    for (const auto& corner : triangle) {
      for (const float value : corner) out += bytes_of(value, std::endian::little);
    }
    out += std::string(2, '\0');
  }
  return out;
}

inline const std::array<std::array<float, 3>, 3> one_stl_triangle{{{0, 0, 0}, {1, 0, 0.5F}, {0, 1, 0.25F}}};

/// Swiss coordinates to a tenth of a micrometre, which single precision cannot represent.
inline const std::vector<Vec3> swiss{{2'600'000.123456, 1'200'000.654321, 450.0000001},
                                     {2'600'001.123456, 1'200'000.654321, 451.25},
                                     {2'600'000.123456, 1'200'001.654321, 449.75}};

[[nodiscard]] inline std::string binary_ply(std::endian order, bool faces_first = false) {
  const std::string vertices =
      "element vertex 3\nproperty uchar red\nproperty double x\nproperty double y\n"
      "property double z\nproperty list uchar short tags\n";
  const std::string faces = "element face 1\nproperty list uchar int vertex_indices\nproperty float quality\n";
  std::string vertex_bytes;
  for (const Vec3& v : swiss) {
    vertex_bytes += '\x7f';
    for (int axis = 0; axis < 3; ++axis) vertex_bytes += bytes_of(v[axis], order);
    vertex_bytes += '\x02' + bytes_of(std::int16_t{5}, order) + bytes_of(std::int16_t{-7}, order);
  }
  std::string face_bytes = "\x03";
  for (const std::int32_t corner : {2, 0, 1}) face_bytes += bytes_of(corner, order);
  face_bytes += bytes_of(0.5F, order);
  const std::string format = order == std::endian::little ? "binary_little_endian" : "binary_big_endian";
  return "ply\nformat " + format + " 1.0\ncomment by hand\n" + (faces_first ? faces + vertices : vertices + faces) +
         "end_header\n" + (faces_first ? face_bytes + vertex_bytes : vertex_bytes + face_bytes);
}

inline const std::string text_ply =
    "ply\nformat ascii 1.0\ncomment a square\nobj_info by hand\nelement vertex 4\nproperty float x\nproperty float y\n"
    "property float z\nproperty uchar red\nelement face 2\nproperty list uchar int vertex_index\nelement edge 1\n"
    "property int from\nproperty int to\nend_header\n"
    "2600000.123456 0 0 255\n1 0 0 255\n1 1 0 255\n0 1 0 255\n3 0 1 2\n3 0 2 3\n0 2\n";

inline const std::string text_stl =
    "solid a slope\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 1 0 0.5\n   vertex 0 1 0.25\n"
    "  endloop\n endfacet\nendsolid a slope\n";

inline const std::string square_obj = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

}  // namespace talus::testing_tools
