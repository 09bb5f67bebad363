#pragma once
// End points, paths, releases and barriers of a run as a GeoPackage, for geographic information systems.

#include <filesystem>

#include "talus/archive/run_facts.hpp"

namespace talus {

inline constexpr const char* geopackage_name = "results.gpkg";

/// Largest distance between the lines of paths and the arcs of flights [m].
inline constexpr double geopackage_tolerance_m = 0.25;

/// Whether this program was built with GDAL, which writes the file.
[[nodiscard]] bool can_write_geopackage();

/// Makes FOLDER/results.gpkg from FOLDER/endpoints.csv, FOLDER/paths.csv and the facts of its summary.json: the layers
/// `endpoints`, `paths`, `releases` (where paths begin), `barriers` and `design` (geopackage_rows.hpp). It has the end
/// points of `facts.geopackage_rocks` of the rocks in the first table, and the paths of as many of those in the second,
/// evenly chosen. Tables are streamed: one path at a time is in memory. The file appears when it is complete, and its
/// bytes depend on the tables only. Throws BadInput if the tables are damaged, if the file cannot be written, or if the
/// program was built without GDAL.
void write_geopackage(const RunFacts& facts, const std::filesystem::path& folder);

}  // namespace talus
