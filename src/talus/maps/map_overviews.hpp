#pragma once
// Smaller copies of a map for looking at it from afar. For files that are built with GDAL only.

#include <gdal_priv.h>

#include "talus/maps/map_list.hpp"

namespace talus {

/// Gives a GeoTIFF that is being made overviews, each half as wide and high as the one before, until both sides have
/// 256 cells or fewer. A cell of an overview holds the greatest or the mean of those of its four cells that have data;
/// at the eastern and southern edge it may have but two or one. Parts without data take neither time nor room.
///
/// GDAL 3.6 builds overviews itself, but knows no greatest value (its list ends at RMS).
///
/// Gives false where GDAL could not; it has then said why.
[[nodiscard]] bool build_overviews(GDALDataset& raster, MapOverview what);

}  // namespace talus
