#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <string>

#include "talus/import/mesh_formats.hpp"
#include "talus/import/mesh_polygons.hpp"
#include "talus/import/mesh_text.hpp"

namespace talus {
namespace {

// Statements that do not affect the surface.
constexpr std::array<std::string_view, 14> ignored{"vt",     "vn",     "vp", "g", "o",     "s",   "mg",
                                                   "mtllib", "usemtl", "l",  "p", "bevel", "lod", "usemap"};

class ObjReader {
 public:
  explicit ObjReader(MeshProblems& problems) : problems_(problems) { mesh_.first_number = 1; }

  void read(std::string_view bytes) {
    Lines lines{bytes};
    std::string joined;
    while (auto line = lines.next()) {
      place_.line = lines.number();
      const std::size_t comment = line->find('#');
      // Only a line without a comment can be continued: a path in a comment may end in a backslash.
      if (comment == std::string_view::npos && continues(*line)) {
        joined.assign(line->substr(0, line->size() - 1));
        while (auto more = lines.next()) {
          const bool again = continues(*more);
          joined.append(1, ' ').append(more->substr(0, more->size() - (again ? 1 : 0)));
          if (!again) break;
        }
        line = joined;
      }
      statement(line->substr(0, line->find('#')));
    }
  }

  [[nodiscard]] RawMesh mesh() {
    if (mesh_.vertices.empty()) {
      problems_.stop({}, "has no vertices", "an OBJ file has a line such as `v 1.0 2.0 3.0` for each");
    }
    if (mesh_.ends.empty() && !bad_face_) {
      problems_.stop({}, "has no faces", "points alone are not a surface", "Triangulate the points first");
    }
    return triangulated(std::move(mesh_), problems_);
  }

 private:
  static bool continues(std::string_view line) { return !line.empty() && line.back() == '\\'; }

  void statement(std::string_view line) {
    const std::string_view keyword = take_word(line);
    if (keyword == "v") {
      vertex(line);
    } else if (keyword == "f" || keyword == "fo") {  // fo: a face in files of version 2
      face(line);
    } else if (!keyword.empty() && std::find(ignored.begin(), ignored.end(), keyword) == ignored.end()) {
      unknown(keyword);
    }
  }

  // A weight, a colour or both may follow x, y, z; they are ignored, but must be numbers.
  void vertex(std::string_view line) {
    constexpr std::size_t most_numbers = 8;
    Vec3 position;
    std::size_t count = 0;
    bool is_valid = true;
    for (std::string_view word = take_word(line); is_valid && !word.empty(); word = take_word(line)) {
      if (count == most_numbers) {
        problems_.refuse(place_, "a vertex with more than 8 numbers",
                         "expected x, y, z, and at most a weight and a colour");
        is_valid = false;
      } else if (const auto number = read_coordinate(word, problems_, place_)) {
        if (count < 3) position[count] = *number;
        ++count;
      } else {
        is_valid = false;
      }
    }
    if (is_valid && count < 3) {
      problems_.refuse(place_, fmt::format("a vertex with {} coordinate{}", count, count == 1 ? "" : "s"),
                       "expected x, y and z");
    }
    mesh_.vertices.push_back(position);  // even if it is bad, so that the numbers of later vertices stay right
  }

  void face(std::string_view line) {
    const std::size_t begin = mesh_.corners.size();
    for (std::string_view word = take_word(line); !word.empty(); word = take_word(line)) {
      const auto index = corner(word);
      if (!index) {
        mesh_.corners.resize(begin);
        bad_face_ = true;
        return;
      }
      mesh_.corners.push_back(*index);
    }
    mesh_.ends.push_back(static_cast<std::uint32_t>(mesh_.corners.size()));
    mesh_.lines.push_back(place_.line);
  }

  // A corner is v, v/vt, v//vn or v/vt/vn.
  std::optional<std::uint32_t> corner(std::string_view word) {
    std::array<std::string_view, 3> parts;
    std::size_t count = 0;
    for (std::string_view rest = word;; ++count) {
      const std::size_t slash = rest.find('/');
      if (count < 3) parts[count] = rest.substr(0, slash);
      if (slash == std::string_view::npos) break;
      rest.remove_prefix(slash + 1);
    }
    const auto vertex_number = whole_number(parts[0]);
    const bool others_fit =
        count < 3 && (parts[1].empty() || whole_number(parts[1])) && (parts[2].empty() || whole_number(parts[2]));
    if (!vertex_number || !others_fit) {
      problems_.refuse(place_, in_quotes(word) + " is not a corner of a face",
                       "expected 7, 7/1, 7//3 or 7/1/3, all integers");
      return std::nullopt;
    }
    return index(*vertex_number);
  }

  std::optional<std::uint32_t> index(std::int64_t number) {
    const auto vertices = static_cast<std::int64_t>(mesh_.vertices.size());
    if (number == 0) {
      problems_.refuse(place_, "vertex 0 does not exist", "OBJ numbers vertices from 1");
    } else if (number < -vertices) {
      problems_.refuse(
          place_, fmt::format("vertex {} does not exist", number),
          fmt::format("{} {} this line", vertices, vertices == 1 ? "vertex precedes" : "vertices precede"));
    } else if (number > 0xFFFFFFFF) {
      problems_.refuse(place_, fmt::format("vertex {} does not exist", number), "an index has at most 32 bits");
    } else {
      return static_cast<std::uint32_t>(number > 0 ? number - 1 : vertices + number);
    }
    return std::nullopt;
  }

  void unknown(std::string_view keyword) {
    constexpr std::size_t most_warnings = 5;
    if (unknown_.size() == most_warnings || !unknown_.insert(std::string{keyword}).second) return;
    problems_.warn(place_, "the statement " + in_quotes(keyword) + " is ignored",
                   "Talus reads vertices (v) and faces (f) of OBJ files");
  }

  MeshProblems& problems_;
  MeshPlace place_;
  PolygonMesh mesh_;
  std::set<std::string> unknown_;
  bool bad_face_ = false;
};

}  // namespace

RawMesh read_obj(std::string_view bytes, MeshProblems& problems) {
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);  // the byte order mark of UTF-8
  ObjReader reader{problems};
  reader.read(bytes);
  return reader.mesh();
}

}  // namespace talus
