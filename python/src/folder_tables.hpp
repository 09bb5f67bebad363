#pragma once
// The tables and maps of a run's folder in memory. All throw BadInput if a file is missing or damaged.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "map_array.hpp"
#include "row_keeper.hpp"
#include "talus/archive/envelope_table.hpp"

namespace talus::python {

template <TableRow Row>
[[nodiscard]] PackedRows rows_of_folder(const std::filesystem::path& folder);

[[nodiscard]] PackedRows packed(const EnvelopeTable& table);
[[nodiscard]] PackedRows envelopes_of_folder(const std::filesystem::path& folder);

/// The names of the maps.
[[nodiscard]] std::vector<std::string> maps_of_folder(const std::filesystem::path& folder);
/// Nullopt: there is no map of this name.
[[nodiscard]] std::optional<MapArray> read_map_of_folder(const std::filesystem::path& folder, const std::string& name);

}  // namespace talus::python
