#pragma once
// The part of a raster that is below a body: which of its corners are low, and which convex edges of the ground, its
// ridges, may be in it. Private to raster_surface.hpp and trajectory/.
//
// All ground within the body's reach lies under a plane of its mean slope. Heights of the body over this plane are no
// more than over the ground. So above a height `top` over the plane nothing of the body is nearer to the ground than
// that, and what is below is little: the part about its lowest corners. It ends in faces that end in such corners, and
// its place on plan is that of these corners and of the points where edges leave the part. Where no line of the grid
// and no diagonal cuts that place, there is no ridge.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

#include "talus/rocks/ridge.hpp"
#include "talus/terrain/raster_surface.hpp"

namespace talus {

class RasterSurface::UnderBody {
 public:
  UnderBody(const RasterSurface& surface, const Posture& body) : surface_(surface), body_(body) {
    const RasterGrid& grid = surface.grid_;
    u0_ = (body.centre.x() - grid.x0) / grid.dx;
    v0_ = (body.centre.y() - grid.y0) / grid.dy;
    const double u_reach = body.reach / grid.dx + box_pad, v_reach = body.reach / grid.dy + box_pad;
    is_inside_ = !surface.has_holes_ && u0_ > u_reach && v0_ > v_reach &&
                 u0_ + u_reach < static_cast<double>(surface.columns_) &&
                 v0_ + v_reach < static_cast<double>(surface.rows_);
    if (!is_inside_) return;
    west_ = static_cast<std::size_t>(u0_ - u_reach);
    south_ = static_cast<std::size_t>(v0_ - v_reach);
    const auto across = static_cast<std::size_t>(u0_ + u_reach) - west_ + 1,
               along = static_cast<std::size_t>(v0_ + v_reach) - south_ + 1;
    du_ = u0_ - static_cast<double>(west_);
    dv_ = v0_ - static_cast<double>(south_);
    over_ = surface.plane_over(surface.node(west_, south_), across, along);
    along_u_ = body.turned.rows[0] / grid.dx;
    along_v_ = body.turned.rows[1] / grid.dy;
    upwards_ = body.turned.rows[2] - over_.along_u * along_u_ - over_.along_v * along_v_;
    middle_ = body.centre.z() - over_.z - over_.along_u * du_ - over_.along_v * dv_;
  }

  /// As RasterSurface::visit_low_corners().
  template <class Visit>
  void visit_low_corners(double bound, Visit&& visit);

  /// Calls visit(ridge, part, faces) for ridges that may be less than `top` [m] below the body; only this part of it
  /// may, and only these faces of the body count there. Where the slope changes by less than `min_bend` is no ridge.
  template <class Visit>
  void visit_ridges(double top, double min_bend, Visit&& visit) const;

  /// How far a corner straight above the plane is at least above the ground below it, as a share of the distance from
  /// the plane.
  [[nodiscard]] double slant() const {
    const double x = over_.along_u / surface_.grid_.dx, y = over_.along_v / surface_.grid_.dy;
    return std::sqrt(1 + x * x + y * y);
  }
  /// No more than the height of any corner over the plane; after visit_low_corners().
  [[nodiscard]] double least_height() const { return is_inside_ ? middle_ + least_ : -infinite; }

 private:
  static constexpr double infinite = std::numeric_limits<double>::infinity();
  // Of more corners or faces, all ridges near the body are visited.
  static constexpr std::size_t max_corners = 128, max_faces = 256;

  /// On plan, in cells from the centre.
  struct PlanPart {
    double u_low = infinite, u_high = -infinite, v_low = infinite, v_high = -infinite;
    void grow(double u, double v) {
      u_low = std::min(u_low, u);
      u_high = std::max(u_high, u);
      v_low = std::min(v_low, v);
      v_high = std::max(v_high, v);
    }
  };
  /// The faces that end in a low corner.
  struct LowFaces {
    std::array<std::uint32_t, max_faces> number;
    std::array<std::uint64_t, max_faces / 64> known{};
    std::size_t count = 0;
    void add(std::uint32_t face) {
      std::uint64_t& word = known[face / 64];
      const std::uint64_t bit = std::uint64_t{1} << (face % 64);
      if ((word & bit) == 0) number[count++] = face;
      word |= bit;
    }
  };
  template <class Visit>
  void visit_ridges_in(const PlanPart& part, double lowest, double min_bend, Visit&& visit) const;

  const RasterSurface& surface_;
  const Posture& body_;
  bool is_inside_ = false;  // all cells within its reach have data
  double u0_, v0_;          // of the centre [cells]
  std::size_t west_ = 0, south_ = 0;
  double du_ = 0, dv_ = 0;  // of the centre, from the south-west node [cells]
  Plane over_{};
  Vec3 along_u_, along_v_, upwards_;
  double middle_ = 0, least_ = 0;
  std::size_t lowest_ = 0;                  // corner
  std::array<double, max_corners> height_;  // of the corners over the plane, from the centre
};

template <class Visit>
void RasterSurface::UnderBody::visit_low_corners(double bound, Visit&& visit) {
  if (!is_inside_) {
    for (std::size_t i = 0; i < body_.corners.size(); ++i) {
      const Vec3 place = body_.place(i);
      const auto ground = surface_.elevation(place.x(), place.y());
      bound = visit(i, ground ? place.z() - *ground : infinite);
    }
    return;
  }
  const auto look_at = [&](std::size_t i) {
    const Vec3& corner = body_.corners[i];
    const double u = du_ + along_u_.dot(corner), v = dv_ + along_v_.dot(corner);
    const auto column = static_cast<std::int64_t>(u), row = static_cast<std::int64_t>(v);
    const Cell here = surface_.cell(west_ + static_cast<std::size_t>(column), south_ + static_cast<std::size_t>(row));
    const double ground = here.ground_within(u - static_cast<double>(column), v - static_cast<double>(row));
    bound = visit(i, body_.centre.z() + body_.turned.rows[2].dot(corner) - ground);
  };
  least_ = infinite;
  for (std::size_t i = 0; i < body_.corners.size(); ++i) {
    const double height = upwards_.dot(body_.corners[i]);
    if (i < max_corners) height_[i] = height;
    lowest_ = height < least_ ? i : lowest_;
    least_ = std::min(least_, height);
  }
  if (middle_ + least_ > bound) return;
  look_at(lowest_);
  for (std::size_t i = 0; i < body_.corners.size(); ++i) {
    if (middle_ + upwards_.dot(body_.corners[i]) <= bound && i != lowest_) look_at(i);
  }
}

template <class Visit>
void RasterSurface::UnderBody::visit_ridges(double top, double min_bend, Visit&& visit) const {
  const HullFaces& hull = *body_.hull;
  if (!is_inside_ || hull.faces.size() > max_faces || body_.corners.size() > max_corners) {
    Vec3 low = body_.centre, high = body_.centre;
    for (std::size_t i = 0; i < body_.corners.size(); ++i) {
      const Vec3 place = body_.place(i);
      low = low.min(place);
      high = high.max(place);
    }
    const Vec3 pad = Vec3::all(std::min(top, body_.reach));
    surface_.visit_ridges(low - pad, high + pad, min_bend,
                          [&](const Ridge& ridge) { visit(ridge, RidgePart{}, hull.all); });
    return;
  }
  const double from_centre = top - middle_;
  if (least_ > from_centre) return;
  PlanPart part;
  for (std::size_t i = 0; i < body_.corners.size(); ++i) {
    if (height_[i] > from_centre) continue;
    const Vec3& corner = body_.corners[i];
    const double u = along_u_.dot(corner), v = along_v_.dot(corner), below = from_centre - height_[i];
    part.grow(u, v);
    for (const HullFaces::AtCorner& at : hull.at(i)) {
      const double there = height_[at.along];
      if (there <= from_centre) continue;
      const Vec3 edge = body_.corners[at.along] - corner;
      const double share = below / (there - height_[i]);
      part.grow(u + share * along_u_.dot(edge), v + share * along_v_.dot(edge));
    }
  }
  LowFaces faces;
  visit_ridges_in(part, middle_ + least_ - top, min_bend, [&](const Ridge& ridge, const RidgePart& within) {
    if (faces.count == 0) {
      // Those of the lowest corner first: most ridges are below one of them.
      for (const HullFaces::AtCorner& at : hull.at(lowest_)) faces.add(at.face);
      for (std::size_t i = 0; i < body_.corners.size(); ++i) {
        if (height_[i] > from_centre) continue;
        for (const HullFaces::AtCorner& at : hull.at(i)) faces.add(at.face);
      }
    }
    visit(ridge, within, std::span(faces.number.data(), faces.count));
  });
}

// `lowest`: a ridge lower than this under the plane does not count.
template <class Visit>
void RasterSurface::UnderBody::visit_ridges_in(const PlanPart& part, double lowest, double min_bend,
                                               Visit&& visit) const {
  const RasterGrid& grid = surface_.grid_;
  const double pad = 1e-6;  // [cells]
  const double u_low = du_ + part.u_low - pad, u_high = du_ + part.u_high + pad, v_low = dv_ + part.v_low - pad,
               v_high = dv_ + part.v_high + pad;
  const auto first_column = static_cast<std::int64_t>(std::floor(u_low)),
             last_column = static_cast<std::int64_t>(std::floor(u_high)),
             first_row = static_cast<std::int64_t>(std::floor(v_low)),
             last_row = static_cast<std::int64_t>(std::floor(v_high));
  const std::size_t stride = surface_.columns_ + 1;
  const double across_u = min_bend * grid.dx, across_v = min_bend * grid.dy;
  const double across_both = min_bend / std::sqrt(1 / (grid.dx * grid.dx) + 1 / (grid.dy * grid.dy));
  // Whether a part of a ridge is high enough, between a node `z` high, at a column and a row, and another.
  const auto over_plane = [&](double z, std::int64_t column, std::int64_t row) {
    return z - over_.z - static_cast<double>(column) * over_.along_u - static_cast<double>(row) * over_.along_v;
  };
  const auto counts = [&](double from, double to, const RidgePart& within) {
    return std::max(from + within.from * (to - from), from + within.to * (to - from)) >= lowest;
  };
  const auto node_at = [&](std::int64_t column, std::int64_t row, double z) {
    return Vec3{grid.x0 + static_cast<double>(static_cast<std::int64_t>(west_) + column) * grid.dx,
                grid.y0 + static_cast<double>(static_cast<std::int64_t>(south_) + row) * grid.dy, z};
  };
  const auto facet_at = [&](std::int64_t column, std::int64_t row, std::uint32_t half) {
    return FacetId{
        surface_.facet_of(static_cast<std::int64_t>(west_) + column, static_cast<std::int64_t>(south_) + row, half)};
  };
  for (std::int64_t row = first_row; row <= last_row; ++row) {
    for (std::int64_t column = first_column; column <= last_column; ++column) {
      const std::size_t node = surface_.node(static_cast<std::size_t>(static_cast<std::int64_t>(west_) + column),
                                             static_cast<std::size_t>(static_cast<std::int64_t>(south_) + row));
      const Cell here = surface_.cell_at(node);
      const bool north_east = here.is_cut_north_east;
      const auto c = static_cast<double>(column), r = static_cast<double>(row);
      // The part within this cell, and of the diagonal within that.
      const double u0 = std::max(u_low - c, 0.0), u1 = std::min(u_high - c, 1.0), v0 = std::max(v_low - r, 0.0),
                   v1 = std::min(v_high - r, 1.0);
      const RidgePart cut = north_east ? RidgePart{std::max(u0, v0), std::min(u1, v1)}
                                       : RidgePart{std::max(v0, 1 - u1), std::min(v1, 1 - u0)};
      const double rise = here.sw + here.ne - here.se - here.nw;
      if (cut.from < cut.to && (north_east ? rise : -rise) > across_both) {
        const double from = north_east ? here.sw : here.se, to = north_east ? here.ne : here.nw;
        const std::int64_t aside = north_east ? 0 : 1;
        if (counts(over_plane(from, column + aside, row), over_plane(to, column + 1 - aside, row + 1), cut)) {
          visit(Ridge{node_at(column + aside, row, from), node_at(column + 1 - aside, row + 1, to),
                      facet_at(column, row, 0), north_east ? 2U : 1U},
                cut);
        }
      }
      if (column > first_column) {  // the west side
        const Cell west = surface_.cell_at(node - 1);
        // Of the facets beside it: the third node of one cut to the north-east is at the side's other end.
        const double rise_to = west.is_cut_north_east ? here.sw - west.sw : here.nw - west.nw;
        const double rise_from = north_east ? here.ne - here.nw : here.se - here.sw;
        if (rise_to - rise_from > across_u &&
            counts(over_plane(here.nw, column, row + 1), over_plane(here.sw, column, row), {1 - v1, 1 - v0})) {
          visit(Ridge{node_at(column, row + 1, here.nw), node_at(column, row, here.sw),
                      facet_at(column, row, north_east ? 1 : 0), 2},
                RidgePart{1 - v1, 1 - v0});
        }
      }
      if (row > first_row) {  // the south side
        const Cell south = surface_.cell_at(node - stride);
        const double rise_to = south.is_cut_north_east ? here.sw - south.sw : here.se - south.se;
        const double rise_from = north_east ? here.ne - here.se : here.nw - here.sw;
        if (rise_to - rise_from > across_v &&
            counts(over_plane(here.sw, column, row), over_plane(here.se, column + 1, row), {u0, u1})) {
          visit(Ridge{node_at(column, row, here.sw), node_at(column + 1, row, here.se), facet_at(column, row, 0), 0},
                RidgePart{u0, u1});
        }
      }
    }
  }
}

}  // namespace talus
