#pragma once
// Reads the maps of a run for display.

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "talus/maps/map_style.hpp"

namespace talus {

struct MapFile {
  std::string name;     // of its file without `maps/` and extension: passages, by_source/Crest/passages
  std::string meaning;  // one phrase
  std::string unit;     // empty: none
  ClassLimits limits{};
  bool is_share = false;  // MapKind::is_share()
  ValueRange range;       // of the whole map
  std::string source;     // source of its rocks; empty: all
};

/// The maps in a run's folder, in the order of map_list.hpp, those of all rocks first. Empty if the program was built
/// without GDAL. Throws BadInput on a map that cannot be read.
[[nodiscard]] std::vector<MapFile> maps_of_run(const std::filesystem::path& folder);

/// The cells of a map or of an overview.
struct MapValues {
  std::array<double, 2> origin{};  // the south-western corner [m]
  std::array<double, 2> cell{};    // [m]
  int columns = 0, rows = 0;
  std::vector<float> values;  // row by row from the south; NaN: no data
};

/// The size of the smallest overviews.
inline constexpr int least_pixels = 256;

/// The finest of a map's overviews (or the map itself) with at most `pixels` cells a side; expects at least
/// `least_pixels`. Throws BadInput.
[[nodiscard]] MapValues read_map(const std::filesystem::path& folder, const MapFile& map, int pixels);

}  // namespace talus
