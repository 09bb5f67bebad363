#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/endian/conversion.hpp>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "talus/core/stop.hpp"
#include "talus/import/mesh_formats.hpp"
#include "talus/import/mesh_polygons.hpp"
#include "talus/import/mesh_text.hpp"

namespace talus {
namespace {

enum class Type { int8, uint8, int16, uint16, int32, uint32, float32, float64 };
enum class Encoding { text, little_endian, big_endian };

constexpr std::array<std::size_t, 8> bytes_of_type{1, 1, 2, 2, 4, 4, 4, 8};

std::size_t bytes_of(Type type) { return bytes_of_type[static_cast<std::size_t>(type)]; }

bool is_whole(Type type) { return type != Type::float32 && type != Type::float64; }

// Both the names of 1994 and those with widths are in use.
std::optional<Type> type_named(std::string_view name) {
  constexpr std::array<std::array<std::string_view, 2>, 8> names{{{"char", "int8"},
                                                                  {"uchar", "uint8"},
                                                                  {"short", "int16"},
                                                                  {"ushort", "uint16"},
                                                                  {"int", "int32"},
                                                                  {"uint", "uint32"},
                                                                  {"float", "float32"},
                                                                  {"double", "float64"}}};
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (name == names[i][0] || name == names[i][1]) return static_cast<Type>(i);
  }
  return std::nullopt;
}

struct Property {
  std::string name;
  Type type = Type::float64;
  std::optional<Type> length;  // of a list; nothing for a single value
};

struct Element {
  std::string name;
  std::uint64_t count = 0;
  std::uint32_t line = 0;
  std::vector<Property> properties;
};

struct Header {
  Encoding encoding = Encoding::text;
  std::vector<Element> elements;
  std::string_view body;
  std::uint32_t lines = 0;
};

// ---- the header ----

class HeaderReader {
 public:
  HeaderReader(std::string_view bytes, MeshProblems& problems) : lines_(bytes), problems_(problems) {}

  Header read() {
    if (lines_.next() != "ply") problems_.stop({1, ""}, "is not a PLY file", "its first line must be `ply`");
    bool has_format = false;
    while (auto line = lines_.next()) {
      place_.line = lines_.number();
      const std::string_view keyword = take_word(*line);
      if (keyword == "end_header") {
        if (!has_format)
          problems_.stop(place_, "the header names no format", "expected `format ascii 1.0` or the like");
        header_.body = lines_.rest();
        header_.lines = lines_.number();
        for (const Element& element : header_.elements) check(element);
        problems_.throw_if_any();
        return std::move(header_);
      }
      if (keyword == "format") {
        format(*line);
        has_format = true;
      } else if (keyword == "element") {
        element(*line);
      } else if (keyword == "property") {
        property(*line);
      } else if (!keyword.empty() && keyword != "comment" && keyword != "obj_info") {
        problems_.stop(place_, in_quotes(keyword) + " is not a statement of a PLY header",
                       "expected format, element, property, comment, obj_info or end_header");
      }
    }
    problems_.stop({lines_.number(), ""}, "the header has no end", "expected `end_header`",
                   "The file may have been cut short");
  }

 private:
  void format(std::string_view line) {
    const std::string_view encoding = take_word(line);
    if (encoding == "ascii") {
      header_.encoding = Encoding::text;
    } else if (encoding == "binary_little_endian") {
      header_.encoding = Encoding::little_endian;
    } else if (encoding == "binary_big_endian") {
      header_.encoding = Encoding::big_endian;
    } else {
      problems_.stop(place_, "the format " + in_quotes(encoding) + " is unknown",
                     "expected ascii, binary_little_endian or binary_big_endian");
    }
    const std::string_view version = take_word(line);
    if (version != "1.0") problems_.stop(place_, "the version " + in_quotes(version) + " is unknown", "expected 1.0");
  }

  void element(std::string_view line) {
    Element element;
    element.name = take_word(line);
    element.line = place_.line;
    const std::string_view word = take_word(line);
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), element.count);
    if (error != std::errc() || end != word.data() + word.size()) {
      problems_.stop(place_, in_quotes(word) + " is not a number of elements",
                     "expected `element vertex 8` or the like");
    }
    header_.elements.push_back(std::move(element));
  }

  void property(std::string_view line) {
    if (header_.elements.empty()) problems_.stop(place_, "a property before any element", "it belongs to none");
    Property property;
    std::string_view word = take_word(line);
    if (word == "list") {
      property.length = type(take_word(line));
      if (!is_whole(*property.length)) {
        problems_.stop(place_, "the length of a list has a type with a fraction", "expected uchar, int or the like");
      }
      word = take_word(line);
    }
    property.type = type(word);
    property.name = take_word(line);
    if (property.name.empty()) {
      problems_.stop(place_, "a property without a name", "expected `property double x` or the like");
    }
    header_.elements.back().properties.push_back(std::move(property));
  }

  Type type(std::string_view name) {
    if (const auto known = type_named(name)) return *known;
    problems_.stop(place_, "the type " + in_quotes(name) + " is unknown",
                   "expected char, uchar, short, ushort, int, uint, float or double, or int8 to float64");
  }

  void check(const Element& element) {
    const MeshPlace place{element.line, ""};
    const auto has = [&](std::string_view name, bool list) {
      return std::count_if(element.properties.begin(), element.properties.end(), [&](const Property& p) {
               return p.name == name && p.length.has_value() == list && (!list || is_whole(p.type));
             }) == 1;
    };
    if (element.properties.empty() && element.count > 0) {
      problems_.refuse(place, "the element " + in_quotes(element.name) + " has no properties",
                       "so nothing can be read of it");
    } else if (element.name == "vertex" && !(has("x", false) && has("y", false) && has("z", false))) {
      problems_.refuse(place, "the element \"vertex\" must have the properties x, y and z, once each",
                       "they are its position");
    } else if (element.name == "face" && element.count > 0 &&
               has("vertex_indices", true) + has("vertex_index", true) != 1) {
      problems_.refuse(place, "the element \"face\" must have one list vertex_indices of whole numbers",
                       "they are its corners");
    }
    const bool twice = std::count_if(header_.elements.begin(), header_.elements.end(),
                                     [&](const Element& other) { return other.name == element.name; }) > 1;
    if (twice && (element.name == "vertex" || element.name == "face")) {
      problems_.refuse(place, "the element " + in_quotes(element.name) + " is declared more than once", "expected one");
    }
  }

  Lines lines_;
  MeshProblems& problems_;
  MeshPlace place_;
  Header header_;
};

// ---- the body ----
// A body gives the values of one element after another. What cannot be read is noted in the problems, and the answer is
// empty; the rest of that element is then left alone.

class TextBody {
 public:
  TextBody(const Header& header, MeshProblems& problems) : lines_(header.body, header.lines), problems_(problems) {}

  // A value is at least a digit and what parts it from the next; only the last one needs nothing behind it.
  [[nodiscard]] std::uint64_t room_for(const Element& element) const {
    return (lines_.rest().size() + 1) / (2 * element.properties.size());
  }

  void begin(const Element& element, std::uint64_t number) {
    do {
      const auto line = lines_.next();
      if (!line) {
        problems_.stop({lines_.number(), ""}, "the file ends too early",
                       fmt::format("{} {} of {} is missing", element.name, number + 1, element.count),
                       "It may have been cut short");
      }
      line_ = *line;
    } while (is_blank(line_));
    place_.line = lines_.number();
  }

  void end() {
    if (is_blank(line_)) return;
    problems_.refuse(place_, "the line has more values than the header declares", "each element has its own line");
  }

  std::optional<double> real(const Property& property) {
    const auto value = word(property);
    return value ? read_coordinate(*value, problems_, place_) : std::nullopt;
  }

  std::optional<std::int64_t> whole(const Property& property) {
    const auto value = word(property);
    if (!value) return std::nullopt;
    const auto number = whole_number(*value);
    if (!number) problems_.refuse(place_, in_quotes(*value) + " is not a whole number", "expected " + property.name);
    return number;
  }

  std::optional<std::uint64_t> length(const Property& property) {
    const auto number = whole(property);
    if (number && *number < 0) {
      problems_.refuse(place_, fmt::format("a list with {} values", *number), "a length is not negative");
      return std::nullopt;
    }
    return number;
  }

  bool skip(const Property& property, std::uint64_t count) {
    for (std::uint64_t i = 0; i < count; ++i) {
      if (!word(property)) return false;
    }
    return true;
  }

  void finish() {
    while (const auto line = lines_.next()) {
      if (!is_blank(*line)) {
        problems_.stop({lines_.number(), ""}, "the file goes on after its last element",
                       "the header declares fewer elements than there are lines");
      }
    }
  }

  [[nodiscard]] const MeshPlace& place() const { return place_; }
  [[nodiscard]] std::uint32_t line() const { return place_.line; }

 private:
  static bool is_blank(std::string_view line) { return take_word(line).empty(); }

  std::optional<std::string_view> word(const Property& property) {
    const std::string_view next = take_word(line_);
    if (!next.empty()) return next;
    problems_.refuse(place_, "the line has fewer values than the header declares", property.name + " is missing");
    return std::nullopt;
  }

  Lines lines_;
  MeshProblems& problems_;
  MeshPlace place_;
  std::string_view line_;
};

template <boost::endian::order order>
class BinaryBody {
 public:
  BinaryBody(const Header& header, MeshProblems& problems) : rest_(header.body), problems_(problems) {}

  [[nodiscard]] std::uint64_t room_for(const Element& element) const {
    std::size_t least = 0;
    for (const Property& property : element.properties) least += bytes_of(property.length.value_or(property.type));
    return rest_.size() / least;
  }

  void begin(const Element& element, std::uint64_t number) {
    element_ = &element;
    number_ = number;
  }

  void end() {}

  std::optional<double> real(const Property& property) {
    if (property.type == Type::float64) return finite(take<double>());
    if (property.type == Type::float32) {
      const auto value = take<float>();
      if (std::isfinite(value)) largest_ = std::max(largest_, std::abs(value));
      return finite(value);
    }
    return static_cast<double>(*whole(property));
  }

  std::optional<std::int64_t> whole(const Property& property) { return whole(property.type); }

  std::optional<std::uint64_t> length(const Property& property) {
    const std::int64_t length = whole(*property.length);
    if (length < 0 || static_cast<std::uint64_t>(length) > rest_.size() / bytes_of(property.type)) {
      problems_.stop(place(), fmt::format("a list with {} values", length),
                     fmt::format("{} bytes are left in the file", rest_.size()), "The file may be damaged");
    }
    return static_cast<std::uint64_t>(length);
  }

  bool skip(const Property& property, std::uint64_t count) {
    need(count * bytes_of(property.type));
    rest_.remove_prefix(count * bytes_of(property.type));
    return true;
  }

  // Some programs end the file with a line feed or fill it up with zeros.
  void finish() {
    if (rest_.find_first_not_of(std::string_view{"\0\r\n", 3}) != std::string_view::npos) {
      problems_.stop({}, fmt::format("{} bytes follow the last element", rest_.size()),
                     "the header declares fewer elements than there are");
    }
    warn_of_single_precision(largest_, problems_);
  }

  [[nodiscard]] MeshPlace place() const {
    return {0, fmt::format("{} {} of {}", element_->name, number_ + 1, element_->count)};
  }
  [[nodiscard]] std::uint32_t line() const { return 0; }

 private:
  void need(std::uint64_t bytes) {
    if (bytes <= rest_.size()) return;
    problems_.stop(place(), "the file ends too early",
                   fmt::format("{} bytes are left of {} needed", rest_.size(), bytes), "It may have been cut short");
  }

  template <class T>
  T take() {
    need(sizeof(T));
    const auto value =
        boost::endian::endian_load<T, sizeof(T), order>(reinterpret_cast<const unsigned char*>(rest_.data()));
    rest_.remove_prefix(sizeof(T));
    return value;
  }

  std::int64_t whole(Type type) {
    switch (type) {
      case Type::int8:
        return take<std::int8_t>();
      case Type::uint8:
        return take<std::uint8_t>();
      case Type::int16:
        return take<std::int16_t>();
      case Type::uint16:
        return take<std::uint16_t>();
      case Type::int32:
        return take<std::int32_t>();
      case Type::uint32:
        return take<std::uint32_t>();
      case Type::float32:
      case Type::float64:
        break;  // the header's check has refused them here
    }
    return 0;
  }

  std::optional<double> finite(double value) {
    if (std::isfinite(value)) return value;
    problems_.refuse(place(), "a coordinate is not a finite number", "expected metres");
    return 0.0;
  }

  std::string_view rest_;
  MeshProblems& problems_;
  const Element* element_ = nullptr;
  std::uint64_t number_ = 0;
  float largest_ = 0;
};

template <class Body>
void read_vertex(Body& body, const Element& element, PolygonMesh& mesh) {
  Vec3 position = Vec3::Zero();
  for (const Property& property : element.properties) {
    const bool is_position = property.name == "x" || property.name == "y" || property.name == "z";
    if (property.length) {
      const auto length = body.length(property);
      if (!length || !body.skip(property, *length)) return;
    } else if (is_position) {
      const auto value = body.real(property);
      if (!value) return;
      position[property.name[0] - 'x'] = *value;
    } else if (!body.skip(property, 1)) {
      return;
    }
  }
  mesh.vertices.push_back(position);
  body.end();
}

template <class Body>
bool read_corners(Body& body, const Property& property, PolygonMesh& mesh, MeshProblems& problems) {
  const auto length = body.length(property);
  if (!length) return false;
  for (std::uint64_t i = 0; i < *length; ++i) {
    const auto index = body.whole(property);
    if (!index) return false;
    if (*index < 0 || *index > std::numeric_limits<std::uint32_t>::max()) {
      problems.refuse(body.place(), fmt::format("vertex {} does not exist", *index), "PLY counts vertices from 0");
      return false;
    }
    mesh.corners.push_back(static_cast<std::uint32_t>(*index));
  }
  return true;
}

template <class Body>
void read_face(Body& body, const Element& element, PolygonMesh& mesh, MeshProblems& problems) {
  for (const Property& property : element.properties) {
    if (property.name == "vertex_indices" || property.name == "vertex_index") {
      if (!read_corners(body, property, mesh, problems)) return;
    } else if (property.length) {
      const auto length = body.length(property);
      if (!length || !body.skip(property, *length)) return;
    } else if (!body.skip(property, 1)) {
      return;
    }
  }
  mesh.ends.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
  if (body.line() > 0) mesh.lines.push_back(body.line());
  body.end();
}

template <class Body>
void read_other(Body& body, const Element& element) {
  for (const Property& property : element.properties) {
    std::optional<std::uint64_t> count = 1;
    if (property.length) count = body.length(property);
    if (!count || !body.skip(property, *count)) return;
  }
  body.end();
}

template <class Body>
PolygonMesh read_body(Body body, const Header& header, MeshProblems& problems) {
  PolygonMesh mesh;
  for (const Element& element : header.elements) {
    if (element.count == 0) continue;
    const std::uint64_t room = body.room_for(element);
    if (element.count > room) {
      problems.stop(
          {element.line, ""}, fmt::format("the header declares {} of {}", element.count, in_quotes(element.name)),
          fmt::format("what is left of the file has room for {} at most", room), "The file may have been cut short");
    }
    if (element.name == "vertex") mesh.vertices.reserve(element.count);
    if (element.name == "face") mesh.ends.reserve(element.count);
    for (std::uint64_t i = 0; i < element.count; ++i) {
      stop_point(i);
      body.begin(element, i);
      if (element.name == "vertex") {
        read_vertex(body, element, mesh);
      } else if (element.name == "face") {
        read_face(body, element, mesh, problems);
      } else {
        read_other(body, element);
      }
    }
  }
  body.finish();
  return mesh;
}

bool declares(const Header& header, std::string_view name) {
  return std::any_of(header.elements.begin(), header.elements.end(),
                     [&](const Element& element) { return element.name == name && element.count > 0; });
}

PolygonMesh read_any_body(const Header& header, MeshProblems& problems) {
  switch (header.encoding) {
    case Encoding::text:
      return read_body(TextBody{header, problems}, header, problems);
    case Encoding::little_endian:
      return read_body(BinaryBody<boost::endian::order::little>{header, problems}, header, problems);
    case Encoding::big_endian:
      break;
  }
  return read_body(BinaryBody<boost::endian::order::big>{header, problems}, header, problems);
}

}  // namespace

RawMesh read_ply(std::string_view bytes, MeshProblems& problems) {
  const Header header = HeaderReader{bytes, problems}.read();
  if (!declares(header, "vertex")) problems.stop({}, "has no vertices", "the header declares no element vertex");
  if (!declares(header, "face")) {
    problems.stop({}, "has no faces", "the header declares no element face",
                  declares(header, "tristrips") ? "Write triangles instead of strips" : "Triangulate the points first");
  }
  PolygonMesh mesh = read_any_body(header, problems);
  problems.throw_if_any();
  return triangulated(std::move(mesh), problems);
}

}  // namespace talus
