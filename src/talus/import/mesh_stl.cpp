#include <fmt/format.h>

#include <algorithm>
#include <boost/endian/conversion.hpp>
#include <cmath>
#include <string>

#include "talus/core/stop.hpp"
#include "talus/import/mesh_formats.hpp"
#include "talus/import/mesh_text.hpp"

namespace talus {
namespace {

// A binary file has 80 bytes of arbitrary text, the number of triangles (32 bits), and 50 bytes for each triangle: the
// normal and three corners as 32-bit floats, and 16 bits without a fixed meaning. All little-endian.
constexpr std::size_t header_bytes = 84;
constexpr std::size_t triangle_bytes = 50;

template <class T>
T load(const char* at) {
  return boost::endian::endian_load<T, sizeof(T), boost::endian::order::little>(
      reinterpret_cast<const unsigned char*>(at));
}

std::uint64_t declared_triangles(std::string_view bytes) { return load<std::uint32_t>(bytes.data() + 80); }

// Many binary files begin with "solid", too, so the length is checked first. No text has the length of a binary file:
// read as a number, its bytes 80 to 83 declare more than 4 GiB.
bool is_text(std::string_view bytes) {
  if (bytes.size() >= header_bytes && header_bytes + declared_triangles(bytes) * triangle_bytes == bytes.size()) {
    return false;
  }
  Lines lines{bytes.substr(0, 1024)};
  bool solid = false;
  while (auto line = lines.next()) {
    if (line->find('\0') != std::string_view::npos) return false;
    if (!solid) {
      const std::string first = lower(take_word(*line));
      if (!first.empty() && first != "solid") return false;
      solid = !first.empty();
    }
  }
  return solid;
}

class StlTextReader {
 public:
  explicit StlTextReader(MeshProblems& problems) : problems_(problems) {}

  RawMesh read(std::string_view bytes) {
    Lines lines{bytes};
    while (auto line = lines.next()) {
      place_.line = lines.number();
      std::string_view rest = *line;
      const std::string_view word = take_word(rest);
      if (!word.empty()) statement(lower(word), word, rest);
    }
    if (inside_ != Inside::file) {
      problems_.refuse(place_, "the file ends too early", "expected " + std::string{expected()},
                       "It may have been cut short");
    }
    problems_.throw_if_any();
    return std::move(mesh_);
  }

 private:
  enum class Inside { file, solid, facet, loop, finished_loop };

  [[nodiscard]] std::string_view expected() const {
    switch (inside_) {
      case Inside::file:
        return "\"solid\"";
      case Inside::solid:
        return "\"facet\" or \"endsolid\"";
      case Inside::facet:
        return "\"outer loop\"";
      case Inside::loop:
        return corners_ < 3 ? "\"vertex\"" : "\"endloop\"";
      case Inside::finished_loop:
        break;
    }
    return "\"endfacet\"";
  }

  void statement(const std::string& keyword, std::string_view as_written, std::string_view rest) {
    if (keyword == "solid" && inside_ == Inside::file) {
      inside_ = Inside::solid;
    } else if (keyword == "endsolid" && inside_ == Inside::solid) {
      inside_ = Inside::file;
    } else if (keyword == "facet" && inside_ == Inside::solid) {
      inside_ = Inside::facet;
    } else if (keyword == "outer" && inside_ == Inside::facet) {
      inside_ = Inside::loop;
      corners_ = 0;
    } else if (keyword == "vertex" && inside_ == Inside::loop && corners_ < 3) {
      vertex(rest);
      ++corners_;
    } else if (keyword == "endloop" && inside_ == Inside::loop && corners_ == 3) {
      inside_ = Inside::finished_loop;
      const auto first = static_cast<std::uint32_t>(mesh_.vertices.size() - 3);
      mesh_.triangles.push_back({first, first + 1, first + 2});
    } else if (keyword == "endfacet" && inside_ == Inside::finished_loop) {
      inside_ = Inside::solid;
    } else {
      problems_.stop(place_, in_quotes(as_written) + " is out of place", "expected " + std::string{expected()});
    }
  }

  void vertex(std::string_view rest) {
    Vec3 position;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::string_view word = take_word(rest);
      if (word.empty()) {
        problems_.refuse(place_, fmt::format("a vertex with {} coordinate{}", axis, axis == 1 ? "" : "s"),
                         "expected x, y and z");
        break;
      }
      const auto number = read_coordinate(word, problems_, place_);
      if (!number) break;
      position[axis] = *number;
    }
    mesh_.vertices.push_back(position);
  }

  MeshProblems& problems_;
  MeshPlace place_;
  RawMesh mesh_;
  Inside inside_ = Inside::file;
  int corners_ = 0;
};

RawMesh read_binary(std::string_view bytes, MeshProblems& problems) {
  if (bytes.size() < header_bytes) {
    problems.stop({}, "is not an STL file",
                  fmt::format("it has {} bytes and does not begin with \"solid\"; a binary STL file has "
                              "at least {}",
                              bytes.size(), header_bytes));
  }
  const std::uint64_t count = declared_triangles(bytes);
  const std::uint64_t needed = header_bytes + count * triangle_bytes;
  if (needed != bytes.size()) {
    problems.stop({}, fmt::format("declares {} triangle{}, but has the wrong length", count, count == 1 ? "" : "s"),
                  fmt::format("they take {} bytes; the file has {}", needed, bytes.size()),
                  needed > bytes.size() ? "It may have been cut short" : "Its header may be damaged");
  }
  RawMesh mesh;
  mesh.vertices.reserve(count * 3);
  mesh.triangles.reserve(count);
  float largest = 0;
  for (std::uint64_t t = 0; t < count; ++t) {
    stop_point(t);
    const char* const corners = bytes.data() + header_bytes + t * triangle_bytes + 12;
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    bool finite = true;
    for (int corner = 0; corner < 3; ++corner) {
      Vec3 position;
      for (int axis = 0; axis < 3; ++axis) {
        const auto value = load<float>(corners + 12 * corner + 4 * axis);
        finite = finite && std::isfinite(value);
        largest = std::max(largest, std::abs(value));
        position[axis] = value;
      }
      mesh.vertices.push_back(position);
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
    if (!finite) {
      problems.refuse({0, fmt::format("triangle {} of {}", t + 1, count)}, "a coordinate is not a finite number",
                      "expected metres");
    }
  }
  problems.throw_if_any();
  warn_of_single_precision(largest, problems);
  return mesh;
}

}  // namespace

RawMesh read_stl(std::string_view bytes, MeshProblems& problems) {
  RawMesh mesh = is_text(bytes) ? StlTextReader{problems}.read(bytes) : read_binary(bytes, problems);
  if (mesh.triangles.empty()) problems.stop({}, "has no triangles", "a terrain needs at least one");
  return mesh;
}

}  // namespace talus
