#pragma once
// A part of a sphere's path over a raster: where the centre is at its ends, and what follows from that for the facets
// below. Between the ends the centre leaves the straight line by at most the bend. Private to raster_sphere.cpp.

#include <algorithm>
#include <cmath>
#include <utility>

#include "talus/terrain/raster_surface.hpp"

namespace talus {

class RasterSurface::SpherePart {
 public:
  /// The centre, on plan in cells from the grid's corner.
  struct Place {
    double u, v, z;
  };
  /// A facet, and the heights of the centre over its plane at the ends of the part. In between, the height is below the
  /// straight line by at most the sag if that is positive, and above it if not.
  struct Facet {
    std::int64_t column, row;
    Cell cell;
    std::uint32_t half;
    Plane plane;
    double squared_slant;  // of the ratio of heights over the plane to distances from it
    double start_height, end_height, sag;
  };
  /// The range of the centre's feet on a facet's plane during the part, on plan from the corner of the facet's cell.
  struct Feet {
    double u_low, u_high, v_low, v_high;
    double side_low, side_high;  // positive on the first facet's side of the cell's diagonal
  };
  /// Tolerance for the place of a foot [cells]: for rounding, and for a sphere that has sunk in slightly.
  static constexpr double foot_slack = 0.02;

  SpherePart(const RasterSurface& surface, const Parabola& path, double radius)
      : surface_(surface),
        grid_(surface.grid_),
        path_(path),
        radius_(radius),
        u_scale_(1 / grid_.dx),
        v_scale_(1 / grid_.dy) {}

  [[nodiscard]] double radius() const { return radius_; }
  [[nodiscard]] double u_scale() const { return u_scale_; }  // cells per metre
  [[nodiscard]] double v_scale() const { return v_scale_; }
  [[nodiscard]] double start_time() const { return start_time_; }
  [[nodiscard]] double end_time() const { return end_time_; }
  [[nodiscard]] const Place& start() const { return start_; }
  [[nodiscard]] const Place& end() const { return end_; }
  [[nodiscard]] const Place& bend() const { return bend_; }

  /// The next part begins at a time.
  void start_at(double t) {
    end_time_ = t;
    end_ = place(t);
  }
  /// The next part, from the end of the last one.
  void advance_to(double t) {
    start_time_ = end_time_;
    start_ = end_;
    end_at(t);
  }
  void end_at(double t) {
    end_time_ = t;
    end_ = place(t);
    const double duration = t - start_time_, bend = 0.125 * duration * duration;
    bend_ = {bend * path_.a.x() * u_scale_, bend * path_.a.y() * v_scale_, bend * path_.a.z()};
  }
  [[nodiscard]] Place place(double t) const {
    const Vec3 p = path_.at(t);
    return {(p.x() - grid_.x0) * u_scale_, (p.y() - grid_.y0) * v_scale_, p.z()};
  }

  /// The cells of the grid within these distances from the path on plan [cells].
  [[nodiscard]] Cells cells_within(double west, double east, double south, double north) const {
    const auto cells = [](double low, double high, std::size_t count) {
      const auto last = static_cast<double>(count) - 1;
      return std::pair{static_cast<std::int64_t>(std::max(0.0, low)),
                       // (Below zero the conversion rounds up, but -1 is needed there.)
                       static_cast<std::int64_t>(std::min(last, high) + 1) - 1};
    };
    const double bend_u = std::abs(bend_.u), bend_v = std::abs(bend_.v);
    const auto [first_column, last_column] = cells(std::min(start_.u, end_.u) - west - bend_u,
                                                   std::max(start_.u, end_.u) + east + bend_u, surface_.columns_);
    const auto [first_row, last_row] =
        cells(std::min(start_.v, end_.v) - south - bend_v, std::max(start_.v, end_.v) + north + bend_v, surface_.rows_);
    return {first_column, last_column, first_row, last_row};
  }
  [[nodiscard]] Cells cells_near() const {
    const double u = (radius_ + box_pad) * u_scale_, v = (radius_ + box_pad) * v_scale_;
    return cells_within(u, u, v, v);
  }
  /// Whether cells, and all cells around them, are on the grid, which has no holes.
  [[nodiscard]] bool is_inside(const Cells& cells) const {
    return !surface_.has_holes_ && cells.first_column > 0 && cells.first_row > 0 &&
           cells.last_column + 1 < static_cast<std::int64_t>(surface_.columns_) &&
           cells.last_row + 1 < static_cast<std::int64_t>(surface_.rows_);
  }
  [[nodiscard]] const float* node(std::int64_t column, std::int64_t row) const {
    return grid_.z.data() + static_cast<std::size_t>(row) * grid_.columns + static_cast<std::size_t>(column);
  }
  [[nodiscard]] Cell cell(std::int64_t column, std::int64_t row) const {
    return surface_.cell(static_cast<std::size_t>(column), static_cast<std::size_t>(row));
  }

  // ---- planes ----

  [[nodiscard]] static double height(const Place& centre, const Plane& plane, double u, double v) {
    return centre.z - plane.z - (centre.u - u) * plane.along_u - (centre.v - v) * plane.along_v;
  }
  [[nodiscard]] double sag(const Plane& plane) const {
    return bend_.z - plane.along_u * bend_.u - plane.along_v * bend_.v;
  }
  [[nodiscard]] double squared_slant(const Plane& plane) const {
    return 1 + plane.along_u * plane.along_u * (u_scale_ * u_scale_) +
           plane.along_v * plane.along_v * (v_scale_ * v_scale_);
  }

  // ---- facets ----

  [[nodiscard]] Facet facet(std::int64_t column, std::int64_t row, const Cell& here, std::uint32_t half) const {
    const Plane plane = here.plane(half);
    Facet facet{column, row, here, half, plane, squared_slant(plane), 0, 0, sag(plane)};
    facet.start_height = height(start_, facet);
    facet.end_height = height(end_, facet);
    return facet;
  }
  /// Adapts a facet of this part to an end that has moved (end_at).
  void update_end(Facet& facet) const {
    facet.end_height = height(end_, facet);
    facet.sag = sag(facet.plane);
  }
  /// Whether the sphere stays above a facet's plane.
  [[nodiscard]] bool is_above(const Facet& facet) const {
    const double lowest = std::min(facet.start_height, facet.end_height) - std::max(0.0, facet.sag);
    const double reach = radius_ + box_pad;
    return lowest > 0 && lowest * lowest > reach * reach * facet.squared_slant;
  }
  [[nodiscard]] Feet feet(const Facet& facet) const {
    return feet(facet, facet.start_height, facet.end_height, std::abs(facet.sag));
  }
  /// Whether the sphere, if it touches the facet's plane, may touch it within the facet.
  [[nodiscard]] bool may_touch_face(const Facet& facet) const {
    const double touching = radius_ * std::sqrt(facet.squared_slant);
    const Feet at = feet(facet, touching, touching, 0);
    return at.u_high >= 0 && at.u_low <= 1 && at.v_high >= 0 && at.v_low <= 1 &&
           (facet.half == 0 ? at.side_high >= 0 : at.side_low <= 0);
  }

 private:
  [[nodiscard]] static double height(const Place& centre, const Facet& facet) {
    return height(centre, facet.plane, static_cast<double>(facet.column) + facet.plane.corner,
                  static_cast<double>(facet.row) + facet.plane.corner);
  }
  // For these heights of the centre over the plane at the ends of the part; in between they leave the straight line by
  // at most `sag`.
  [[nodiscard]] Feet feet(const Facet& facet, double start_height, double end_height, double sag) const {
    // The foot lies up the slope from the centre: this many cells per metre of height.
    const double share = 1 / facet.squared_slant;
    const double up_u = facet.plane.along_u * (u_scale_ * u_scale_) * share;
    const double up_v = facet.plane.along_v * (v_scale_ * v_scale_) * share;
    const auto west = static_cast<double>(facet.column), south = static_cast<double>(facet.row);
    const double u0 = start_.u - west + up_u * start_height, u1 = end_.u - west + up_u * end_height;
    const double v0 = start_.v - south + up_v * start_height, v1 = end_.v - south + up_v * end_height;
    const double u_slack = foot_slack + std::abs(bend_.u) + std::abs(up_u) * sag;
    const double v_slack = foot_slack + std::abs(bend_.v) + std::abs(up_v) * sag;
    const bool north_east = facet.cell.is_cut_north_east;
    const double side0 = north_east ? u0 - v0 : 1 - u0 - v0, side1 = north_east ? u1 - v1 : 1 - u1 - v1;
    return {std::min(u0, u1) - u_slack,
            std::max(u0, u1) + u_slack,
            std::min(v0, v1) - v_slack,
            std::max(v0, v1) + v_slack,
            std::min(side0, side1) - u_slack - v_slack,
            std::max(side0, side1) + u_slack + v_slack};
  }

  const RasterSurface& surface_;
  const RasterGrid& grid_;
  const Parabola& path_;
  const double radius_;
  const double u_scale_, v_scale_;
  double start_time_ = 0, end_time_ = 0;
  Place start_{}, end_{}, bend_{};
};

}  // namespace talus
