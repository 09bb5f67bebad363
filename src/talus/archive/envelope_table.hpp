#pragma once
// envelopes.csv: the quantities of maps along a section.

#include <filesystem>
#include <string>
#include <tuple>
#include <vector>

#include "talus/files/csv_table.hpp"
#include "talus/maps/map_list.hpp"
#include "talus/results/maps.hpp"

namespace talus {

/// A row of envelopes.csv: a cell of a grid along x.
struct EnvelopeRow {
  static constexpr const char* file_name = "envelopes.csv";

  double x_m = 0;
  FamilyValues values{};  // of the chosen maps

  static constexpr auto columns() {
    using R = EnvelopeRow;
    return std::tuple(quantity("x_m", "m", "middle of the cell", &R::x_m), family(&R::values));
  }
  [[nodiscard]] static std::vector<ColumnText> family_texts();
};

struct EnvelopeTable {
  std::vector<std::string> names;  // of the values
  std::vector<EnvelopeRow> rows;
};

/// A row for each cell from the first to the last that rocks touched. A cell that no rock touched has counts of 0, and
/// its other values are empty. Without `has_heights` there are no bounce heights. Throws std::logic_error
/// unless the maps are in one row, as those of a section are.
[[nodiscard]] EnvelopeTable envelopes_of(const MapsOfRun& maps, const MapSelection& selection, bool has_heights);
/// The same as text.
[[nodiscard]] std::string envelope_table(const MapsOfRun& maps, const MapSelection& selection, bool has_heights);

/// Writes the table into a run's folder; throws BadInput if that fails.
void write_envelopes(const std::filesystem::path& folder, const MapsOfRun& maps, const MapSelection& selection,
                     bool has_heights);
void remove_envelopes(const std::filesystem::path& folder);

}  // namespace talus
