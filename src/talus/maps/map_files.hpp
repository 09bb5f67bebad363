#pragma once
// Maps as cloud-optimised GeoTIFFs, each with a style for QGIS.

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "talus/maps/map_list.hpp"
#include "talus/results/maps.hpp"

namespace talus {

/// Whether a run may have written a map or style with this file name.
[[nodiscard]] bool is_name_of_map_file(const std::filesystem::path& name);

/// Whether this program was built with GDAL, which writes the files.
[[nodiscard]] bool can_write_maps();

/// Removes the maps of an earlier run from a folder, so that none is mistaken for one of this run. Other files stay.
void remove_maps(const std::filesystem::path& folder);

/// Writes FOLDER/NAME.tif and FOLDER/NAME.qml for each map of the selection, over the cells that rocks touched. The
/// maps must have the contents of the selection, and ensembles if it has bands; docs/outputs.md lists the names.
/// `crs_wkt` is the coordinate system of the user coordinates, empty if unknown. Files appear when they are complete.
/// Nothing is written without a rock. Throws BadInput if the folder is not writable, or if the program was built
/// without GDAL.
///
/// Returns the names of the maps.
std::vector<std::string> write_maps(const MapsOfRun& maps, const MapSelection& selection, const std::string& crs_wkt,
                                    const std::filesystem::path& folder);

/// A map in memory.
struct MapPicture {
  int columns = 0, rows = 0;
  std::array<double, 2> corner{}, cell{};  // the north-western corner, and the size of a cell [m]
  std::vector<double> values;              // row by row from the north; NaN: no rock
};

/// Writes one map to a file of any name, and its style beside it, as write_maps() does. Throws BadInput.
void write_map(const MapKind& kind, const MapPicture& picture, const std::string& crs_wkt,
               const std::filesystem::path& file);

}  // namespace talus
