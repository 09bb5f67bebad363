#pragma once
// The slope of a grid cell, as GIS programs compute it.

#include <array>
#include <cmath>

namespace talus {

/// The square of the tangent of a cell's slope, from the elevations [m] of the cell and its eight neighbours, row by
/// row from the south-west, dx and dy apart [m]: the weighted differences of Horn, "Hill shading and the reflectance
/// map", Proceedings of the IEEE 69 (1981), 14-47, which gdaldem and QGIS use. Exact on a plane; the error on a curved
/// surface is of second order in the spacing. NaN if one of the cells has no data.
[[nodiscard]] inline double horn_gradient_squared(const std::array<double, 9>& z, double dx, double dy) {
  const double east = z[2] + 2 * z[5] + z[8], west = z[0] + 2 * z[3] + z[6];
  const double north = z[6] + 2 * z[7] + z[8], south = z[0] + 2 * z[1] + z[2];
  const double along_x = (east - west) / (8 * dx), along_y = (north - south) / (8 * dy);
  return along_x * along_x + along_y * along_y + 0 * z[4];
}

/// The slope [rad], 0 to pi / 2.
[[nodiscard]] inline double slope_of_gradient_squared(double gradient_squared) {
  return std::atan(std::sqrt(gradient_squared));
}

}  // namespace talus
