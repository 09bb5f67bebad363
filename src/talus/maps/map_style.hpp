#pragma once
// The colour classes of maps, and the style with which QGIS opens them: NAME.qml next to the map. Classes are fixed for
// each kind of map (map_list.cpp), so that maps of two runs are comparable.

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace talus {

inline constexpr std::size_t map_class_count = 6;

/// The limits between classes; the first class begins at 0, the last has no upper limit.
using ClassLimits = std::array<double, map_class_count - 1>;

/// Values from `from` up to, but not including, `to`, and their colour: red, green and blue.
struct MapClass {
  double from = 0, to = std::numeric_limits<double>::infinity();
  std::array<std::uint8_t, 3> colour{};
};

/// From pale yellow to dark red.
[[nodiscard]] std::array<MapClass, map_class_count> map_classes(const ClassLimits& limits);

/// The minimum and maximum of a map's values above 0; both 0 if there are none.
struct ValueRange {
  double least = 0, greatest = 0;
};

/// What a legend shows values in.
struct MapUnit {
  std::string_view text{};  // empty: none
  double per = 1;           // the unit, in that of the map
};

/// The text of a style with these classes; cells without data stay transparent.
[[nodiscard]] std::string qgis_style(const ClassLimits& limits, const MapUnit& unit, const ValueRange& range);

}  // namespace talus
