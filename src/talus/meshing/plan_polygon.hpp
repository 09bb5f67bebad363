#pragma once
// Polygons on plan, with holes: containment of points and of the cells of grids.
//
// A place is within if a line to its west crosses the border an odd number of times (even-odd rule, half-open: the
// western and southern borders belong to a polygon, the eastern and northern ones do not). A common border is computed
// identically for the polygons on both sides, so that no place between neighbours is lost or counted twice.

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "talus/core/vec.hpp"

namespace talus {

class PlanPolygon {
 public:
  /// An outer ring and its holes; a ring does not repeat its first vertex. Only x and y are used.
  explicit PlanPolygon(std::span<const std::vector<Vec3>> rings);

  [[nodiscard]] const Vec2& low() const { return low_; }
  [[nodiscard]] const Vec2& high() const { return high_; }
  [[nodiscard]] bool contains(const Vec2& place) const;
  /// Where the border crosses the line along x at `y`, ascending; an even number. The polygon is [x0, x1), [x2, x3) and
  /// so on. Replaces the contents of `x`.
  void crossings(double y, std::vector<double>& x) const;
  /// Calls visit(x) for each crossing, in any order.
  template <class Visit>
  void visit_crossings(double y, Visit&& visit) const {
    if (!(y >= low_.y() && y < high_.y())) return;
    const std::size_t band = band_of(y);
    for (std::uint32_t k = first_[band]; k < first_[band + 1]; ++k) {
      const Edge& edge = edges_[entries_[k]];
      if (y >= edge.from.y() && y < edge.to.y()) visit(edge.x(y));
    }
  }
  [[nodiscard]] std::size_t edge_count() const { return edges_.size(); }

 private:
  struct Edge {
    Edge(const Vec2& a, const Vec2& b) : from(a), to(b), slope((b.x() - a.x()) / (b.y() - a.y())) {}
    [[nodiscard]] double x(double y) const { return from.x() + (y - from.y()) * slope; }
    Vec2 from, to;  // from.y() < to.y()
    double slope;   // dx / dy
  };
  [[nodiscard]] std::size_t band_of(double y) const;

  std::vector<Edge> edges_;
  // Edges by bands of equal height: those of band b are entries_[first_[b]] to before entries_[first_[b + 1]].
  std::vector<std::uint32_t> entries_, first_;
  double bands_per_metre_ = 0;
  Vec2 low_, high_;
};

/// Points of a regular grid, for example the centres of a raster's cells.
struct PlanGrid {
  Vec2 first;             // the south-western point [m]
  double dx = 1, dy = 1;  // between points, positive [m]
  std::uint32_t columns = 0, rows = 0;

  [[nodiscard]] double x(std::uint32_t column) const { return first.x() + column * dx; }
  [[nodiscard]] double y(std::uint32_t row) const { return first.y() + row * dy; }
};

/// The points of a grid within a polygon, row by row.
class PointsWithin {
 public:
  PointsWithin(const PlanPolygon& polygon, const PlanGrid& grid) : polygon_(polygon), grid_(grid) {}

  /// Rows that the polygon may reach: [first, second).
  [[nodiscard]] std::pair<std::uint32_t, std::uint32_t> rows() const;
  /// Points of a row: columns [first, last).
  struct Run {
    std::uint32_t first, last;
  };
  /// The runs of one row, from west to east. Replaces the contents of `runs`. The time is proportional to the border's
  /// crossings of the row.
  void runs_in(std::uint32_t row, std::vector<Run>& runs) const;

 private:
  const PlanPolygon& polygon_;
  const PlanGrid& grid_;
};

/// The runs of several rows, of row first + k into runs[k]; on all cores if the work is worth it.
void runs_in_rows(const PointsWithin& points, std::uint32_t first, std::size_t work_a_row,
                  std::span<std::vector<PointsWithin::Run>> runs);

/// Calls visit(row, first column, column after the last) for each run of grid points within a polygon, from south to
/// north.
template <class Visit>
void visit_points_within(const PlanPolygon& polygon, const PlanGrid& grid, Visit&& visit) {
  const PointsWithin points(polygon, grid);
  const auto [first, last] = points.rows();
  constexpr std::uint32_t at_a_time = 256;
  std::vector<std::vector<PointsWithin::Run>> runs(std::min(at_a_time, last - first));
  for (std::uint32_t begin = first; begin < last; begin += at_a_time) {
    const std::size_t count = std::min(at_a_time, last - begin);
    runs_in_rows(points, begin, polygon.edge_count(), std::span(runs).first(count));
    for (std::size_t k = 0; k < count; ++k) {
      for (const PointsWithin::Run& run : runs[k]) visit(begin + static_cast<std::uint32_t>(k), run.first, run.last);
    }
  }
}

/// Where a ring crosses or touches itself, if it does. Quadratic in the vertices; rings of polygons from files have
/// been checked before.
[[nodiscard]] std::optional<Vec2> self_crossing(std::span<const Vec2> ring);

/// Where a line crosses or touches itself, its ends included. Linear in the vertices for a line that runs one way
/// along x.
[[nodiscard]] std::optional<Vec2> line_crossing(std::span<const Vec2> line);

}  // namespace talus
