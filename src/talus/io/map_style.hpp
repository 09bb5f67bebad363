#pragma once
// The style with which QGIS opens a map: a file of the map's name with the ending .qml beside it.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace talus::io {

enum class ColourScale {
  linear,      // from 0 to where most values end
  logarithmic  // from the least value above 0 to the greatest
};

/// Of a map's values above 0; all 0 where there are none.
struct ColourRange {
  double least = 0, greatest = 0;
  double top = 0;  // where the colours end; what is greater has the last of them
  [[nodiscard]] bool is_open_upwards() const { return top < greatest; }
};

/// On a linear scale the colours end at this percentile: the few greatest values, of one rock that flew off a cliff,
/// would take all colours from the others.
inline constexpr double percentile_of_top = 98;

/// Values and their colours, red, green and blue; between two of them colours are mixed.
struct ColourStop {
  double value;
  std::array<std::uint8_t, 3> colour;
};

/// From pale yellow to dark red.
[[nodiscard]] std::vector<ColourStop> colour_ramp(ColourScale scale, const ColourRange& range);

/// The text of a style with these colours; cells without data stay clear.
[[nodiscard]] std::string qgis_style(ColourScale scale, const ColourRange& range);

}  // namespace talus::io
