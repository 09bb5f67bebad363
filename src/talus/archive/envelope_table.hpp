#pragma once
// envelopes.csv: what maps show on plan, along a section.

#include <filesystem>
#include <string>

#include "talus/maps/map_list.hpp"
#include "talus/results/maps.hpp"

namespace talus::io {

inline constexpr const char* envelopes_name = "envelopes.csv";

/// A row for each cell of a grid along x, from the first to the last that rocks touched: the x of its middle in the
/// user's coordinates, then the maps of the selection. A cell that no rock touched has counts of 0 and nothing else.
/// Without heights those of bounces are left out. Expects maps of a section, in one row.
[[nodiscard]] std::string envelope_table(const Maps& maps, const MapSelection& selection, bool has_heights);

/// Writes it into a run's folder; throws BadInput where it cannot be written.
void write_envelopes(const std::filesystem::path& folder, const Maps& maps, const MapSelection& selection,
                     bool has_heights);
void remove_envelopes(const std::filesystem::path& folder);

}  // namespace talus::io
