#pragma once
// Files that repeat the tables of a finished run in the formats of other programs.

#include <filesystem>

namespace talus {

/// Makes results.gpkg (vector_out.hpp) and paths.vtp (vtk_paths.hpp) in the folder of a run, as the project in its
/// summary asks, and removes those that an earlier run left there. To be called when the tables and the summary are
/// whole, of one run or of merged shards; the latter may have another name yet. A program built without GDAL makes no
/// GeoPackage. Throws BadInput.
void write_derived_files(const std::filesystem::path& folder, const char* summary = "summary.json");

}  // namespace talus
