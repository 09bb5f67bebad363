#include "talus/import/point_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>

#include "talus/core/utf8.hpp"
#include "talus/files/data_table.hpp"
#include "talus/import/mesh_text.hpp"

namespace talus {

std::optional<PointColumn> meaning_of_point_column(std::string_view name) {
  std::string word;
  for (const char c : lower(in_ascii(name))) {
    if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) word += c;
  }
  static constexpr std::array<std::array<std::string_view, 9>, 3> names{{
      {"x", "e", "east", "easting", "xcoord", "xcoordinate", "rechtswert", "rw", "eastings"},
      {"y", "n", "north", "northing", "ycoord", "ycoordinate", "hochwert", "hw", "northings"},
      {"z", "h", "height", "elevation", "elev", "alt", "altitude", "zcoord", "hoehe"},
  }};
  static constexpr std::array<std::string_view, 5> metres{"", "m", "metre", "metres", "meters"};
  static constexpr std::array<std::string_view, 5> feet{"ft", "feet", "foot", "usft", "ftus"};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const std::string_view known : names[axis]) {
      if (known.empty() || !word.starts_with(known)) continue;
      const std::string_view unit = std::string_view(word).substr(known.size());
      for (const std::string_view m : metres) {
        if (unit == m) return PointColumn{axis, false};
      }
      for (const std::string_view ft : feet) {
        if (unit == ft) return PointColumn{axis, true};
      }
    }
  }
  return std::nullopt;
}

bool means_distance(std::string_view name) {
  const std::string plain = plain_column_name(name);
  return std::ranges::any_of(
      std::array<std::string_view, 3>{"distance", "station", "chainage"},
      [&](std::string_view word) { return plain == word || plain == fmt::format("{}_m", word); });
}

bool means_degrees(std::string_view name) {
  const std::string word = lower(name);
  return word.starts_with("lat") || word.starts_with("lon") || word == "lng";
}

}  // namespace talus
