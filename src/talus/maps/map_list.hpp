#pragma once
// The list of maps: the name, meaning, unit and classes of each.

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "talus/maps/map_cells.hpp"
#include "talus/maps/map_style.hpp"
#include "talus/maps/map_subjects.hpp"
#include "talus/results/maps.hpp"

namespace talus {

/// The value of an overview cell: the maximum or the mean of the cells beneath it.
enum class MapOverview { maximum, mean };

struct MapKind {
  std::string name;     // of the file, including the unit
  std::string meaning;  // one phrase, stored in the file
  std::string unit;     // empty: none
  ClassLimits limits{};
  bool is_count = false;  // a whole number, 0 in cells without a rock
  MapOverview overview = MapOverview::maximum;

  /// 0 to 1; legends show it in percent.
  [[nodiscard]] bool is_share() const { return unit.empty() && !is_count; }
};

/// Maps whose values in a cell are computed together.
struct MapGroup {
  std::vector<MapKind> kinds;
  /// Writes one value for each kind; NaN: none.
  std::function<void(const MapCellTallies& cell, std::span<double> values)> values;
  bool needs_ensembles = false;
};

/// Which maps to make.
struct MapSelection {
  MapSubjects subjects = all_map_subjects;
  std::vector<double> percentiles{};  // in [0, 100], for the quantities among the subjects
  MapSubjects bands{};                // the subjects whose range between ensembles is mapped, too
  bool means = true;                  // of the quantities among the subjects
};

/// The quantities that have to be gathered for them, of all rocks and of each ensemble.
[[nodiscard]] MapContents contents_of(const MapSelection& selection);
[[nodiscard]] MapContents contents_of_ensembles(const MapSelection& selection);

/// Groups without a map are left out. Those of a range between ensembles follow those of the same subject.
[[nodiscard]] std::vector<MapGroup> map_groups(const MapSelection& selection);

/// One for each subject, with … in the name for max, mean or a percentile; and those of ranges between ensembles.
[[nodiscard]] std::vector<MapKind> map_families();

/// How the page shows a subject along a section.
struct SectionFigure {
  std::string_view name;  // of the subject
  std::string_view title, unit{};
  double per = 1;  // the unit, in that of envelopes.csv
};
/// One for each subject: quantities, shares, counts.
[[nodiscard]] std::vector<SectionFigure> section_figures();

/// All of them, in their order.
[[nodiscard]] std::vector<MapKind> map_kinds(const MapSelection& selection);

}  // namespace talus
