#pragma once
// Maps as arrays.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "talus/maps/map_list.hpp"
#include "talus/results/maps.hpp"

namespace talus::python {

struct MapArray {
  std::string unit, meaning;  // unit: empty: none
  bool is_count = false;
  ClassLimits limits{};
  int columns = 0, rows = 0;
  std::array<double, 2> corner{}, cell{};  // the north-western corner of the map, and the size of a cell [m]
  std::vector<float> values;               // row by row from the north; NaN: no rock
};

/// The map of this name over the cells that rocks touched; nullopt if the selection has none of this name, or if no
/// rock touched a cell.
[[nodiscard]] std::optional<MapArray> map_array(const MapsOfRun& maps, const MapSelection& selection,
                                                std::string_view name);

}  // namespace talus::python
