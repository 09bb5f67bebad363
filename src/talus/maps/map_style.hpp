#pragma once
// The classes in which maps are shown, and the style with which QGIS opens them: a file of the map's name with the
// ending .qml beside it. Classes are fixed for each kind of map (map_list.cpp says them), so that the maps of two runs
// compare.

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace talus {

inline constexpr std::size_t map_class_count = 6;

/// Where one class ends and the next begins; the first begins at 0, the last has no end.
using ClassLimits = std::array<double, map_class_count - 1>;

/// Values from `from` up to, but not, `to`, and their colour: red, green and blue.
struct MapClass {
  double from = 0, to = std::numeric_limits<double>::infinity();
  std::array<std::uint8_t, 3> colour{};
};

/// From pale yellow to dark red.
[[nodiscard]] std::array<MapClass, map_class_count> map_classes(const ClassLimits& limits);

/// The least and the greatest of a map's values above 0; both 0 where there are none.
struct ValueRange {
  double least = 0, greatest = 0;
};

/// The text of a style with these classes; cells without data stay clear. `unit` may be empty.
[[nodiscard]] std::string qgis_style(const ClassLimits& limits, const std::string& unit, const ValueRange& range);

}  // namespace talus
