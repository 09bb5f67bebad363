#pragma once
// A digital elevation model as a regular grid of points, from a file or a formula.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace talus {

/// The nodes are the centres of the file's cells, north up. A node without data is NaN.
struct RasterGrid {
  std::uint32_t columns = 0, rows = 0;  // of nodes
  double x0 = 0, y0 = 0;                // of the south-west node [m]
  double dx = 1, dy = 1;                // between nodes, positive [m]
  std::vector<float> z;                 // elevations [m], row by row from the south, from west to east

  [[nodiscard]] std::size_t index(std::uint32_t column, std::uint32_t row) const {
    return static_cast<std::size_t>(row) * columns + column;
  }
};

/// The ratio of heights over facets to distances from them, at most: that of a facet whose slopes along x and along y
/// are the steepest between neighbouring nodes.
[[nodiscard]] inline double steepest_slant(const RasterGrid& grid) {
  float along_x = 0, along_y = 0;
  for (std::size_t row = 0; row < grid.rows; ++row) {
    const float* const z = grid.z.data() + row * grid.columns;
    for (std::size_t i = 0; i + 1 < grid.columns; ++i) along_x = std::max(along_x, std::abs(z[i + 1] - z[i]));
    if (row + 1 == grid.rows) continue;
    for (std::size_t i = 0; i < grid.columns; ++i) along_y = std::max(along_y, std::abs(z[i + grid.columns] - z[i]));
  }
  return std::hypot(1, along_x / grid.dx, along_y / grid.dy);
}

}  // namespace talus
