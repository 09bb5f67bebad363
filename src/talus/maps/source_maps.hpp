#pragma once
// Maps of the rocks of each source, in a folder of its own.

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "talus/files/csv_table.hpp"
#include "talus/maps/map_list.hpp"
#include "talus/results/maps.hpp"

namespace talus {

/// A row of sources.csv, next to the folders of all sources: whose maps are in a folder.
struct SourceRow {
  static constexpr const char* file_name = "sources.csv";

  std::string folder{}, source{};
  std::uint64_t rocks = 0;

  static constexpr auto columns() {
    using R = SourceRow;
    return std::tuple(word("folder", "name of the folder", &R::folder),
                      word("source", "name of the source", &R::source), quantity("rocks", "", "its rocks", &R::rocks));
  }
};

/// A folder's name for each name of a list. Letters of any script, digits, spaces and most signs stay; what some system
/// does not take in a name (/ \ : * ? " < > | and control characters) becomes _, as do dots and spaces at either end,
/// where they are cut off. A name is at most 100 bytes long, is not a device of Windows, and no two differ in capitals
/// only: later ones have -2, -3 ... behind them.
[[nodiscard]] std::vector<std::string> folder_names(std::span<const std::string> names);

/// Writes FOLDER/NAME of source/ with the maps of map_files.hpp for each source that has rocks, and FOLDER/sources.csv.
/// `maps` and `sources` go together. Throws BadInput
/// as write_maps() does.
void write_source_maps(std::span<const Maps> maps, std::span<const std::string> sources, const MapSelection& selection,
                       const std::string& crs_wkt, const std::filesystem::path& folder);

/// Removes what write_source_maps() wrote there, and folders that are then empty. Other files stay.
void remove_source_maps(const std::filesystem::path& folder);

}  // namespace talus
