#pragma once
// Which maps there are: what each is called, what it shows and what it is measured in.

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "talus/io/map_style.hpp"
#include "talus/results/maps.hpp"

namespace talus::io {

/// What a cell of an overview holds of the cells beneath it.
enum class MapOverview { greatest, mean };

struct MapKind {
  std::string name;     // of the file, with its unit
  std::string meaning;  // one phrase, for who opens the file
  std::string unit;     // empty: a number
  ColourScale scale = ColourScale::linear;
  bool is_count = false;  // a whole number; where there is nothing to count it is 0, as where no rock was
  MapOverview overview = MapOverview::greatest;
  std::function<double(const MapTally&)> value;
};

/// For maps of so many rocks; `percentiles` in [0, 100].
[[nodiscard]] std::vector<MapKind> map_kinds(std::uint64_t rocks, std::span<const double> percentiles);

}  // namespace talus::io
