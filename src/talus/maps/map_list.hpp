#pragma once
// Which maps there are: what each is called, what it shows, what it is measured in and in which classes it is shown.

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "talus/maps/map_style.hpp"
#include "talus/maps/map_subjects.hpp"
#include "talus/results/maps.hpp"

namespace talus {

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

/// Which maps are made.
struct MapSelection {
  MapSubjects subjects = all_map_subjects;
  std::vector<double> percentiles{};  // in [0, 100], of the quantities among the subjects
};

/// What has to be gathered for them.
[[nodiscard]] MapContents contents_of(const MapSelection& selection);

/// For maps of so many rocks; groups without a map are left out.
[[nodiscard]] std::vector<MapGroup> map_groups(std::uint64_t rocks, const MapSelection& selection);

/// One for each subject, with … in the name for max, mean or a percentile.
[[nodiscard]] std::vector<MapKind> map_families();

/// All of them, in their order.
[[nodiscard]] std::vector<MapKind> map_kinds(const MapSelection& selection);

}  // namespace talus
