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

/// A row of sources.csv, next to the folders of all sources: the source of each folder.
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

/// A folder name for each of the names. Letters of any script, digits, spaces and most signs stay. Characters that a
/// system does not allow in names (/ \ : * ? " < > | and control characters) become _; dots and spaces at either end
/// are cut off. A name has at most 100 bytes and is not a device of Windows. No two differ in case only: later ones get
/// -2, -3 ... appended.
[[nodiscard]] std::vector<std::string> folder_names(std::span<const std::string> names);

/// Writes FOLDER/NAME of source/ with the maps of map_files.hpp for each source that has rocks, and FOLDER/sources.csv.
/// `maps` and `sources` correspond. Throws BadInput as write_maps() does.
void write_source_maps(std::span<const Maps> maps, std::span<const std::string> sources, const MapSelection& selection,
                       const std::string& crs_wkt, const std::filesystem::path& folder);

/// Removes the files of write_source_maps() and folders that are then empty. Other files stay.
void remove_source_maps(const std::filesystem::path& folder);

}  // namespace talus
