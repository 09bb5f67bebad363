// How a sphere meets a raster. Its path is looked at in parts, each over one cell, so that a contact found in one part
// comes before all of the parts to come. In most parts the sphere is clear of all nodes around; where it is well clear,
// several cells are one part. In the others it meets faces first; the time of such a contact shortens the part in which
// sides and corners are asked.
//
// What can be told from the ends of a part is told before any root is looked for: a facet is out of reach if the sphere
// stays above its plane, and with it are its sides and corners. And where a sphere first touches a side, no point of
// the two facets there is nearer to its centre than the side: the feet of the centre on both planes lie beyond it.

#include <algorithm>
#include <cmath>

#include "talus/terrain/raster_surface.hpp"

namespace talus {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

}  // namespace

class RasterSurface::SphereSearch {
 public:
  SphereSearch(const RasterSurface& surface, const Parabola& path, SpherePath kind, double radius, double t_max,
               const SupportPlanes& left)
      : surface_(surface),
        grid_(surface.grid_),
        path_(path),
        kind_(kind),
        radius_(radius),
        left_(left),
        u_scale_(1 / grid_.dx),
        v_scale_(1 / grid_.dy),
        best_{t_max} {}

  /// Of the parts so far.
  [[nodiscard]] const ContactCandidate& best() const { return best_; }
  /// The centre is nowhere further above the ground [m].
  [[nodiscard]] double max_height() const { return greatest_height_; }

  /// Where the first part begins.
  void start_at(double t) {
    end_time_ = t;
    end_ = place(t);
  }
  /// Whether the sphere would be well clear at a time if the ground went on as it did in the last part.
  [[nodiscard]] bool seems_clear_at(double t) const {
    const auto u = static_cast<double>(near_.first_column), v = static_cast<double>(near_.first_row);
    return height(place(t), slope_, u, v) - slanting_reach_ - highest_ > 0.25 * std::max(grid_.dx, grid_.dy);
  }
  /// Whether a part of the path, over several cells, is clear of all nodes. If so, the next part begins at its end.
  bool skip_until(double leave) {
    begin_part(leave);
    if (is_clear()) return true;
    start_at(start_time_);
    return false;
  }
  /// Looks at the part of the path up to a time; the next part begins there.
  void look_until(double leave) {
    begin_part(leave);
    if (is_clear()) return;
    const Cells cells = cells_beneath();
    for (std::int64_t row = cells.first_row; row <= cells.last_row; ++row) {
      for (std::int64_t column = cells.first_column; column <= cells.last_column; ++column) {
        const Cell here = cell(column, row);
        if (is_clear_of(column, row, here) || (surface_.has_holes_ && !here.has_data())) continue;
        for (std::uint32_t half = 0; half < 2; ++half) {
          const Facet each = facet(column, row, here, half);
          if (is_above(each)) continue;
          if (facets_ == most_facets) meet_facets();
          facet_[facets_++] = each;
        }
      }
    }
    meet_facets();
  }

 private:
  // Where the centre is at a time, on plan in cells from the grid's corner.
  struct Place {
    double u, v, z;
  };
  // A facet, and the heights of the centre over its plane at the ends of the part; between them it is lower than the
  // straight line by no more than the sag, if that is above zero, and higher if it is not.
  struct Facet {
    std::int64_t column, row;
    Cell cell;
    std::uint32_t half;
    Plane plane;
    double squared_slant;  // of the ratio of heights over the plane to distances from it
    double start_height, end_height, sag;
  };
  // The feet of the centre on a facet's plane in the part: between these, on plan from the facet's cell's corner.
  struct Feet {
    double u_low, u_high, v_low, v_high;
    double side_low, side_high;  // of what is positive on the first facet's side of the cell's diagonal
  };
  // How far a foot may be from where it should be [cells], by rounding or of a sphere that has sunk in by a trace.
  static constexpr double unsure = 0.02;

  void begin_part(double leave) {
    start_time_ = end_time_;
    start_ = end_;
    end_at(leave);
    near_ = cells_near();
  }
  [[nodiscard]] Place place(double t) const {
    const Vec3 p = path_.at(t);
    return {(p.x() - grid_.x0) * u_scale_, (p.y() - grid_.y0) * v_scale_, p.z()};
  }
  void end_at(double t) {
    end_time_ = t;
    end_ = place(t);
    // The most by which the way between them leaves the straight line.
    const double duration = t - start_time_, bend = 0.125 * duration * duration;
    bend_ = {bend * path_.a.x() * u_scale_, bend * path_.a.y() * v_scale_, bend * path_.a.z()};
  }

  // The cells of the grid over which lies what is so far, at most, from the centre's way on plan [cells].
  [[nodiscard]] Cells cells_within(double west, double east, double south, double north) const {
    const auto cells = [](double low, double high, std::size_t count) {
      const auto last = static_cast<double>(count) - 1;
      return std::pair{static_cast<std::int64_t>(std::max(0.0, low)),
                       // (Below zero it is cut off upwards: there -1 is wanted.)
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
  // Those of the cells near where the sphere may touch anything: it touches the ground up the slope from its centre,
  // at an edge or a corner in a direction between those of the facets there.
  [[nodiscard]] Cells cells_beneath() const {
    const bool is_inside = !surface_.has_holes_ && near_.first_column > 0 && near_.first_row > 0 &&
                           near_.last_column + 1 < static_cast<std::int64_t>(surface_.columns_) &&
                           near_.last_row + 1 < static_cast<std::int64_t>(surface_.rows_);
    if (!is_inside) return near_;
    double u_least = infinite, u_most = -infinite, v_least = infinite, v_most = -infinite;  // of slopes along u and v
    const std::int64_t across = near_.last_column - near_.first_column + 1;
    const float* south = node(near_.first_column, near_.first_row);
    for (std::int64_t row = near_.first_row; row <= near_.last_row + 1; ++row, south += grid_.columns) {
      for (std::int64_t k = 0; k < across; ++k) {
        const double rise = static_cast<double>(south[k + 1]) - south[k];
        u_least = std::min(u_least, rise);
        u_most = std::max(u_most, rise);
      }
      if (row > near_.last_row) break;
      for (std::int64_t k = 0; k <= across; ++k) {
        const double rise = static_cast<double>(south[k + static_cast<std::int64_t>(grid_.columns)]) - south[k];
        v_least = std::min(v_least, rise);
        v_most = std::max(v_most, rise);
      }
    }
    // The most that g / sqrt(1 + g^2 + h^2) can be, the slope up to g along one axis and within the others along the
    // other.
    const auto most_up = [](double g, double h_least, double h_most) {
      const double h = (g > 0) == (std::abs(h_least) < std::abs(h_most)) ? h_least : h_most;
      return g / std::sqrt(1 + g * g + (g > 0 && h_least < 0 && h_most > 0 ? 0 : h * h));
    };
    u_least *= u_scale_, u_most *= u_scale_, v_least *= v_scale_, v_most *= v_scale_;
    const double u = radius_ * u_scale_, v = radius_ * v_scale_;
    const Cells beneath =
        cells_within(u * most_up(-u_least, v_least, v_most) + unsure, u * most_up(u_most, v_least, v_most) + unsure,
                     v * most_up(-v_least, u_least, u_most) + unsure, v * most_up(v_most, u_least, u_most) + unsure);
    return {std::max(near_.first_column, beneath.first_column), std::min(near_.last_column, beneath.last_column),
            std::max(near_.first_row, beneath.first_row), std::min(near_.last_row, beneath.last_row)};
  }
  [[nodiscard]] const float* node(std::int64_t column, std::int64_t row) const {
    return grid_.z.data() + static_cast<std::size_t>(row) * grid_.columns + static_cast<std::size_t>(column);
  }

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

  // ---- nodes ----

  // How high over the plane slope_ a node may be that the sphere does not touch.
  [[nodiscard]] double room_over_slope() const {
    const auto u = static_cast<double>(near_.first_column), v = static_cast<double>(near_.first_row);
    return std::min(height(start_, slope_, u, v), height(end_, slope_, u, v)) - std::max(0.0, sag(slope_)) -
           slanting_reach_;
  }
  // How high over the plane slope_ its centre is at the most.
  [[nodiscard]] double height_over_slope() const {
    const auto u = static_cast<double>(near_.first_column), v = static_cast<double>(near_.first_row);
    return std::max(height(start_, slope_, u, v), height(end_, slope_, u, v)) + std::abs(sag(slope_)) + box_pad;
  }
  // Whether the sphere is out of reach of all nodes near. The plane from which their heights are measured leans as the
  // ground does.
  [[nodiscard]] bool is_clear() {
    if (near_.first_column > near_.last_column || near_.first_row > near_.last_row) return true;
    const std::int64_t across = near_.last_column - near_.first_column + 1,
                       along = near_.last_row - near_.first_row + 1;
    const float *south = node(near_.first_column, near_.first_row),
                *north = node(near_.first_column, near_.last_row + 1);
    const double sw = south[0], se = south[across], nw = north[0], ne = north[across];
    slope_ = {0, 0.5 * (se - sw + ne - nw) / static_cast<double>(across),
              0.5 * (nw - sw + ne - se) / static_cast<double>(along)};
    slanting_reach_ = (radius_ + box_pad) * std::sqrt(squared_slant(slope_));
    room_ = room_over_slope();
    highest_ = -infinite;
    double lowest = infinite;
    double rise = 0;
    for (std::int64_t row = 0; row <= along; ++row, south += grid_.columns, rise += slope_.along_v) {
      double there = rise;
      for (std::int64_t column = 0; column <= across; ++column, there += slope_.along_u) {
        const double over_slope = south[column] - there;
        highest_ = std::max(highest_, over_slope);
        lowest = std::min(lowest, over_slope);
      }
    }
    greatest_height_ = std::max(greatest_height_, height_over_slope() - lowest);
    return highest_ < room_;
  }
  // Whether it is out of reach of a cell's nodes. (Not so where one of them, or of those around, has no data.)
  [[nodiscard]] bool is_clear_of(std::int64_t column, std::int64_t row, const Cell& here) const {
    const double highest = std::max(std::max(here.sw, here.se - slope_.along_u),
                                    std::max(here.nw, here.ne - slope_.along_u) - slope_.along_v);
    return highest - slope_.along_u * static_cast<double>(column - near_.first_column) -
               slope_.along_v * static_cast<double>(row - near_.first_row) <
           room_;
  }

  // ---- facets ----

  [[nodiscard]] Facet facet(std::int64_t column, std::int64_t row, const Cell& here, std::uint32_t half) const {
    const Plane plane = here.plane(half);
    Facet facet{column, row, here, half, plane, squared_slant(plane), 0, 0, sag(plane)};
    facet.start_height = height(start_, facet);
    facet.end_height = height(end_, facet);
    return facet;
  }
  [[nodiscard]] Triangle triangle(const Facet& facet) const {
    return surface_.triangle(facet.column, facet.row, kind_of(facet.cell, facet.half));
  }
  [[nodiscard]] FacetName name_of(const Facet& facet) const {
    const std::uint32_t number = surface_.facet_of(facet.column, facet.row, facet.half);
    return {number, number};
  }
  [[nodiscard]] Cell cell(std::int64_t column, std::int64_t row) const {
    return surface_.cell(static_cast<std::size_t>(column), static_cast<std::size_t>(row));
  }

  [[nodiscard]] static double height(const Place& centre, const Facet& facet) {
    return height(centre, facet.plane, static_cast<double>(facet.column) + facet.plane.corner,
                  static_cast<double>(facet.row) + facet.plane.corner);
  }
  // Whether the sphere stays above a facet's plane.
  [[nodiscard]] bool is_above(const Facet& facet) const {
    const double lowest = std::min(facet.start_height, facet.end_height) - std::max(0.0, facet.sag);
    const double reach = radius_ + box_pad;
    return lowest > 0 && lowest * lowest > reach * reach * facet.squared_slant;
  }

  // Lets the sphere meet the facets of the list, and empties it. What is met shortens the part.
  void meet_facets() {
    for (std::size_t k = 0; k < facets_; ++k) {
      if (!may_touch_face(facet_[k])) continue;
      const Triangle corner = triangle(facet_[k]);
      meet_face(path_, radius_, corner, SphereOverFacet(path_, radius_, corner), name_of(facet_[k]), left_, best_);
    }
    const std::size_t count = std::exchange(facets_, 0);
    if (best_.t < start_time_) return;
    const bool is_shorter = best_.t < end_time_;
    if (is_shorter) end_at(best_.t);
    for (std::size_t k = 0; k < count; ++k) {
      Facet& facet = facet_[k];
      if (is_shorter) {
        facet.end_height = height(end_, facet);
        facet.sag = sag(facet.plane);
        if (is_above(facet)) continue;
      }
      const std::uint32_t parts = parts_to_ask(facet);
      if (parts == 0) continue;
      const FacetName name = name_of(facet);
      const auto sharp = [&](std::size_t what, double t) {
        return t < 0 ? (parts & (1U << what)) != 0 : is_sharp(FacetId{name.facet}, what);
      };
      meet_sides(path_, kind_, radius_, {start_time_, end_time_}, triangle(facet), name, left_, sharp, best_);
    }
  }

  // For heights of the centre over the plane that are these at the part's ends, and leave the straight line between
  // them by no more than `sag`.
  [[nodiscard]] Feet feet(const Facet& facet, double start_height, double end_height, double sag) const {
    // The foot lies up the slope: so many cells a metre of height.
    const double share = 1 / facet.squared_slant;
    const double up_u = facet.plane.along_u * (u_scale_ * u_scale_) * share;
    const double up_v = facet.plane.along_v * (v_scale_ * v_scale_) * share;
    const auto west = static_cast<double>(facet.column), south = static_cast<double>(facet.row);
    const double u0 = start_.u - west + up_u * start_height, u1 = end_.u - west + up_u * end_height;
    const double v0 = start_.v - south + up_v * start_height, v1 = end_.v - south + up_v * end_height;
    const double u_slack = unsure + std::abs(bend_.u) + std::abs(up_u) * sag;
    const double v_slack = unsure + std::abs(bend_.v) + std::abs(up_v) * sag;
    const bool north_east = facet.cell.cut_north_east();
    const double side0 = north_east ? u0 - v0 : 1 - u0 - v0, side1 = north_east ? u1 - v1 : 1 - u1 - v1;
    return {std::min(u0, u1) - u_slack,
            std::max(u0, u1) + u_slack,
            std::min(v0, v1) - v_slack,
            std::max(v0, v1) + v_slack,
            std::min(side0, side1) - u_slack - v_slack,
            std::max(side0, side1) + u_slack + v_slack};
  }
  [[nodiscard]] Feet feet(const Facet& facet) const {
    return feet(facet, facet.start_height, facet.end_height, std::abs(facet.sag));
  }
  [[nodiscard]] bool may_touch_face(const Facet& facet) const {
    const double touching = radius_ * std::sqrt(facet.squared_slant);
    const Feet at = feet(facet, touching, touching, 0);
    return at.u_high >= 0 && at.u_low <= 1 && at.v_high >= 0 && at.v_low <= 1 &&
           (facet.half == 0 ? at.side_high >= 0 : at.side_low <= 0);
  }

  // ---- sides and corners: bits 0 to 2 and 3 to 5 of a facet ----

  // Those of a facet that the sphere may touch before a face, each asked of one facet only.
  [[nodiscard]] std::uint32_t parts_to_ask(const Facet& own) const {
    const std::int64_t column = own.column, row = own.row;
    const bool is_inside = !surface_.has_holes_ && column > 0 && row > 0 &&
                           column + 1 < static_cast<std::int64_t>(surface_.columns_) &&
                           row + 1 < static_cast<std::int64_t>(surface_.rows_);
    if (!is_inside) return owned_parts(column, row, own.cell, own.half);
    // A side is one of them only if the ground falls away across it.
    const bool north_east = own.cell.cut_north_east();
    const Feet here = feet(own);
    std::uint32_t parts = 0;
    if ((own.half == 0) == north_east && here.u_high > 1) {  // it has the cell's east side
      const Cell east = cell(column + 1, row);
      const Facet beyond = facet(column + 1, row, east, east.cut_north_east() ? 1 : 0);
      if (beyond.plane.along_u < own.plane.along_u && !is_above(beyond) && feet(beyond).u_low < 0) {
        parts |= 1U << (north_east ? 1 : 0);
      }
    }
    if (own.half == 1) {  // it has the north side
      if (here.v_high > 1) {
        const Facet beyond = facet(column, row + 1, cell(column, row + 1), 0);
        if (beyond.plane.along_v < own.plane.along_v && !is_above(beyond) && feet(beyond).v_low < 0) parts |= 1U << 1;
      }
      return parts;
    }
    if (here.side_low < 0) {
      const double along_cut = north_east ? own.cell.sw + own.cell.ne : own.cell.se + own.cell.nw;
      const double across_cut = north_east ? own.cell.se + own.cell.nw : own.cell.sw + own.cell.ne;
      if (across_cut < along_cut) {
        const Facet beyond = facet(column, row, own.cell, 1);
        if (!is_above(beyond) && feet(beyond).side_high > 0) parts |= 1U << (north_east ? 2 : 1);
      }
    }
    return may_touch_south_west(own) ? parts | 1U << 3 : parts;
  }

  // A corner is touched before the sides that meet there only where the centre lies behind it along each of them.
  [[nodiscard]] bool may_touch_south_west(const Facet& facet) const {
    const auto u = static_cast<double>(facet.column), v = static_cast<double>(facet.row);
    const Cell& here = facet.cell;
    const float* corner = node(facet.column, facet.row);
    const auto may_be_behind = [](double start, double end, double bend) {
      return std::min(start, end) - std::abs(bend) < unsure;
    };
    // Along a side to the east or west, and to the north or south, in cells.
    const auto along_u = [&](double way, double rise) {
      const double steep = rise * (u_scale_ * u_scale_);
      return may_be_behind(way * (start_.u - u) + steep * (start_.z - here.sw),
                           way * (end_.u - u) + steep * (end_.z - here.sw), way * bend_.u + steep * bend_.z);
    };
    const auto along_v = [&](double way, double rise) {
      const double steep = rise * (v_scale_ * v_scale_);
      return may_be_behind(way * (start_.v - v) + steep * (start_.z - here.sw),
                           way * (end_.v - v) + steep * (end_.z - here.sw), way * bend_.v + steep * bend_.z);
    };
    return along_u(1, here.se - here.sw) && along_v(1, here.nw - here.sw) && along_u(-1, corner[-1] - here.sw) &&
           along_v(-1, *(corner - grid_.columns) - here.sw);
  }

  // Every side and corner belongs to one of the facets around it, so that a sphere asks each of them once: a side to
  // the facet of lower number, a corner to the cell of which it is the south-west one, if that has data.
  [[nodiscard]] std::uint32_t owned_parts(std::int64_t column, std::int64_t row, const Cell& here,
                                          std::uint32_t half) const {
    const bool is_first = half == 0, north_east = here.cut_north_east();
    const auto data = [&](std::int64_t dx, std::int64_t dy) {
      const std::int64_t i = column + dx, j = row + dy;
      return i >= 0 && j >= 0 && i < static_cast<std::int64_t>(surface_.columns_) &&
             j < static_cast<std::int64_t>(surface_.rows_) && cell(i, j).has_data();
    };
    enum Part { south, east, north, west, diagonal, sw, se, nw, ne };
    static constexpr std::array<std::array<Part, 6>, 4> parts{{{south, diagonal, west, sw, se, nw},
                                                               {east, north, diagonal, se, ne, nw},
                                                               {south, east, diagonal, sw, se, ne},
                                                               {diagonal, north, west, sw, ne, nw}}};
    const auto owns = [&](Part part) {
      switch (part) {
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
    std::uint32_t owned = 0;
    for (std::size_t k = 0; k < 6; ++k) owned |= owns(parts[(north_east ? 2U : 0U) + half][k]) ? 1U << k : 0U;
    return owned;
  }

  [[nodiscard]] bool is_sharp(FacetId facet, std::size_t what) const {
    return what < 3 ? surface_.is_sharp_edge(facet, what)
                    : surface_.is_sharp_vertex(surface_.triangle(facet)[what - 3]);
  }

  const RasterSurface& surface_;
  const RasterGrid& grid_;
  const Parabola& path_;
  const SpherePath kind_;
  const double radius_;
  const SupportPlanes& left_;
  const double u_scale_, v_scale_;  // cells a metre
  ContactCandidate best_;
  double greatest_height_ = 0;
  // Of the part that is looked at:
  double start_time_ = 0, end_time_ = 0;
  Place start_{}, end_{}, bend_{};
  Cells near_{};
  Plane slope_{};              // through the south-west corner of those cells, at height 0; from there upwards:
  double room_ = 0;            // for nodes that the sphere does not touch [m]
  double slanting_reach_ = 0;  // the sphere's reach [m]
  double highest_ = infinite;  // of the nodes [m]
  static constexpr std::size_t most_facets = 32;
  std::array<Facet, most_facets> facet_;  // that the sphere may touch
  std::size_t facets_ = 0;
};

// As TriangleMesh::find_sharp_features, for one side.
bool RasterSurface::is_sharp_edge(FacetId facet, std::size_t side) const {
  const auto beyond = neighbours(facet)[side];
  if (!beyond) return true;
  const Triangle here = triangle(facet);
  const Vec3 n = area_normal(here).normalized();
  double lowest = 0, reach = 0;
  for (const Vec3& corner : triangle(*beyond)) {
    lowest = std::min(lowest, n.dot(corner - here[side]));
    reach = std::max(reach, (corner - here[side]).norm());
  }
  return lowest < -tolerance::sharp_bend * reach;
}

bool RasterSurface::is_sharp_vertex(const Vec3& vertex) const {
  bool sharp = false;
  visit_cells(cells_within(vertex.x(), vertex.x(), vertex.y(), vertex.y()), [&](FacetId facet, const Triangle& corner) {
    for (std::size_t c = 0; c < 3 && !sharp; ++c) {
      const bool ends_here = corner[c] == vertex || corner[next_corner[c]] == vertex;
      sharp = ends_here && is_sharp_edge(facet, c);
    }
  });
  return sharp;
}

auto RasterSurface::flight_of_sphere(const Parabola& path, double radius, double t_max, const SupportPlanes& left,
                                     double known) const -> Flight {
  // The centre may be beside the terrain.
  const auto across = static_cast<std::int64_t>(std::ceil((radius + box_pad) / grid_.dx));
  const auto along = static_cast<std::int64_t>(std::ceil((radius + box_pad) / grid_.dy));
  GridWalk at(path, t_max, grid_.x0 - static_cast<double>(across) * grid_.dx,
              grid_.y0 - static_cast<double>(along) * grid_.dy, grid_.dx, grid_.dy,
              static_cast<std::int64_t>(columns_) + 2 * across, static_cast<std::int64_t>(rows_) + 2 * along);
  SphereSearch search(*this, path, SpherePath::flight, radius, t_max, left);
  if (at.is_over()) return {std::nullopt, known};
  search.start_at(at.enter());
  constexpr int at_once = 4;  // cells, where it is well clear
  for (; !at.is_over() && at.enter() <= search.best().t; at.advance()) {
    if (search.seems_clear_at(at.leave())) {
      GridWalk ahead = at;
      for (int k = 1; k < at_once && !ahead.is_last(); ++k) ahead.advance();
      if (!ahead.is_over() && search.seems_clear_at(ahead.leave()) && search.skip_until(ahead.leave())) {
        at = ahead;
        continue;
      }
    }
    search.look_until(at.leave());
  }
  const auto contact = search.best().contact();
  if (contact && search.max_height() > known) known = max_height(path, contact->t, known);
  return {contact, known};
}

std::optional<Contact> RasterSurface::first_contact_on_leg(const Parabola& leg, double radius, double t_max,
                                                           const SupportPlanes& on) const {
  SphereSearch search(*this, leg, SpherePath::leg, radius, t_max, on);
  search.start_at(0);
  search.look_until(t_max);
  return search.best().contact();
}

}  // namespace talus
