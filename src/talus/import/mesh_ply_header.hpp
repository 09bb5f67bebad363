#pragma once
// The header of a PLY file: its encoding and the elements that follow.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "talus/files/mesh_problems.hpp"

namespace talus::ply {

enum class Type { int8, uint8, int16, uint16, int32, uint32, float32, float64 };
enum class Encoding { text, little_endian, big_endian };

[[nodiscard]] constexpr std::size_t bytes_of(Type type) {
  constexpr std::array<std::size_t, 8> bytes{1, 1, 2, 2, 4, 4, 4, 8};
  return bytes[static_cast<std::size_t>(type)];
}

struct Property {
  std::string name;
  Type type = Type::float64;
  std::optional<Type> length;  // of a list; nullopt for a single value
};

struct Element {
  std::string name;
  std::uint64_t count = 0;
  std::uint32_t line = 0;  // of its declaration
  std::vector<Property> properties;
};

struct Header {
  Encoding encoding = Encoding::text;
  std::vector<Element> elements;
  std::string_view body;    // the bytes after the header
  std::uint32_t lines = 0;  // of the header

  /// Whether the file has such elements.
  [[nodiscard]] bool declares(std::string_view name) const;
};

/// Throws BadInput for a header with errors, and if `vertex` or `face` lack the properties that Talus reads.
[[nodiscard]] Header read_header(std::string_view bytes, MeshProblems& problems);

}  // namespace talus::ply
