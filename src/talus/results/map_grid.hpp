#pragma once
// A regular grid on plan, and the traversal of its cells by a rock's trajectory.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "talus/terrain/local_frame.hpp"
#include "talus/trajectory/rock_log.hpp"

namespace talus {

/// A cell: it contains the points from its lower borders up to, but not including, its upper ones.
struct MapCell {
  std::int32_t column = 0, row = 0;  // along x and y from the grid's origin; may be negative
  friend bool operator==(const MapCell&, const MapCell&) = default;
};

/// Cells of one size. Borders are at origin + k cell in user coordinates; queries are in local coordinates.
class MapGrid {
 public:
  /// Cell numbers have 32 bits: places further than this from cell (0, 0) are clamped.
  static constexpr double most_cells_across = 2e9;
  /// `origin` is a corner of cell (0, 0) in user coordinates [m]; `cell` has the lengths of its sides [m], above 0.
  MapGrid(const Vec2& origin, const Vec2& cell, const LocalFrame& frame)
      : origin_(origin), local_(origin - frame.origin.xy()), cell_(cell) {}
  MapGrid(const Vec2& origin, double cell, const LocalFrame& frame) : MapGrid(origin, Vec2(cell, cell), frame) {}
  /// A grid with borders at multiples of the cell's size in user coordinates, so that the maps of different runs match;
  /// cell (0, 0) contains the local point `low`.
  [[nodiscard]] static MapGrid at_multiples(double cell, const LocalFrame& frame, const Vec2& low) {
    const Vec2 global = low + frame.origin.xy();
    return {Vec2(std::floor(global.x() / cell) * cell, std::floor(global.y() / cell) * cell), cell, frame};
  }
  /// The cells of a raster, whose node with the lowest coordinates is at the local point `node`. A node is the centre
  /// of a cell, as GDAL defines the pixels of an elevation raster.
  [[nodiscard]] static MapGrid around_nodes(const Vec2& node, const Vec2& spacing, const LocalFrame& frame) {
    return {node + frame.origin.xy() - 0.5 * spacing, spacing, frame};
  }

  [[nodiscard]] const Vec2& origin() const { return origin_; }
  /// The lengths of a cell's sides along x and y [m].
  [[nodiscard]] const Vec2& cell() const { return cell_; }
  /// The local coordinate, x for axis 0 and y for axis 1, of the lower border of a column or row.
  [[nodiscard]] double border(std::size_t axis, std::int32_t k) const { return local_[axis] + k * cell_[axis]; }
  /// The column or row that contains a local coordinate.
  [[nodiscard]] std::int32_t index(std::size_t axis, double local) const {
    const double k = std::floor((local - local_[axis]) / cell_[axis]);
    // In this order a NaN becomes the lower limit.
    return static_cast<std::int32_t>(k > -most_cells_across ? std::min(k, most_cells_across) : -most_cells_across);
  }
  /// The borders of a cell in local coordinates.
  struct Borders {
    double west, east, south, north;
    [[nodiscard]] bool hold(double x, double y) const { return x >= west && x < east && y >= south && y < north; }
  };
  [[nodiscard]] Borders borders(MapCell cell) const {
    return {border(0, cell.column), border(0, cell.column + 1), border(1, cell.row), border(1, cell.row + 1)};
  }
  /// Whether a cell contains a local point.
  [[nodiscard]] bool holds(MapCell cell, const Vec3& local) const { return borders(cell).hold(local.x(), local.y()); }
  [[nodiscard]] MapCell cell_at(const Vec3& local) const { return {index(0, local.x()), index(1, local.y())}; }

  friend bool operator==(const MapGrid& a, const MapGrid& b) { return a.origin_ == b.origin_ && a.cell_ == b.cell_; }

 private:
  Vec2 origin_, local_, cell_;
};

namespace map_walk {

/// One coordinate of a trajectory, over a time in which it is monotone.
struct Monotone {
  double p, v, a;       // p + v t + a t^2 / 2
  std::int32_t toward;  // 1 ascending, -1 descending, 0 constant

  /// When it reaches `border`, which is ahead. The time may be outside the monotone interval, because of rounding or
  /// because the interval ends first.
  [[nodiscard]] double time_at(double border) const {
    const double way = border - p;
    if (a == 0) return way / v;
    const double squared = v * v + 2 * a * way;
    if (squared < 0) return std::numeric_limits<double>::infinity();  // it turns around before
    const double speed = toward * std::sqrt(squared);                 // at the border
    return toward * v > 0 ? 2 * way / (v + speed) : (speed - v) / a;  // the root without cancellation
  }
};

}  // namespace map_walk

/// Distances shorter than this [m] are rounding: a rock with such a stay was not in the cell.
inline constexpr double no_way = 1e-9;

/// Calls visit(cell, enter, leave) for each cell that a piece crosses, in the order of the trajectory: its centre is
/// over the cell from `enter` to `leave`, in the piece's time [s]. The intervals join, from 0 to the piece's duration.
/// A cell that the trajectory only touches, at a corner or where it begins or ends, is not visited, unless the piece
/// goes nowhere.
template <class Visit>
void walk(const MapGrid& grid, const PathPiece& piece, Visit&& visit) {
  const Parabola& path = piece.path;
  // On plan a coordinate turns around at most once: between these times both are monotone.
  std::array<double, 4> part{0, piece.duration, piece.duration, piece.duration};
  std::size_t parts = 1;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (path.a[axis] == 0) continue;
    const double turn = -path.v[axis] / path.a[axis];
    if (turn > 0 && turn < piece.duration) part[parts++] = turn;
  }
  if (parts == 3 && part[2] < part[1]) std::swap(part[1], part[2]);

  const MapCell first = grid.cell_at(path.p);
  std::array<std::int32_t, 2> cell{first.column, first.row};
  double since = 0;
  for (std::size_t k = 0; k < parts; ++k) {
    const double end = part[k + 1];
    const Vec3 middle = path.velocity(0.5 * (part[k] + end));
    const double moment =
        no_way / std::max(std::abs(middle.x()), std::abs(middle.y()));  // infinite if it does not move
    const double last = k + 1 == parts ? end - moment : end;
    std::array<map_walk::Monotone, 2> way;
    std::array<double, 2> next;  // when each coordinate leaves the cell
    const auto look_ahead = [&](std::size_t axis) {
      const std::int32_t toward = way[axis].toward;
      next[axis] = toward == 0 ? std::numeric_limits<double>::infinity()
                               : std::max(since, way[axis].time_at(grid.border(axis, cell[axis] + (toward > 0))));
    };
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const double v = middle[axis];
      way[axis] = {path.p[axis], path.v[axis], path.a[axis], v > 0 ? 1 : v < 0 ? -1 : 0};
      look_ahead(axis);
    }
    while (std::min(next[0], next[1]) < last) {
      const double t = std::min(next[0], next[1]);
      if (t - since > moment) {
        visit(MapCell{cell[0], cell[1]}, since, t);
        since = t;
      }
      for (std::size_t axis = 0; axis < 2; ++axis) {
        if (next[axis] > t) continue;
        cell[axis] += way[axis].toward;
        look_ahead(axis);
      }
    }
  }
  visit(MapCell{cell[0], cell[1]}, since, piece.duration);
}

}  // namespace talus
