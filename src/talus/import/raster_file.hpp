#pragma once
// Terrain from raster files: band 1 of a GeoTIFF, Esri grid or VRT mosaic (gdal/gdal_start.cpp lists the formats).

#include <cstdint>
#include <filesystem>
#include <string>

#include "talus/core/problems.hpp"
#include "talus/import/survey_crs.hpp"
#include "talus/terrain/raster_grid.hpp"

namespace talus {

/// A raster must have fewer nodes than this: facets are numbered with 32 bits, and there are two per cell.
inline constexpr std::uint64_t most_raster_nodes = std::uint64_t{1} << 31U;

/// Elevations outside of these are not ground but no-data values that the file does not declare. The maximum allows for
/// mine datums as much as 10000 m below sea level, which avoid negative numbers.
inline constexpr double lowest_elevation_m = -9000;
inline constexpr double highest_elevation_m = 100000;

struct RasterFile {
  RasterGrid grid;                 // in the file's coordinates [m]; its nodes are the centres of the file's cells
  std::string crs_wkt;             // the coordinate system as WKT 2; empty if unknown
  std::string crs_name;            // for messages, for example "EPSG:31287", "local coordinates"; empty if unknown
  std::uint64_t without_data = 0;  // nodes
};

/// Whether this program was built with GDAL, which reading rasters needs.
[[nodiscard]] bool can_read_rasters();

/// Reads a raster of elevations. Applies the band's scale and offset. Cells that the file or its mask declares to be
/// without data, and values that are not finite, become NaN. Grids stored from the south or from the east are flipped.
///
/// Elevations become 32-bit floats: exact to 0.03 mm below 1000 m and to 0.25 mm below 8192 m (half the spacing of
/// floats there); 16-bit integers are exact. Plan coordinates keep their 64 bits.
///
/// Throws BadInput with all errors and how to fix each: no file, not a raster, or cut short; a plan that is not in
/// metres, rotated, or not georeferenced; heights that are missing or not in metres; too few or too many cells.
/// `project_crs` applies if the file has no coordinate system; if the file has a different one, it is refused. Doubts
/// are added to `warnings`.
[[nodiscard]] RasterFile read_raster_file(const std::filesystem::path& path, Problems& warnings,
                                          const ProjectCrs& project_crs = {});

}  // namespace talus
