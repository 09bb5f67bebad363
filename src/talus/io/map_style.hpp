#pragma once
// The style with which QGIS opens a map: a file of the map's name with the ending .qml beside it.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace talus::io {

enum class ColourScale {
  linear,      // from 0 to the greatest value
  logarithmic  // from the least value above 0 to the greatest
};

/// Values and their colours, red, green and blue; between two of them colours are mixed.
struct ColourStop {
  double value;
  std::array<std::uint8_t, 3> colour;
};

/// From pale yellow to dark red. `least` and `greatest` are of the map's values above 0; both 0 where there are none.
[[nodiscard]] std::vector<ColourStop> colour_ramp(ColourScale scale, double least, double greatest);

/// The text of a style with these colours; cells without data stay clear.
[[nodiscard]] std::string qgis_style(ColourScale scale, double least, double greatest);

}  // namespace talus::io
