#pragma once
// Which maps there are: what each is called, what it shows, what it is measured in and in which classes it is shown.

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
  ClassLimits limits{};
  bool is_count = false;  // a whole number; where there is nothing to count it is 0, as where no rock was
  MapOverview overview = MapOverview::greatest;
};

/// Maps of which a cell's values are found together.
struct MapGroup {
  std::vector<MapKind> kinds;
  /// One value for each kind.
  std::function<void(const MapTally& cell, std::span<double> values)> values;
};

/// For maps of so many rocks with these contents; `percentiles` in [0, 100], of those quantities that have any.
[[nodiscard]] std::vector<MapGroup> map_groups(std::uint64_t rocks, std::span<const double> percentiles,
                                               const MapContents& contents = {});

/// All kinds that there can be, in their order.
[[nodiscard]] std::vector<MapKind> map_kinds(std::span<const double> percentiles);

}  // namespace talus::io
