#pragma once
// Maps as cloud-optimised GeoTIFFs, each with a style for QGIS beside it.

#include <filesystem>
#include <string>
#include <vector>

#include "talus/maps/map_list.hpp"
#include "talus/results/maps.hpp"

namespace talus {

/// Whether a run may have written a file of this name among its maps: a map, or the style beside it.
[[nodiscard]] bool is_name_of_map_file(const std::filesystem::path& name);

/// Whether this program was built with GDAL, which writes the files.
[[nodiscard]] bool can_write_maps();

/// Removes the maps that an earlier run left in a folder, so that none is taken for one of this run. Other files stay.
void remove_maps(const std::filesystem::path& folder);

/// Writes FOLDER/NAME.tif and FOLDER/NAME.qml for each map of the selection, of which the maps must hold the contents,
/// all over the cells that rocks touched; docs/outputs.md lists the names. `crs_wkt` is the coordinate system of the
/// user's coordinates, empty where it is not known. Files appear when they are whole. Without a rock nothing is
/// written. Throws BadInput where the folder cannot be written to, and where the program was built without GDAL.
///
/// Returns the names of the maps.
std::vector<std::string> write_maps(const Maps& maps, const MapSelection& selection, const std::string& crs_wkt,
                                    const std::filesystem::path& folder);

}  // namespace talus
