#pragma once
// Polygons on plan, with holes: what lies within, for points and for the cells of grids.
//
// A place is within where a line to its west crosses the border an odd number of times (even-odd rule, half-open: the
// western and southern borders belong to a polygon, the eastern and northern ones do not). Where a border lies is
// computed alike for the polygons on both sides of it, so that no place between two neighbours is lost or counted
// twice.

#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "talus/core/vec.hpp"

namespace talus {

class PlanPolygon {
 public:
  /// An outer ring and its holes; a ring does not repeat its first vertex. Only x and y count.
  explicit PlanPolygon(std::span<const std::vector<Vec3>> rings);

  [[nodiscard]] const Vec2& low() const { return low_; }
  [[nodiscard]] const Vec2& high() const { return high_; }
  [[nodiscard]] bool contains(const Vec2& place) const;
  /// Where the border crosses a line along x, ascending, an even number of times: within is from the first to before
  /// the second, from the third to before the fourth and so on. Replaces what `x` held.
  void crossings(double y, std::vector<double>& x) const;

 private:
  struct Edge {
    Vec2 from, to;  // upwards
  };
  [[nodiscard]] std::size_t band_of(double y) const;

  std::vector<Edge> edges_;
  // Edges by bands of equal height: those of band b stand in entries_ from first_[b] to first_[b + 1].
  std::vector<std::uint32_t> entries_, first_;
  double bands_per_metre_ = 0;
  Vec2 low_, high_;
};

/// Points of a regular grid, for example the middles of a raster's cells.
struct PlanGrid {
  Vec2 first;             // the south-western point [m]
  double dx = 1, dy = 1;  // between points, positive [m]
  std::uint32_t columns = 0, rows = 0;

  [[nodiscard]] double x(std::uint32_t column) const { return first.x() + column * dx; }
  [[nodiscard]] double y(std::uint32_t row) const { return first.y() + row * dy; }
};

/// Calls visit(row, first column, column after the last) for each run of points of a grid within a polygon, from south
/// to north.
template <class Visit>
void visit_points_within(const PlanPolygon& polygon, const PlanGrid& grid, Visit&& visit) {
  // The first number n from 0 to count whose place first + n step is at or beyond `limit`.
  const auto first_at = [](double first, double step, std::uint32_t count, double limit) {
    const double guess = std::ceil((limit - first) / step);
    std::uint32_t n = guess <= 0 ? 0 : guess >= count ? count : static_cast<std::uint32_t>(guess);
    while (n > 0 && first + (n - 1) * step >= limit) --n;
    while (n < count && first + n * step < limit) ++n;
    return n;
  };
  std::vector<double> x;
  for (std::uint32_t row = first_at(grid.first.y(), grid.dy, grid.rows, polygon.low().y());
       row < grid.rows && grid.y(row) < polygon.high().y(); ++row) {
    polygon.crossings(grid.y(row), x);
    for (std::size_t k = 0; k + 1 < x.size(); k += 2) {
      const std::uint32_t from = first_at(grid.first.x(), grid.dx, grid.columns, x[k]);
      const std::uint32_t to = first_at(grid.first.x(), grid.dx, grid.columns, x[k + 1]);
      if (from < to) visit(row, from, to);
    }
  }
}

/// Where a ring crosses or touches itself, if it does; in time that grows with the square of its vertices. Rings of
/// polygons from files have been judged before.
[[nodiscard]] std::optional<Vec2> self_crossing(std::span<const Vec2> ring);

/// The same of a line, whose ends may not touch it either. A line that goes one way along x costs time in proportion to
/// its vertices.
[[nodiscard]] std::optional<Vec2> line_crossing(std::span<const Vec2> line);

}  // namespace talus
