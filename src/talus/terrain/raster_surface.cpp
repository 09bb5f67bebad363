#include "talus/terrain/raster_surface.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "talus/core/check.hpp"
#include "talus/terrain/cell_diagonal.hpp"
#include "talus/terrain/surface.hpp"

namespace talus {

static_assert(TerrainSurface<RasterSurface>);

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// The highest point of a flight.
struct Top {
  double t, z;
  /// The maximum z of a part of it, given its ends.
  [[nodiscard]] double between(double t0, double z0, double t1, double z1) const {
    return t > t0 && t < t1 ? z : std::max(z0, z1);
  }
};
Top top_of(const Parabola& path) {
  if (!(path.a.z() < 0)) return {-infinite, 0};
  const double t = -path.v.z() / path.a.z();
  return {t, path.z(t)};
}

// The cut of a cell cannot be predicted, and a mispredicted branch costs more than the rest of a facet: a table
// instead. Rows are 2 (cut from south-west to north-east) + half; nodes are 0 south-west, 1 south-east, 2 north-west, 3
// north-east.
constexpr std::array<std::array<std::uint8_t, 3>, 4> nodes_of{{{0, 1, 2}, {1, 3, 2}, {0, 1, 3}, {0, 3, 2}}};

/// The sides of a facet that are to its south or north, to its east or west, and on the diagonal.
struct Sides {
  std::uint8_t along, aside, diagonal;
};
constexpr std::array<Sides, 4> sides_of{{{0, 2, 1}, {1, 0, 2}, {0, 1, 2}, {1, 2, 0}}};

}  // namespace

RasterSurface::RasterSurface(RasterGrid grid) : grid_(std::move(grid)) {
  TALUS_PROMISE(grid_.columns >= 2 && grid_.rows >= 2, "a surface needs a cell");
  TALUS_PROMISE(grid_.z.size() == static_cast<std::size_t>(grid_.columns) * grid_.rows, "every node has its z");
  columns_ = grid_.columns - 1;
  rows_ = grid_.rows - 1;
  float low = std::numeric_limits<float>::infinity(), high = -low;
  for (const float z : grid_.z) {
    if (std::isnan(z)) {
      has_holes_ = true;
      continue;
    }
    low = std::min(low, z);
    high = std::max(high, z);
  }
  bounds_.low = {grid_.x0, grid_.y0, low};
  bounds_.high = {grid_.x0 + static_cast<double>(columns_) * grid_.dx, grid_.y0 + static_cast<double>(rows_) * grid_.dy,
                  high};
  choose_cuts();
  slant_ = steepest_slant(grid_);
}

void RasterSurface::choose_cuts() {
  cuts_.resize(grid_.z.size() / 64 + 1);
  const auto z = [&](std::uint32_t column, std::uint32_t row) { return double{grid_.z[grid_.index(column, row)]}; };
  const auto across = static_cast<std::ptrdiff_t>(grid_.columns);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, cuts_.size(), 1024), [&](const auto& words) {
    auto row = static_cast<std::uint32_t>(64 * words.begin() / grid_.columns);
    auto column = static_cast<std::uint32_t>(64 * words.begin() % grid_.columns);
    for (std::size_t word = words.begin(); word < words.end(); ++word) {
      std::uint64_t bits = 0;
      for (std::size_t k = 0; k < 64 && row < rows_; ++k) {
        if (column < columns_) {
          const bool is_inner = row > 0 && row + 1 < rows_ && column > 0 && column + 1 < columns_;
          const float* const south_west = grid_.z.data() + 64 * word + k;
          bits |=
              std::uint64_t{is_inner
                                ? is_edge_north_east([=](int i, int j) { return double{south_west[j * across + i]}; })
                                : is_edge_north_east(z, grid_.columns, grid_.rows, column, row)}
              << k;
        }
        if (++column == grid_.columns) column = 0, ++row;
      }
      cuts_[word] = bits;
    }
  });
}

bool RasterSurface::has_data(std::size_t column, std::size_t row) const { return cell(column, row).has_data(); }

Triangle RasterSurface::triangle(std::int64_t column, std::int64_t row, std::size_t kind) const {
  const double west = grid_.x0 + static_cast<double>(column) * grid_.dx;
  const double south = grid_.y0 + static_cast<double>(row) * grid_.dy;
  const double x[] = {west, west + grid_.dx}, y[] = {south, south + grid_.dy};
  const float* const z = grid_.z.data() + static_cast<std::size_t>(row) * (columns_ + 1) + column;
  Triangle triangle;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t node = nodes_of[kind][k];
    triangle[k] = {x[node % 2], y[node / 2], z[(node / 2) * (columns_ + 1) + node % 2]};
  }
  return triangle;
}

std::array<Triangle, 2> RasterSurface::triangles(std::int64_t column, std::int64_t row, const Cell& cell) const {
  return {triangle(column, row, kind_of(cell, 0)), triangle(column, row, kind_of(cell, 1))};
}

Triangle RasterSurface::triangle(FacetId facet) const {
  const auto [column, row] = place(facet);
  return triangle(column, row,
                  kind_of(cell(static_cast<std::size_t>(column), static_cast<std::size_t>(row)), facet.index % 2));
}

RasterSurface::Cells RasterSurface::cells_within(double x_low, double x_high, double y_low, double y_high) const {
  const auto cells = [](double low, double high, double size, std::size_t count) {
    const double last = static_cast<double>(count) - 1;
    // A place on a border belongs to the cells on both sides.
    return std::pair{static_cast<std::int64_t>(std::clamp(std::ceil((low - box_pad) / size) - 1, 0.0, last + 1)),
                     static_cast<std::int64_t>(std::clamp(std::floor((high + box_pad) / size), -1.0, last))};
  };
  const auto [first_column, last_column] = cells(x_low - grid_.x0, x_high - grid_.x0, grid_.dx, columns_);
  const auto [first_row, last_row] = cells(y_low - grid_.y0, y_high - grid_.y0, grid_.dy, rows_);
  return {first_column, last_column, first_row, last_row};
}

// ---- neighbours of a facet ----

std::array<std::optional<FacetId>, 3> RasterSurface::neighbours(FacetId facet) const {
  const auto [column, row] = place(facet);
  const std::uint32_t half = facet.index % 2;
  const std::size_t kind = kind_of(cell(static_cast<std::size_t>(column), static_cast<std::size_t>(row)), half);
  const bool goes_east = (kind == 2) | (kind == 1);
  const auto is_there = [&](std::int64_t i, std::int64_t j) {
    return i >= 0 && j >= 0 && i < static_cast<std::int64_t>(columns_) && j < static_cast<std::int64_t>(rows_) &&
           (!has_holes_ || has_data(static_cast<std::size_t>(i), static_cast<std::size_t>(j)));
  };
  std::array<std::optional<FacetId>, 3> beyond;
  beyond[sides_of[kind].diagonal] = FacetId{facet.index ^ 1U};
  if (const std::int64_t next = row + 2 * std::int64_t{half} - 1; is_there(column, next)) {
    beyond[sides_of[kind].along] = FacetId{facet_of(column, next, 1 - half)};
  }
  if (const std::int64_t next = column + 2 * std::int64_t{goes_east} - 1; is_there(next, row)) {
    const bool north_east = is_cut_north_east(static_cast<std::size_t>(next), static_cast<std::size_t>(row));
    beyond[sides_of[kind].aside] = FacetId{facet_of(next, row, goes_east == north_east ? 1 : 0)};
  }
  return beyond;
}

Outline RasterSurface::outline(FacetId facet) const {
  const Triangle corner = triangle(facet);
  const auto beyond = neighbours(facet);
  Outline outline;
  outline.point = corner[0];
  outline.normal = area_normal(corner).normalized();
  outline.edge_count = 3;
  for (std::size_t c = 0; c < 3; ++c) {
    OutlineEdge& edge = outline.edges[c];
    edge.point = corner[c];
    edge.inward = outline.normal.cross(corner[next_corner[c]] - corner[c]).normalized();
    edge.beyond = beyond[c];
  }
  return outline;
}

// ---- ridges ----

std::array<Vec3, 2> RasterSurface::beside(const Ridge& ridge) const {
  const Triangle here = triangle(ridge.facet);
  const auto beyond = neighbours(ridge.facet)[ridge.side];
  return {far_corner(here, ridge), far_corner(beyond ? triangle(*beyond) : here, ridge)};
}

// ---- contacts ----

std::optional<Contact> RasterSurface::first_contact(const Parabola& path, double radius, double t_max,
                                                    const SupportPlanes& left) const {
  return flight(path, radius, t_max, left, infinite).contact;
}

// The height of a flight over a facet is a concave function of time: a point that is above the facet where it arrives
// over it and where it leaves is above it in between. So the heights over the crossed borders and diagonals show which
// facets must be tested, and few must.
auto RasterSurface::flight_of_point(const Parabola& path, double t_max, const SupportPlanes& left, double known) const
    -> Flight {
  ContactCandidate best{t_max};
  GridWalk at = walk(path, t_max);
  if (at.is_over()) return {best.contact(), known};
  const Top top = top_of(path);
  double z0 = path.z(at.enter());
  double height_entering = 0;  // the first cell is always tested
  for (; !at.is_over() && at.enter() <= best.t; at.advance()) {
    const double t1 = at.leave(), z1 = path.z(t1);
    const auto [low, high] = range_at(at.node());
    const bool may_be_higher = top.between(at.enter(), z0, t1, z1) - low > known;
    // Most flights are entirely above most cells.
    const double lowest = std::min(std::exchange(z0, z1), z1);
    if (lowest > high + box_pad) {
      height_entering = infinite;
    } else {
      const auto [leaving, over_diagonal] = heights_over_lines(path, at);
      // (Written so that NaN, next to a hole, is tested.)
      const bool is_clear = height_entering > box_pad && leaving > box_pad && over_diagonal > box_pad;
      if (!is_clear) meet_in_cell(path, at, left, best);
      height_entering = leaving;
    }
    if (may_be_higher) known = max_height_in_cell(path, at, at.enter(), std::min(t1, best.t), known);
  }
  return {best.contact(), known};
}

auto RasterSurface::heights_over_lines(const Parabola& path, const GridWalk& at) const -> HeightsOverLines {
  const double t0 = at.enter(), t1 = at.leave();
  const double u0 = at.u(t0), v0 = at.v(t0), u1 = at.u(t1), v1 = at.v(t1);
  const Cell here = cell_at(at.node());

  // The border's nodes are found without branches: which border it crosses cannot be predicted.
  const std::size_t stride = columns_ + 1, east = at.goes_east() ? 1 : 0, north = at.goes_north() ? stride : 0;
  const bool along_x = at.leaves_along_x();
  const float* const border = grid_.z.data() + at.node() + (along_x ? east : north);
  const double border_from = border[0], border_to = border[along_x ? stride : 1];
  const double ground = border_from + (along_x ? v1 : u1) * (border_to - border_from);
  const double leaving = at.is_last() ? 0 : path.z(t1) - ground;

  const bool north_east = here.is_cut_north_east;
  const double side0 = here.side_of_diagonal(u0, v0), side1 = here.side_of_diagonal(u1, v1);
  if (!(side0 * side1 < 0)) return {leaving, infinite};
  const double part = side0 / (side0 - side1), u = u0 + part * (u1 - u0);
  const double from = north_east ? here.sw : here.nw, to = north_east ? here.ne : here.se;
  return {leaving, path.z(t0 + part * (t1 - t0)) - (from + u * (to - from))};
}

/// Tests the facets of a cell that a flight may touch while it is over the cell.
void RasterSurface::meet_in_cell(const Parabola& path, const GridWalk& at, const SupportPlanes& left,
                                 ContactCandidate& best) const {
  const Cell here = cell_at(at.node());
  if (!here.has_data()) return;
  // A distance from the diagonal, in cells, beyond a facet's slack (outline_slack) for any cell size.
  const double margin = 1e-4 + tolerance::widest_slack / std::min(grid_.dx, grid_.dy);
  const double t0 = at.enter(), t1 = at.leave();
  const double u0 = at.u(t0), v0 = at.v(t0), u1 = at.u(t1), v1 = at.v(t1);
  // The distance from the diagonal on plan, into the first facet: 1 at its far corner.
  const double toward = here.is_cut_north_east ? 1 : -1;
  const double side0 = toward * here.side_of_diagonal(u0, v0), side1 = toward * here.side_of_diagonal(u1, v1);
  const auto may_touch = [&](std::uint32_t half) {
    if ((half == 0 ? std::max(side0, side1) : std::max(-side0, -side1)) < -margin) return false;
    const auto [z, along_u, along_v, corner] = here.plane(half);
    const auto height = [&, z = z, along_u = along_u, along_v = along_v, corner = corner](double t, double u,
                                                                                          double v) {
      return path.z(t) - (z + (u - corner) * along_u + (v - corner) * along_v);
    };
    // A flight that ends above the plane is above it all the time if it starts above it, or rises from it at first.
    if (!(height(t1, u1, v1) > box_pad)) return true;
    const double rise = path.v.z() + t0 * path.a.z() - along_u * at.u_speed() - along_v * at.v_speed();
    return !(rise > 0 || height(t0, u0, v0) > box_pad);
  };
  const std::uint32_t entered = side0 > 0 ? 0 : 1;
  for (const std::uint32_t half : {entered, 1 - entered}) {
    if (half != entered && best.found()) {
      // It reaches this facet after its contact with the other one.
      const double side = side0 + (best.t - t0) / (t1 - t0) * (side1 - side0);
      if ((entered == 0 ? side : -side) > margin) break;
    }
    if (!may_touch(half)) continue;
    const std::uint32_t facet = facet_of(at.column(), at.row(), half);
    meet_point(path, triangle(at.column(), at.row(), kind_of(here, half)), {facet, facet}, left, best);
  }
}

// ---- where a flight without contact leaves the model ----

Exit RasterSurface::exit(const Parabola& path) const {
  GridWalk at = walk(path, infinite);
  if (at.is_over()) return {0, false, false};  // not over the grid
  const auto is_above = [&](double t, std::int64_t column, std::int64_t row) {
    const Vec3 q = path.at(t);
    const auto ground = height_in_cell(q.x(), q.y(), column, row);
    return ground && q.z() >= *ground - box_pad;
  };
  const auto start = elevation(path.p.x(), path.p.y());
  std::optional<Exit> left;  // where it last left the terrain
  if (!start || path.p.z() >= *start - box_pad) left = Exit{0, false, true};
  bool is_over_ground = false;
  std::int64_t column = at.column(), row = at.row();
  for (; !at.is_over(); at.advance()) {
    const bool ground_here = has_data(static_cast<std::size_t>(at.column()), static_cast<std::size_t>(at.row()));
    if (ground_here && !is_over_ground && left) {
      if (!is_above(at.enter(), at.column(), at.row())) return *left;  // it fell into the hole
      left.reset();
    } else if (!ground_here && is_over_ground && is_above(at.enter(), column, row)) {
      left = Exit{at.enter(), false, true};
    }
    is_over_ground = ground_here;
    column = at.column();
    row = at.row();
    if (at.is_last() && ground_here && std::isfinite(at.leave()) && is_above(at.leave(), column, row)) {
      return {at.leave(), false, false};
    }
  }
  if (left) return *left;
  // It never crossed the rim: it fell through.
  const auto t = falling_root(path.p.z() - bounds_.low.z(), path.v.z(), path.a.z(), 1e300);
  return {t.value_or(0), true, false};
}

// ---- heights ----

std::optional<double> RasterSurface::height_in_cell(double x, double y, std::int64_t column, std::int64_t row) const {
  const Cell here = cell(static_cast<std::size_t>(column), static_cast<std::size_t>(row));
  if (!here.has_data()) return std::nullopt;
  return here.ground((x - grid_.x0) / grid_.dx - static_cast<double>(column),
                     (y - grid_.y0) / grid_.dy - static_cast<double>(row));
}

std::optional<double> RasterSurface::elevation(double x, double y, double below) const {
  // Without holes, a place within the grid has the elevation of any cell that it is in.
  const double u = (x - grid_.x0) / grid_.dx, v = (y - grid_.y0) / grid_.dy;
  if (!has_holes_ && u > 0 && v > 0 && u < static_cast<double>(columns_) && v < static_cast<double>(rows_)) {
    const auto column = static_cast<std::size_t>(u), row = static_cast<std::size_t>(v);
    const double z = cell(column, row).ground(u - static_cast<double>(column), v - static_cast<double>(row));
    return z <= below ? std::optional(z) : std::nullopt;
  }
  const Cells cells = cells_within(x, x, y, y);
  std::optional<double> highest;
  for (std::int64_t row = cells.first_row; row <= cells.last_row; ++row) {
    for (std::int64_t column = cells.first_column; column <= cells.last_column; ++column) {
      const double west = grid_.x0 + static_cast<double>(column) * grid_.dx;
      const double south = grid_.y0 + static_cast<double>(row) * grid_.dy;
      if (x < west - contact_slack || x > west + grid_.dx + contact_slack) continue;
      if (y < south - contact_slack || y > south + grid_.dy + contact_slack) continue;
      const auto z = height_in_cell(x, y, column, row);
      if (z && *z <= below) highest = std::max(highest.value_or(*z), *z);
    }
  }
  return highest;
}

auto RasterSurface::plane_over(std::size_t south_west, std::size_t across, std::size_t along) const -> Plane {
  const float* south = grid_.z.data() + south_west;
  const float* const north = south + along * (columns_ + 1);
  const double sw = south[0], se = south[across], nw = north[0], ne = north[across];
  Plane plane{-infinite, 0.5 * (se - sw + ne - nw) / static_cast<double>(across),
              0.5 * (nw - sw + ne - se) / static_cast<double>(along)};
  double rise = 0;
  for (std::size_t row = 0; row <= along; ++row, south += columns_ + 1, rise += plane.along_v) {
    double there = rise;
    for (std::size_t column = 0; column <= across; ++column, there += plane.along_u) {
      plane.z = std::max(plane.z, south[column] - there);
    }
  }
  return plane;
}

std::optional<GroundBelow> RasterSurface::ground_below(const Vec3& place) const {
  const double x = (place.x() - grid_.x0) / grid_.dx, y = (place.y() - grid_.y0) / grid_.dy;
  if (!(x >= 0 && y >= 0 && x <= static_cast<double>(columns_) && y <= static_cast<double>(rows_))) return std::nullopt;
  const auto column = std::min(static_cast<std::int64_t>(x), static_cast<std::int64_t>(columns_) - 1);
  const auto row = std::min(static_cast<std::int64_t>(y), static_cast<std::int64_t>(rows_) - 1);
  const auto z = height_in_cell(place.x(), place.y(), column, row);
  if (!z || *z > place.z() + contact_slack) return std::nullopt;
  const double u = x - static_cast<double>(column), v = y - static_cast<double>(row);
  const bool north_east = is_cut_north_east(static_cast<std::size_t>(column), static_cast<std::size_t>(row));
  const bool is_first = north_east ? u >= v : u + v <= 1;
  return GroundBelow{*z, FacetId{facet_of(column, row, is_first ? 0 : 1)}};
}

std::optional<double> RasterSurface::ground_over(const Vec3& place) const {
  const auto z = elevation(place.x(), place.y());
  return z && *z > place.z() + contact_slack ? z : std::nullopt;
}

double RasterSurface::max_height(const Parabola& path, double t_end, double known) const {
  const Top top = top_of(path);
  GridWalk at = walk(path, t_end);
  double z0 = at.is_over() ? 0 : path.z(at.enter());
  for (; !at.is_over(); at.advance()) {
    const double t0 = at.enter(), t1 = at.leave(), z1 = path.z(t1);
    // An upper bound: the flight's highest point over this cell, above the cell's lowest node.
    const double highest = top.between(t0, std::exchange(z0, z1), t1, z1);
    if (highest - range_at(at.node()).first > known) known = max_height_in_cell(path, at, t0, t1, known);
  }
  return known;
}

void RasterSurface::max_heights(const Parabola& path, std::span<const double> borders,
                                std::span<double> heights) const {
  std::fill(heights.begin(), heights.end(), 0);
  std::size_t k = 0;
  for (GridWalk at = walk(path, borders.back()); !at.is_over(); at.advance()) {
    for (;; ++k) {
      const double from = std::max(at.enter(), borders[k]), to = std::min(at.leave(), borders[k + 1]);
      if (from < to || borders[k] == borders[k + 1]) heights[k] = max_height_in_cell(path, at, from, to, heights[k]);
      if (borders[k + 1] >= at.leave() || k + 1 == heights.size()) break;
    }
  }
}

/// Over one cell, between two times at which the flight is over it.
double RasterSurface::max_height_in_cell(const Parabola& path, const GridWalk& at, double from, double to,
                                         double known) const {
  const Cell here = cell_at(at.node());
  if (!here.has_data()) return known;
  const double t0 = from, t1 = std::max(t0, to);
  const double side0 = here.side_of_diagonal(at.u(t0), at.v(t0)), side1 = here.side_of_diagonal(at.u(t1), at.v(t1));
  // The height over a plane has its maximum where the flight is as steep as the plane.
  const auto highest_over = [&](double side, double begin, double end) {
    const Plane plane = here.plane((side > 0) == here.is_cut_north_east ? 0 : 1);
    const double rise = plane.along_u * at.u_speed() + plane.along_v * at.v_speed();
    const double t = path.a.z() < 0      ? std::clamp((rise - path.v.z()) / path.a.z(), begin, end)
                     : path.v.z() > rise ? end
                                         : begin;
    return path.z(t) - plane.z - (at.u(t) - plane.corner) * plane.along_u - (at.v(t) - plane.corner) * plane.along_v;
  };
  if (!(side0 * side1 < 0)) return std::max(known, highest_over(side0 + side1, t0, t1));
  const double cut = t0 + side0 / (side0 - side1) * (t1 - t0);
  return std::max({known, highest_over(side0, t0, cut), highest_over(side1, cut, t1)});
}

std::vector<Vec3> RasterSurface::draped(const Vec2& from, const Vec2& to) const {
  const Parabola line{{from.x(), from.y(), 0}, {to.x() - from.x(), to.y() - from.y(), 0}, Vec3{}};
  std::vector<Vec3> points;
  double previous = -1;
  const auto put = [&](double s) {
    if (s - previous < 1e-9) return;
    const Vec3 q = line.at(s);
    const auto z = elevation(q.x(), q.y());
    if (!z) return;
    previous = s;
    points.emplace_back(q.x(), q.y(), *z);
  };
  for (GridWalk at = walk(line, 1); !at.is_over(); at.advance()) {
    const Cell here = cell(static_cast<std::size_t>(at.column()), static_cast<std::size_t>(at.row()));
    if (!here.has_data()) continue;
    const double s0 = at.enter(), s1 = at.leave();
    put(s0);
    const bool north_east = here.is_cut_north_east;
    const double side0 = north_east ? at.u(s0) - at.v(s0) : at.u(s0) + at.v(s0) - 1;
    const double side1 = north_east ? at.u(s1) - at.v(s1) : at.u(s1) + at.v(s1) - 1;
    if (side0 * side1 < 0) put(s0 + side0 / (side0 - side1) * (s1 - s0));
    put(s1);
  }
  return points;
}

}  // namespace talus
