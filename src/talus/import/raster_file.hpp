#pragma once
// Terrain from raster files: band 1 of a GeoTIFF, Esri grid, VRT mosaic ... (gdal/gdal_start.cpp lists the formats).

#include <cstdint>
#include <filesystem>
#include <string>

#include "talus/core/problems.hpp"
#include "talus/import/survey_crs.hpp"
#include "talus/terrain/raster_grid.hpp"

namespace talus {

/// A raster has fewer nodes than this: facets are counted with 32 bits, two a cell.
inline constexpr std::uint64_t most_raster_nodes = std::uint64_t{1} << 31U;

/// Elevations outside of these are not ground of the earth, but no-data values that the file does not declare. Mines
/// count from as much as 10000 m below sea level, to have no negative numbers.
inline constexpr double lowest_elevation_m = -9000;
inline constexpr double highest_elevation_m = 100000;

struct RasterFile {
  RasterGrid grid;                 // in the file's coordinates [m]; its nodes are the centres of the file's cells
  std::string crs_wkt;             // the coordinate system as WKT 2; empty where nobody names one
  std::string crs_name;            // for people, for example "EPSG:31287"; empty where nobody names one
  std::uint64_t without_data = 0;  // nodes
};

/// Whether this program was built with GDAL, which reads the files.
[[nodiscard]] bool can_read_rasters();

/// Reads a raster of elevations. The band's scale and offset are applied; what the file or its mask declares to be no
/// data, and what is not a finite number, becomes NaN. Grids stored from the south or from the east are turned.
///
/// Elevations become 32-bit floats: exact to 0.03 mm below 1000 m and to 0.25 mm below 8192 m (half the spacing of
/// floats there); 16-bit integers are exact. Plan coordinates keep their 64 bits.
///
/// Throws BadInput with all that is wrong: no file, no raster or one cut short, a plan that is not in metres, turned,
/// or of unknown place, heights that are not in metres, or none, too few cells or too many. Each says how to fix it.
/// `said` holds where the file names no coordinate system; where it names another there is a refusal.
/// What is only doubtful is added to `warnings`.
[[nodiscard]] RasterFile read_raster_file(const std::filesystem::path& path, Problems& warnings,
                                          const ProjectCrs& said = {});

}  // namespace talus
