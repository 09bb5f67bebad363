#pragma once
// Rasters whose cells are finer than their data: interpolated from larger cells, or with elevations in coarse steps.

#include <optional>

#include "talus/core/vec.hpp"
#include "talus/terrain/raster_grid.hpp"

namespace talus::project {

/// The cells from which elevations were interpolated, on x and y [m]; nullopt if they seem not to be.
///
/// Interpolation leaves its traces at the borders of the original cells: steps (nearest neighbour), bends (bilinear),
/// or jumps of a higher derivative (cubic). The size of differences of the elevations along a row or a column therefore
/// has a period, of k cells, that neither measured nor smooth ground has: a peak in its spectrum at 1/k. Ratios of 1.9
/// to 16.5 are found, on both axes, as Popescu and Farid (2005, "Exposing digital forgeries by detecting traces of
/// resampling") and Mahdian and Saic (2008, "Blind authentication using periodic properties of interpolation") find
/// resampled images. A sample of a large raster is examined. Rasters with fewer than 44 nodes on a side are not.
[[nodiscard]] std::optional<Vec2> interpolated_from(const RasterGrid& grid);

/// The step of which all elevations are multiples, 0.1, 0.5, 1, 5 or 10 m, if bends of the ground by a single step are
/// frequent; otherwise nullopt. A sample of a large raster is examined.
[[nodiscard]] std::optional<double> elevation_step(const RasterGrid& grid);

}  // namespace talus::project
