#pragma once
// Smaller copies of a map for small scales. For files that are built with GDAL only.

#include <gdal_priv.h>

#include "talus/maps/map_list.hpp"

namespace talus {

/// Whether a map has overviews: above 2,048 cells a side.
[[nodiscard]] bool wants_overviews(int columns, int rows);

/// Adds overviews to a GeoTIFF that is being made, each half as wide and high as the one before, until both sides have
/// 256 cells or fewer. An overview cell has the maximum or the mean of those of its four cells that have data; at the
/// eastern and southern edge it may have only two or one. Parts without data take neither time nor space.
///
/// GDAL 3.6 builds overviews itself, but not of maxima (its list ends at RMS).
///
/// Returns false if GDAL failed; it has reported why.
[[nodiscard]] bool build_overviews(GDALDataset& raster, MapOverview what);

}  // namespace talus
