#pragma once
// End points, paths, releases and barriers of a run as one GeoPackage, for geographic information systems.

#include <filesystem>

#include "talus/archive/run_facts.hpp"

namespace talus {

inline constexpr const char* geopackage_name = "results.gpkg";

/// How far the lines of paths may depart from the arcs of flights [m].
inline constexpr double geopackage_tolerance_m = 0.25;

/// Whether this program was built with GDAL, which writes the file.
[[nodiscard]] bool can_write_geopackage();

/// Makes FOLDER/results.gpkg of FOLDER/endpoints.csv, FOLDER/paths.csv and the facts of its summary.json: the layers
/// `endpoints`, `paths`, `releases` (where paths begin) and `barriers`, whose columns docs/outputs.md lists. It
/// holds the ends of `facts.geopackage_rocks` of the rocks in the one table, and the paths of as many of those in the
/// other, evenly chosen.
/// Tables are streamed, one path at a time is in memory. The file appears when it is whole, and its bytes
/// depend on the tables alone. Throws BadInput where the tables are not what they should be, where the file cannot be
/// written, and where the program was built without GDAL.
void write_geopackage(const RunFacts& facts, const std::filesystem::path& folder);

}  // namespace talus
