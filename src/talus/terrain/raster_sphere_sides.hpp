#pragma once
// The sides and corners of a raster's facets that a sphere may touch before a face. As bits of a facet: sides are 0 to
// 2, corners 3 to 5. Private to raster_sphere.cpp.
//
// Where a sphere first touches a side, no point of the two facets there is nearer to its centre than the side: the feet
// of the centre on both planes lie beyond it.

#include <array>

#include "talus/terrain/raster_sphere_part.hpp"

namespace talus {

class RasterSurface::SphereSides {
 public:
  using Facet = SpherePart::Facet;
  using Feet = SpherePart::Feet;

  SphereSides(const RasterSurface& surface, const SpherePart& part) : surface_(surface), part_(part) {}

  /// The bits of a facet that must be tested in the present part of the path; those that facets share, for one facet
  /// only.
  [[nodiscard]] std::uint32_t to_test(const Facet& own) const {
    const std::int64_t column = own.column, row = own.row;
    if (!part_.is_inside({column, column, row, row})) return owned(column, row, own.cell, own.half);
    // A side is tested only if the ground falls away across it.
    const bool north_east = own.cell.is_cut_north_east;
    const Feet here = part_.feet(own);
    std::uint32_t bits = 0;
    if ((own.half == 0) == north_east && here.u_high > 1) {  // it has the cell's east side
      const Cell east = part_.cell(column + 1, row);
      const Facet beyond = part_.facet(column + 1, row, east, east.is_cut_north_east ? 1 : 0);
      if (beyond.plane.along_u < own.plane.along_u && !part_.is_above(beyond) && part_.feet(beyond).u_low < 0) {
        bits |= 1U << (north_east ? 1 : 0);
      }
    }
    if (own.half == 1) {  // it has the north side
      if (here.v_high > 1) {
        const Facet beyond = part_.facet(column, row + 1, part_.cell(column, row + 1), 0);
        if (beyond.plane.along_v < own.plane.along_v && !part_.is_above(beyond) && part_.feet(beyond).v_low < 0) {
          bits |= 1U << 1;
        }
      }
      return bits;
    }
    if (here.side_low < 0) {
      const double along_cut = north_east ? own.cell.sw + own.cell.ne : own.cell.se + own.cell.nw;
      const double across_cut = north_east ? own.cell.se + own.cell.nw : own.cell.sw + own.cell.ne;
      if (across_cut < along_cut) {
        const Facet beyond = part_.facet(column, row, own.cell, 1);
        if (!part_.is_above(beyond) && part_.feet(beyond).side_high > 0) bits |= 1U << (north_east ? 2 : 1);
      }
    }
    return may_touch_south_west(own) ? bits | 1U << 3 : bits;
  }

 private:
  // A corner is touched before the sides that meet there only if the centre lies behind it along each of them.
  [[nodiscard]] bool may_touch_south_west(const Facet& facet) const {
    const auto u = static_cast<double>(facet.column), v = static_cast<double>(facet.row);
    const auto &start = part_.start(), &end = part_.end(), &bend = part_.bend();
    const Cell& here = facet.cell;
    const float* corner = part_.node(facet.column, facet.row);
    const auto may_be_behind = [](double at_start, double at_end, double bent) {
      return std::min(at_start, at_end) - std::abs(bent) < SpherePart::foot_slack;
    };
    // Along a side to the east or west, and to the north or south, in cells.
    const auto along_u = [&](double way, double rise) {
      const double steep = rise * (part_.u_scale() * part_.u_scale());
      return may_be_behind(way * (start.u - u) + steep * (start.z - here.sw),
                           way * (end.u - u) + steep * (end.z - here.sw), way * bend.u + steep * bend.z);
    };
    const auto along_v = [&](double way, double rise) {
      const double steep = rise * (part_.v_scale() * part_.v_scale());
      return may_be_behind(way * (start.v - v) + steep * (start.z - here.sw),
                           way * (end.v - v) + steep * (end.z - here.sw), way * bend.v + steep * bend.z);
    };
    return along_u(1, here.se - here.sw) && along_v(1, here.nw - here.sw) && along_u(-1, corner[-1] - here.sw) &&
           along_v(-1, *(corner - surface_.grid_.columns) - here.sw);
  }

  // Every side and corner belongs to one of the facets around it: a side to the facet with the lower number, a corner
  // to the cell north-east of it, if that has data.
  [[nodiscard]] std::uint32_t owned(std::int64_t column, std::int64_t row, const Cell& here, std::uint32_t half) const {
    const bool is_first = half == 0, north_east = here.is_cut_north_east;
    const auto data = [&](std::int64_t dx, std::int64_t dy) {
      const std::int64_t i = column + dx, j = row + dy;
      return i >= 0 && j >= 0 && i < static_cast<std::int64_t>(surface_.columns_) &&
             j < static_cast<std::int64_t>(surface_.rows_) && part_.cell(i, j).has_data();
    };
    enum Element { south, east, north, west, diagonal, sw, se, nw, ne };
    static constexpr std::array<std::array<Element, 6>, 4> elements{{{south, diagonal, west, sw, se, nw},
                                                                     {east, north, diagonal, se, ne, nw},
                                                                     {south, east, diagonal, sw, se, ne},
                                                                     {diagonal, north, west, sw, ne, nw}}};
    const auto owns = [&](Element element) {
      switch (element) {
        case south:
          return !data(0, -1);
        case west:
          return !data(-1, 0);
        case east:
        case north:
          return true;
        case diagonal:
        case sw:
          return is_first;
        case se:
          return is_first && !data(1, 0);
        case nw:
          return is_first != north_east && !data(0, 1) && !data(-1, 1);
        case ne:
          return is_first == north_east && !data(1, 1) && !data(0, 1) && !data(1, 0);
      }
      return false;
    };
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 6; ++k) bits |= owns(elements[(north_east ? 2U : 0U) + half][k]) ? 1U << k : 0U;
    return bits;
  }

  const RasterSurface& surface_;
  const SpherePart& part_;
};

}  // namespace talus
