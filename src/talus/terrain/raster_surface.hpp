#pragma once
// A digital elevation model as a surface: two triangles between four neighbouring nodes, computed on demand and not
// stored. Coordinates are local on plan; elevations are those of the grid.
//
// Every cell is cut along the diagonal along which the ground around it bends less (cell_diagonal.hpp), so that gullies
// and ridges stay whole. The cuts are stored, a bit per cell. A cell with a node without data is a hole.

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "talus/rocks/ridge.hpp"
#include "talus/terrain/facet_contact.hpp"
#include "talus/terrain/flight_slabs.hpp"
#include "talus/terrain/grid_walk.hpp"
#include "talus/terrain/raster_grid.hpp"

namespace talus {

class RasterSurface {
 public:
  RasterSurface() = default;
  /// Expects at least 2 x 2 nodes, fewer than 2^31 cells, and some cell with data.
  explicit RasterSurface(RasterGrid grid);

  [[nodiscard]] const RasterGrid& grid() const { return grid_; }
  [[nodiscard]] std::size_t cell_count() const { return columns_ * rows_; }
  /// Cell c has the facets 2 c and 2 c + 1.
  [[nodiscard]] std::size_t facet_count() const { return 2 * cell_count(); }
  /// The cell, counted row by row from the south-west.
  [[nodiscard]] std::uint32_t source(FacetId facet) const { return facet.index / 2; }
  [[nodiscard]] const Box& bounds() const { return bounds_; }
  [[nodiscard]] static bool may_overhang() { return false; }
  [[nodiscard]] std::size_t bytes() const {
    return grid_.z.size() * sizeof(float) + cuts_.size() * sizeof(std::uint64_t);
  }
  /// Whether all four nodes have data.
  [[nodiscard]] bool has_data(std::size_t column, std::size_t row) const;
  /// Whether a cell with data is cut from south-west to north-east, not from south-east to north-west.
  [[nodiscard]] bool is_cut_north_east(std::size_t column, std::size_t row) const {
    return is_cut_north_east(node(column, row));
  }

  // The queries of TerrainSurface (surface.hpp), and those that a walk over the grid can answer at the same time.
  [[nodiscard]] std::optional<Contact> first_contact(const Parabola& path, double radius, double t_max,
                                                     const SupportPlanes& left = {}) const;
  /// The first contact; and if there is one, the maximum height [m] of the centre above the ground until then, or
  /// `known` if that is larger.
  struct Flight {
    std::optional<Contact> contact;
    double max_height;
  };
  [[nodiscard]] Flight flight(const Parabola& path, double radius, double t_max, const SupportPlanes& left,
                              double known) const {
    return radius > 0 ? flight_of_sphere(path, radius, t_max, left, known) : flight_of_point(path, t_max, left, known);
  }
  [[nodiscard]] std::optional<Contact> first_contact_on_leg(const Parabola& leg, double radius, double t_max,
                                                            const SupportPlanes& on) const;
  [[nodiscard]] Exit exit(const Parabola& path) const;
  [[nodiscard]] double max_height(const Parabola& path, double t_end, double known) const;
  /// The maximum height in each part of a flight between two of `borders`, in ascending order; 0 without ground below.
  void max_heights(const Parabola& path, std::span<const double> borders, std::span<double> heights) const;
  [[nodiscard]] std::optional<double> elevation(double x, double y,
                                                double below = std::numeric_limits<double>::infinity()) const;
  [[nodiscard]] bool has_ground_below(const Vec3& place, FacetId) const {
    return elevation(place.x(), place.y(), place.z()).has_value();
  }
  [[nodiscard]] std::optional<GroundBelow> ground_below(const Vec3& place) const;
  /// What is below a body: its low corners and the ridges near them (raster_under_body.hpp).
  class UnderBody;
  /// The ratio of heights over any facet to distances from it, at most.
  [[nodiscard]] double slant() const { return slant_; }
  [[nodiscard]] std::optional<double> ground_over(const Vec3& place) const;
  [[nodiscard]] std::vector<Vec3> draped(const Vec2& from, const Vec2& to) const;
  [[nodiscard]] Vec3 normal(FacetId facet) const { return area_normal(triangle(facet)).normalized(); }
  [[nodiscard]] Vec3 point_of(FacetId facet) const { return triangle(facet)[0]; }
  [[nodiscard]] Outline outline(FacetId facet) const;
  template <class Touch>
  void supports(const Vec3& centre, double radius, double reach, Touch&& touch) const;

  // Convex edges, and those where the surface ends (rocks/ridge.hpp).
  [[nodiscard]] Ridge ridge(FacetId facet, std::uint32_t side) const {
    const Triangle corner = triangle(facet);
    return {corner[side], corner[next_corner[side]], facet, side};
  }
  /// The far corners of the facets that meet at a ridge; the same twice where the surface ends.
  [[nodiscard]] std::array<Vec3, 2> beside(const Ridge& ridge) const;
  /// Calls visit(ridge) for each ridge that may reach into a box. Where the slope changes by less than `min_bend` is
  /// none.
  template <class Visit>
  void visit_ridges(const Vec3& low, const Vec3& high, double min_bend, Visit&& visit) const;

  [[nodiscard]] Triangle triangle(FacetId facet) const;

 private:
  // A plane, in units of cells on plan: its height is z where (u, v) = (corner, corner) in a cell.
  struct Plane {
    double z, along_u, along_v, corner = 0;
  };
  // A cell: the elevations of its nodes, and whether it is cut from south-west to north-east.
  struct Cell {
    double sw, se, nw, ne;
    bool is_cut_north_east;
    [[nodiscard]] bool has_data() const { return !std::isnan(sw + se + nw + ne); }
    /// The side of the diagonal on which a place is: positive to the south-east, or to the north-east, of it.
    [[nodiscard]] double side_of_diagonal(double u, double v) const { return is_cut_north_east ? u - v : u + v - 1; }
    /// The plane of a facet.
    [[nodiscard]] Plane plane(std::uint32_t half) const {
      const bool north_east = is_cut_north_east, is_by_sw = half == 0 || north_east;
      return {is_by_sw ? sw : ne, half == 0 ? se - sw : ne - nw, (half == 0) == north_east ? ne - se : nw - sw,
              is_by_sw ? 0.0 : 1.0};
    }
    /// The elevation at a place in the cell; u and v are 0 at its west and south sides, 1 at its east and north sides.
    [[nodiscard]] double ground(double u, double v) const {
      u = std::clamp(u, 0.0, 1.0);
      v = std::clamp(v, 0.0, 1.0);
      if (is_cut_north_east) {
        return u >= v ? sw + u * (se - sw) + v * (ne - se) : sw + v * (nw - sw) + u * (ne - nw);
      }
      return u + v <= 1 ? sw + u * (se - sw) + v * (nw - sw) : ne + (1 - u) * (nw - ne) + (1 - v) * (se - ne);
    }
    /// The same but for rounding, for u and v in [0, 1], without a branch.
    [[nodiscard]] double ground_within(double u, double v) const {
      const double bent = is_cut_north_east ? std::min(u, v) : std::max(u + v - 1, 0.0);
      return sw + u * (se - sw) + v * (nw - sw) + (sw + ne - (se + nw)) * bent;
    }
  };
  struct Cells {  // columns and rows from (first) to (last), both included; empty where first > last
    std::int64_t first_column, last_column, first_row, last_row;
  };

  /// The plane over so many cells, from a south-west node on, that has their mean slope and touches the highest of
  /// their nodes.
  [[nodiscard]] Plane plane_over(std::size_t south_west, std::size_t across, std::size_t along) const;
  [[nodiscard]] Cell cell(std::size_t column, std::size_t row) const { return cell_at(node(column, row)); }
  /// The number of a cell's south-west node, and the cell with that node.
  [[nodiscard]] std::size_t node(std::size_t column, std::size_t row) const { return row * (columns_ + 1) + column; }
  [[nodiscard]] Cell cell_at(std::size_t node) const {
    const float* south = grid_.z.data() + node;
    const float* north = south + columns_ + 1;
    return {south[0], south[1], north[0], north[1], is_cut_north_east(node)};
  }
  [[nodiscard]] bool is_cut_north_east(std::size_t node) const { return (cuts_[node / 64] >> (node % 64) & 1U) != 0; }
  void choose_cuts();
  /// The minimum and maximum elevation of a cell's nodes; if one has no data, NaN or those of the others.
  [[nodiscard]] std::pair<double, double> range_at(std::size_t node) const {
    const float* south = grid_.z.data() + node;
    const float* north = south + columns_ + 1;
    return {std::min(std::min(south[0], south[1]), std::min(north[0], north[1])),
            std::max(std::max(south[0], south[1]), std::max(north[0], north[1]))};
  }
  [[nodiscard]] GridWalk walk(const Parabola& path, double t_max) const {
    return {path,
            t_max,
            grid_.x0,
            grid_.y0,
            grid_.dx,
            grid_.dy,
            static_cast<std::int64_t>(columns_),
            static_cast<std::int64_t>(rows_)};
  }
  /// Column and row of a facet's cell. (A division of 32-bit numbers is several times as fast.)
  [[nodiscard]] std::pair<std::int64_t, std::int64_t> place(FacetId facet) const {
    const std::uint32_t c = source(facet), width = static_cast<std::uint32_t>(columns_);
    return {c % width, c / width};
  }
  [[nodiscard]] Cells cells_within(double x_low, double x_high, double y_low, double y_high) const;
  [[nodiscard]] std::uint32_t facet_of(std::int64_t column, std::int64_t row, std::uint32_t half) const {
    return static_cast<std::uint32_t>(
        2 * (static_cast<std::size_t>(row) * columns_ + static_cast<std::size_t>(column)) + half);
  }
  /// The kind of a facet, 0 to 3, by the cut of its cell and its half.
  [[nodiscard]] static std::size_t kind_of(const Cell& cell, std::uint32_t half) {
    return 2 * static_cast<std::size_t>(cell.is_cut_north_east) + half;
  }
  [[nodiscard]] Triangle triangle(std::int64_t column, std::int64_t row, std::size_t kind) const;
  [[nodiscard]] std::array<Triangle, 2> triangles(std::int64_t column, std::int64_t row, const Cell& cell) const;
  [[nodiscard]] std::array<std::optional<FacetId>, 3> neighbours(FacetId facet) const;
  class SpherePart;
  class SphereSides;
  class SphereSearch;
  [[nodiscard]] bool is_sharp_edge(FacetId facet, std::size_t side) const;
  [[nodiscard]] bool is_sharp_vertex(const Vec3& vertex) const;
  [[nodiscard]] Flight flight_of_point(const Parabola& path, double t_max, const SupportPlanes& left,
                                       double known) const;
  [[nodiscard]] Flight flight_of_sphere(const Parabola& path, double radius, double t_max, const SupportPlanes& left,
                                        double known) const;
  template <class Visit>
  void visit_cells(const Cells& cells, Visit&& visit) const;
  /// The height of a flight over the border through which it leaves a cell, 0 if it ends there, and over the cell's
  /// diagonal, infinite if it does not cross it.
  struct HeightsOverLines {
    double leaving, over_diagonal;
  };
  [[nodiscard]] HeightsOverLines heights_over_lines(const Parabola& path, const GridWalk& at) const;
  void meet_in_cell(const Parabola& path, const GridWalk& at, const SupportPlanes& left, ContactCandidate& best) const;
  [[nodiscard]] double max_height_in_cell(const Parabola& path, const GridWalk& at, double from, double to,
                                          double known) const;
  [[nodiscard]] std::optional<double> height_in_cell(double x, double y, std::int64_t column, std::int64_t row) const;

  RasterGrid grid_;
  std::vector<std::uint64_t> cuts_;     // a bit for each cell, at the number of its south-west node
  std::size_t columns_ = 0, rows_ = 0;  // of cells
  bool has_holes_ = false;
  double slant_ = 1;
  Box bounds_;
};

/// Calls visit(facet, triangle) for both facets of each cell with data.
template <class Visit>
void RasterSurface::visit_cells(const Cells& cells, Visit&& visit) const {
  for (std::int64_t row = cells.first_row; row <= cells.last_row; ++row) {
    for (std::int64_t column = cells.first_column; column <= cells.last_column; ++column) {
      const Cell here = cell(static_cast<std::size_t>(column), static_cast<std::size_t>(row));
      if (!here.has_data()) continue;
      const auto both = triangles(column, row, here);
      for (std::uint32_t half = 0; half < 2; ++half) visit(FacetId{facet_of(column, row, half)}, both[half]);
    }
  }
}

template <class Visit>
void RasterSurface::visit_ridges(const Vec3& low, const Vec3& high, double min_bend, Visit&& visit) const {
  visit_cells(cells_within(low.x(), high.x(), low.y(), high.y()), [&](FacetId facet, const Triangle& corner) {
    const auto beyond = neighbours(facet);
    for (std::uint32_t side = 0; side < 3; ++side) {
      if (beyond[side] && beyond[side]->index < facet.index) continue;
      const Ridge ridge{corner[side], corner[next_corner[side]], facet, side};
      if (!reaches_into(ridge, low, high)) continue;
      if (!beyond[side] || bends_down(corner, ridge, triangle(*beyond[side]), min_bend)) visit(ridge);
    }
  });
}

template <class Touch>
void RasterSurface::supports(const Vec3& centre, double radius, double reach, Touch&& touch) const {
  const double range = radius + reach;
  visit_cells(cells_within(centre.x() - range, centre.x() + range, centre.y() - range, centre.y() + range),
              [&](FacetId facet, const Triangle& corner) {
                const Vec3 away = centre - closest_point(corner, centre);
                const double distance = away.norm();
                if (distance > range) return;
                touch(distance > tolerance::no_distance ? away / distance : area_normal(corner).normalized(),
                      Vec3((corner[0] + corner[1] + corner[2]) / 3), distance, facet);
              });
}

}  // namespace talus
