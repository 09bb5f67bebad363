#pragma once
// The files that GDAL reads for one that is named.

#include <filesystem>
#include <vector>

namespace talus {

/// A raster or Shapefile with the files that belong to it: positions, coordinate systems, attributes; of a VRT its
/// sources, too. Other files, and all files without GDAL or of a name that GDAL cannot open: the file alone. Files in
/// an archive: the archive. A folder: the ordinary files in it, by name.
[[nodiscard]] std::vector<std::filesystem::path> files_read_with(const std::filesystem::path& file);

}  // namespace talus
