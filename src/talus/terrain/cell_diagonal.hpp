#pragma once
// Which diagonal of four neighbouring nodes is an edge of the surface: the one along which the ground bends less.
//
// Both diagonals are straight lines over the middle of the cell, one above the other. Which of them the ground follows
// is not in the four nodes: the same four are a gully along the lower diagonal, or a ridge along the upper one. The
// nodes beside the cell decide. Where the ground around is hollow, it passes below the mean of the four nodes, and the
// lower diagonal is the edge, so that no gully is dammed; where it bulges, the upper one, so that no ridge is notched.
//
// With second derivatives f_uu, f_vv and f_uv in units of cells, the ground bends by f_uu + f_vv + 2 f_uv along one
// diagonal and by f_uu + f_vv - 2 f_uv along the other. The first is the lesser in magnitude if (f_uu + f_vv) f_uv < 0.
// Neither a plane that is added to the ground, nor a mirror, nor a quarter turn changes that. To choose the edges by
// the heights is due to N. Dyn, D. Levin and S. Rippa, "Data dependent triangulations for piecewise linear
// interpolation", IMA Journal of Numerical Analysis 10 (1990) 137-154; here every cell decides alone, from its
// neighbours' nodes.

#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>

namespace talus {

/// The heights [m] of four nodes, on a grid or on four corners of a square.
struct CellNodes {
  double sw, se, nw, ne;
};

/// The bend of the ground between the middle two of four nodes in a row, positive in a hollow: twice the second
/// difference. An outer node that is missing (NaN) adds nothing: then it is that of the other three, or 0.
[[nodiscard]] inline double bend_along(double before, double first, double second, double after) {
  if (const double bend = before + after - (first + second); !std::isnan(bend)) return bend;
  if (!std::isnan(before)) return 2 * (before - first - (first - second));
  return std::isnan(after) ? 0 : 2 * (after - second - (second - first));
}

/// Whether the diagonal from south-west to north-east is the edge, in ground with this sum of bends along the cell's
/// four sides. Without a bend, the lower one; if both are level with each other, the cell is plane.
[[nodiscard]] inline bool is_edge_north_east(const CellNodes& z, double bend) {
  const double twist = z.sw + z.ne - (z.se + z.nw);
  return (bend < 0 ? -twist : twist) <= 0;
}

/// The same from the nodes in and beside a cell: z(i, j) is the height [m] of the node i columns east and j rows north
/// of the south-west node, NaN if it is missing; i and j are -1 to 2.
template <std::invocable<int, int> Height>
[[nodiscard]] bool is_edge_north_east(Height&& z) {
  const CellNodes cell{z(0, 0), z(1, 0), z(0, 1), z(1, 1)};
  return is_edge_north_east(
      cell, bend_along(z(-1, 0), cell.sw, cell.se, z(2, 0)) + bend_along(z(-1, 1), cell.nw, cell.ne, z(2, 1)) +
                (bend_along(z(0, -1), cell.sw, cell.nw, z(0, 2)) + bend_along(z(1, -1), cell.se, cell.ne, z(1, 2))));
}

/// The same for a cell of a grid of `columns` x `rows` nodes; z(column, row) is the height of a node [m].
template <std::invocable<std::uint32_t, std::uint32_t> Height>
[[nodiscard]] bool is_edge_north_east(Height&& z, std::uint32_t columns, std::uint32_t rows, std::uint32_t column,
                                      std::uint32_t row) {
  return is_edge_north_east([&](int i, int j) {
    const std::int64_t at_column = std::int64_t{column} + i, at_row = std::int64_t{row} + j;
    const bool is_there = at_column >= 0 && at_row >= 0 && at_column < columns && at_row < rows;
    return is_there ? double{z(static_cast<std::uint32_t>(at_column), static_cast<std::uint32_t>(at_row))}
                    : std::numeric_limits<double>::quiet_NaN();
  });
}

}  // namespace talus
