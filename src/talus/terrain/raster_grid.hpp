#pragma once
// A digital elevation model as a regular grid of points, from a file or a formula.

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

}  // namespace talus
