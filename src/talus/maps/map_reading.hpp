#pragma once
// Maps that a run has written, read for showing.

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "talus/maps/map_style.hpp"

namespace talus {

struct MapFile {
  std::string name;  // of the file in the run's folder, without `maps/` and ending: passages, by_source/Crest/passages
  std::string meaning;  // one phrase
  std::string unit;     // empty: a number
  ClassLimits limits{};
  ValueRange range;    // of the whole map
  std::string source;  // whose rocks it is of; empty: all
};

/// The maps in a run's folder, in the order of map_list.hpp, those of all rocks first. None where the program was built
/// without GDAL. Throws BadInput on a map that cannot be read.
[[nodiscard]] std::vector<MapFile> maps_of_run(const std::filesystem::path& folder);

/// A map's cells, or those of an overview.
struct MapValues {
  std::array<double, 2> origin{};  // the south-western corner [m]
  std::array<double, 2> cell{};    // [m]
  int columns = 0, rows = 0;
  std::vector<float> values;  // row by row from the south; NaN: no data
};

/// No overviews are made that are smaller.
inline constexpr int least_pixels = 256;

/// The finest of a map's overviews (or the map itself) that has at most so many cells a side; expects `least_pixels` at
/// the least. Throws BadInput.
[[nodiscard]] MapValues read_map(const std::filesystem::path& folder, const MapFile& map, int pixels);

}  // namespace talus
