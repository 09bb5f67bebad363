#include "talus/import/mesh_ply_header.hpp"

#include <algorithm>
#include <charconv>

#include "talus/import/mesh_text.hpp"

namespace talus::ply {
namespace {

bool is_integer(Type type) { return type != Type::float32 && type != Type::float64; }

// Both the names of 1994 and those with bit widths are in use.
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
        if (!has_format) problems_.stop(place_, "the header has no format", "for example `format ascii 1.0`");
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
      problems_.stop(place_, in_quotes(word) + " is not a count of elements", "for example `element vertex 8`");
    }
    header_.elements.push_back(std::move(element));
  }

  void property(std::string_view line) {
    if (header_.elements.empty())
      problems_.stop(place_, "a property before any element", "a property belongs to the element before it");
    Property property;
    std::string_view word = take_word(line);
    if (word == "list") {
      property.length = type(take_word(line));
      if (!is_integer(*property.length)) {
        problems_.stop(place_, "the length of a list has no integer type", "for example uchar or int");
      }
      word = take_word(line);
    }
    property.type = type(word);
    property.name = take_word(line);
    if (property.name.empty()) {
      problems_.stop(place_, "a property without a name", "for example `property double x`");
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
               return p.name == name && p.length.has_value() == list && (!list || is_integer(p.type));
             }) == 1;
    };
    if (element.properties.empty() && element.count > 0) {
      problems_.refuse(place, "the element " + in_quotes(element.name) + " has no properties",
                       "so there is nothing to read");
    } else if (element.name == "vertex" && !(has("x", false) && has("y", false) && has("z", false))) {
      problems_.refuse(place, "the element \"vertex\" must have the properties x, y and z, once each",
                       "they are its position");
    } else if (element.name == "face" && element.count > 0 &&
               has("vertex_indices", true) + has("vertex_index", true) != 1) {
      problems_.refuse(place, "the element \"face\" must have one list vertex_indices of integers",
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

}  // namespace

bool Header::declares(std::string_view name) const {
  return std::any_of(elements.begin(), elements.end(),
                     [&](const Element& element) { return element.name == name && element.count > 0; });
}

Header read_header(std::string_view bytes, MeshProblems& problems) { return HeaderReader{bytes, problems}.read(); }

}  // namespace talus::ply
