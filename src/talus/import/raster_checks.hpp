#pragma once
// Checks of a raster of elevations before its cells are read: its size, position, band and unit of height. Only for
// files that are built with GDAL.

#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <optional>

#include "talus/gdal/gdal_raster.hpp"

namespace talus {

/// The position of a raster's cells on plan.
struct RasterPlacing {
  double west, south;          // outer corner [m]
  double dx, dy;               // of a cell, positive [m]
  bool from_east, from_south;  // the order of columns and rows in the file
};

/// nullopt, with an error in `problems`, if the raster is not georeferenced, or rotated or sheared.
[[nodiscard]] std::optional<RasterPlacing> placing_of(GDALDataset& dataset, RasterProblems& problems);

/// Refuses rasters that are too far from the origin or seem to be in degrees. `crs` is null if none is known;
/// `is_local`: whether the project declares metres that belong to no map.
void check_place(GDALDataset& dataset, const RasterPlacing& at, const OGRSpatialReference* crs, bool is_local,
                 RasterProblems& problems);

/// Refuses rasters with too few or too many cells, or too many for the memory of this machine.
void check_size(GDALDataset& dataset, RasterProblems& problems);

/// Refuses bands that contain no elevations: complex numbers, colours, a useless scale or offset.
void check_band(GDALRasterBand& band, RasterProblems& problems);

/// Refuses heights that are not metres upwards. `crs` is null if none is known.
void check_unit(GDALRasterBand& band, const OGRSpatialReference* crs, RasterProblems& problems);

}  // namespace talus
