#pragma once
// The style with which QGIS opens a map: a file of the map's name with the ending .qml beside it.

#include <string>

namespace talus::io {

enum class ColourScale {
  linear,      // from 0 to the greatest value
  logarithmic  // from the least value above 0 to the greatest
};

/// The text of a style that colours cells from pale yellow to dark red; cells without data stay clear. `least` and
/// `greatest` are of the map's values above 0; both 0 where there are none.
[[nodiscard]] std::string qgis_style(ColourScale scale, double least, double greatest);

}  // namespace talus::io
