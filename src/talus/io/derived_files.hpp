#pragma once
// Files that repeat the tables of a finished run in the formats of other programs.

#include <filesystem>

namespace talus::io {

/// Makes results.gpkg (vector_out.hpp) and paths.vtp (vtk_paths.hpp) in the folder of a run, as the project in its
/// summary.json asks, and removes those that an earlier run left there. To be called when the tables and summary.json
/// are whole, of one run or of merged shards. A program built without GDAL makes no GeoPackage. Throws BadInput.
void write_derived_files(const std::filesystem::path& folder);

}  // namespace talus::io
