#pragma once
// Files that repeat the tables of a finished run in the formats of other programs.

#include <filesystem>

namespace talus {

/// Makes results.gpkg (vector_out.hpp) and paths.vtp (vtk_paths.hpp) in a run's folder, as the project in its summary
/// asks, and removes those of an earlier run. Call it when the tables and the summary are complete, of one run or of
/// merged shards; the summary may still have another name. A program built without GDAL makes no GeoPackage. Throws
/// BadInput.
void write_derived_files(const std::filesystem::path& folder, const char* summary = "summary.json");

}  // namespace talus
