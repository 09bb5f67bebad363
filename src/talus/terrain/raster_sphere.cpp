// How a sphere meets a raster. Its path is searched in parts, each over one cell, so that a contact found in one part
// comes before those in all later parts. In most parts the sphere is clear of all nodes around it; where it is well
// clear, one part covers several cells. In the others it meets faces first; the time of such a contact shortens the
// part in which sides and corners are tested.
//
// What follows from the ends of a part is used before any root is computed: a facet is out of reach if the sphere stays
// above its plane, and so are its sides and corners (raster_sphere_part.hpp, raster_sphere_sides.hpp).

#include <algorithm>
#include <cmath>

#include "talus/terrain/raster_sphere_part.hpp"
#include "talus/terrain/raster_sphere_sides.hpp"
#include "talus/terrain/raster_surface.hpp"

namespace talus {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

}  // namespace

class RasterSurface::SphereSearch {
 public:
  SphereSearch(const RasterSurface& surface, const Parabola& path, SpherePath kind, double radius, double t_max,
               const SupportPlanes& left)
      : surface_(surface), path_(path), kind_(kind), left_(left), part_(surface, path, radius), best_{t_max} {}

  /// The first contact in the parts so far.
  [[nodiscard]] const ContactCandidate& best() const { return best_; }
  /// A bound of the height of the centre above the ground in the parts so far [m].
  [[nodiscard]] double highest_bound() const { return highest_bound_; }

  /// The time at which the first part begins.
  void start_at(double t) { part_.start_at(t); }
  /// Whether the sphere would be well clear at a time if the ground continued as it is in the last part.
  [[nodiscard]] bool seems_clear_at(double t) const {
    const auto u = static_cast<double>(near_.first_column), v = static_cast<double>(near_.first_row);
    return SpherePart::height(part_.place(t), slope_, u, v) - slanting_reach_ - highest_ >
           0.25 * std::max(surface_.grid_.dx, surface_.grid_.dy);
  }
  /// Whether a part over several cells, up to a time, is clear of all nodes. If so, the next part begins there.
  bool skip_to(double leave) {
    begin_part(leave);
    if (is_clear()) return true;
    part_.start_at(part_.start_time());
    return false;
  }
  /// Searches the part up to a time; the next part begins there.
  void search_to(double leave) {
    begin_part(leave);
    if (is_clear()) return;
    const Cells cells = cells_below();
    for (std::int64_t row = cells.first_row; row <= cells.last_row; ++row) {
      for (std::int64_t column = cells.first_column; column <= cells.last_column; ++column) {
        const Cell here = part_.cell(column, row);
        if (is_clear_of(column, row, here) || (surface_.has_holes_ && !here.has_data())) continue;
        for (std::uint32_t half = 0; half < 2; ++half) {
          const Facet each = part_.facet(column, row, here, half);
          if (part_.is_above(each)) continue;
          if (facets_ == most_facets) meet_facets();
          facet_[facets_++] = each;
        }
      }
    }
    meet_facets();
  }

 private:
  using Facet = SpherePart::Facet;

  void begin_part(double leave) {
    part_.advance_to(leave);
    near_ = part_.cells_near();
  }

  // Those of the cells near where the sphere may touch anything. It touches the ground up the slope from its centre, at
  // an edge or a corner in a direction between those of the facets there.
  [[nodiscard]] Cells cells_below() const {
    if (!part_.is_inside(near_)) return near_;
    double u_least = infinite, u_most = -infinite, v_least = infinite, v_most = -infinite;  // of slopes along u and v
    const std::int64_t across = near_.last_column - near_.first_column + 1;
    const float* south = part_.node(near_.first_column, near_.first_row);
    for (std::int64_t row = near_.first_row; row <= near_.last_row + 1; ++row, south += surface_.grid_.columns) {
      for (std::int64_t k = 0; k < across; ++k) {
        const double rise = static_cast<double>(south[k + 1]) - south[k];
        u_least = std::min(u_least, rise);
        u_most = std::max(u_most, rise);
      }
      if (row > near_.last_row) break;
      for (std::int64_t k = 0; k <= across; ++k) {
        const double rise =
            static_cast<double>(south[k + static_cast<std::int64_t>(surface_.grid_.columns)]) - south[k];
        v_least = std::min(v_least, rise);
        v_most = std::max(v_most, rise);
      }
    }
    // The maximum of g / sqrt(1 + g^2 + h^2) for a slope up to g along one axis and from h_least to h_most along the
    // other.
    const auto most_up = [](double g, double h_least, double h_most) {
      const double h = (g > 0) == (std::abs(h_least) < std::abs(h_most)) ? h_least : h_most;
      return g / std::sqrt(1 + g * g + (g > 0 && h_least < 0 && h_most > 0 ? 0 : h * h));
    };
    const double u_scale = part_.u_scale(), v_scale = part_.v_scale();
    constexpr double slack = SpherePart::foot_slack;
    u_least *= u_scale, u_most *= u_scale, v_least *= v_scale, v_most *= v_scale;
    const double u = part_.radius() * u_scale, v = part_.radius() * v_scale;
    const Cells below = part_.cells_within(
        u * most_up(-u_least, v_least, v_most) + slack, u * most_up(u_most, v_least, v_most) + slack,
        v * most_up(-v_least, u_least, u_most) + slack, v * most_up(v_most, u_least, u_most) + slack);
    return {std::max(near_.first_column, below.first_column), std::min(near_.last_column, below.last_column),
            std::max(near_.first_row, below.first_row), std::min(near_.last_row, below.last_row)};
  }

  // ---- nodes ----

  // How high over the plane slope_ a node may be without being touched.
  [[nodiscard]] double room_over_slope() const {
    const auto u = static_cast<double>(near_.first_column), v = static_cast<double>(near_.first_row);
    return std::min(SpherePart::height(part_.start(), slope_, u, v), SpherePart::height(part_.end(), slope_, u, v)) -
           std::max(0.0, part_.sag(slope_)) - slanting_reach_;
  }
  // A bound of the height of the centre over the plane slope_.
  [[nodiscard]] double height_over_slope() const {
    const auto u = static_cast<double>(near_.first_column), v = static_cast<double>(near_.first_row);
    return std::max(SpherePart::height(part_.start(), slope_, u, v), SpherePart::height(part_.end(), slope_, u, v)) +
           std::abs(part_.sag(slope_)) + box_pad;
  }
  // Whether the sphere is out of reach of all nodes near it. The plane from which their heights are measured has the
  // mean slope of the ground there.
  [[nodiscard]] bool is_clear() {
    if (near_.first_column > near_.last_column || near_.first_row > near_.last_row) return true;
    const std::int64_t across = near_.last_column - near_.first_column + 1,
                       along = near_.last_row - near_.first_row + 1;
    const float *south = part_.node(near_.first_column, near_.first_row),
                *north = part_.node(near_.first_column, near_.last_row + 1);
    const double sw = south[0], se = south[across], nw = north[0], ne = north[across];
    slope_ = {0, 0.5 * (se - sw + ne - nw) / static_cast<double>(across),
              0.5 * (nw - sw + ne - se) / static_cast<double>(along)};
    slanting_reach_ = (part_.radius() + box_pad) * std::sqrt(part_.squared_slant(slope_));
    room_ = room_over_slope();
    highest_ = -infinite;
    double lowest = infinite;
    double rise = 0;
    for (std::int64_t row = 0; row <= along; ++row, south += surface_.grid_.columns, rise += slope_.along_v) {
      double there = rise;
      for (std::int64_t column = 0; column <= across; ++column, there += slope_.along_u) {
        const double over_slope = south[column] - there;
        highest_ = std::max(highest_, over_slope);
        lowest = std::min(lowest, over_slope);
      }
    }
    highest_bound_ = std::max(highest_bound_, height_over_slope() - lowest);
    return highest_ < room_;
  }
  // Whether it is out of reach of a cell's nodes. (False if one of them, or of those around, has no data.)
  [[nodiscard]] bool is_clear_of(std::int64_t column, std::int64_t row, const Cell& here) const {
    const double highest = std::max(std::max(here.sw, here.se - slope_.along_u),
                                    std::max(here.nw, here.ne - slope_.along_u) - slope_.along_v);
    return highest - slope_.along_u * static_cast<double>(column - near_.first_column) -
               slope_.along_v * static_cast<double>(row - near_.first_row) <
           room_;
  }

  // ---- facets ----

  [[nodiscard]] Triangle triangle(const Facet& facet) const {
    return surface_.triangle(facet.column, facet.row, kind_of(facet.cell, facet.half));
  }
  [[nodiscard]] FacetName name_of(const Facet& facet) const {
    const std::uint32_t number = surface_.facet_of(facet.column, facet.row, facet.half);
    return {number, number};
  }

  // Lets the sphere meet the facets of the list, and empties it. A contact with a face shortens the part.
  void meet_facets() {
    const double radius = part_.radius();
    for (std::size_t k = 0; k < facets_; ++k) {
      if (!part_.may_touch_face(facet_[k])) continue;
      const Triangle corner = triangle(facet_[k]);
      meet_face(path_, radius, corner, SphereOverFacet(path_, radius, corner), name_of(facet_[k]), left_, best_);
    }
    const std::size_t count = std::exchange(facets_, 0);
    if (best_.t < part_.start_time()) return;
    const bool is_shorter = best_.t < part_.end_time();
    if (is_shorter) part_.end_at(best_.t);
    const SphereSides sides(surface_, part_);
    for (std::size_t k = 0; k < count; ++k) {
      Facet& facet = facet_[k];
      if (is_shorter) {
        part_.update_end(facet);
        if (part_.is_above(facet)) continue;
      }
      const std::uint32_t to_test = sides.to_test(facet);
      if (to_test == 0) continue;
      const FacetName name = name_of(facet);
      const auto sharp = [&](std::size_t what, double t) {
        return t < 0 ? (to_test & (1U << what)) != 0 : is_sharp(FacetId{name.facet}, what);
      };
      meet_sides(path_, kind_, radius, {part_.start_time(), part_.end_time()}, triangle(facet), name, left_, sharp,
                 best_);
    }
  }
  [[nodiscard]] bool is_sharp(FacetId facet, std::size_t what) const {
    return what < 3 ? surface_.is_sharp_edge(facet, what)
                    : surface_.is_sharp_vertex(surface_.triangle(facet)[what - 3]);
  }

  const RasterSurface& surface_;
  const Parabola& path_;
  const SpherePath kind_;
  const SupportPlanes& left_;
  SpherePart part_;
  ContactCandidate best_;
  double highest_bound_ = 0;
  // In the present part:
  Cells near_{};
  Plane slope_{};              // through the south-west corner of those cells, at height 0; over it are measured
  double room_ = 0;            // the height up to which a node is not touched [m]
  double slanting_reach_ = 0;  // the sphere's reach [m]
  double highest_ = infinite;  // the highest node [m]
  static constexpr std::size_t most_facets = 32;
  std::array<Facet, most_facets> facet_;  // that the sphere may touch
  std::size_t facets_ = 0;
};

// For one side, by the same test as TriangleMesh::find_sharp_features.
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
  // The centre may be off the terrain.
  const auto across = static_cast<std::int64_t>(std::ceil((radius + box_pad) / grid_.dx));
  const auto along = static_cast<std::int64_t>(std::ceil((radius + box_pad) / grid_.dy));
  // In every part all cells within the radius are near. Among cells much smaller than the sphere, a part is therefore
  // as long as many cells: their number, and not its square, determines the work for one radius of the path.
  constexpr double parts_per_radius = 8;
  const auto side = static_cast<std::int64_t>(std::max(1.0, radius / (parts_per_radius * std::max(grid_.dx, grid_.dy))));
  const auto parts = [&](std::size_t cells, std::int64_t around) {
    return (static_cast<std::int64_t>(cells) + 2 * around + side - 1) / side;
  };
  const auto length = static_cast<double>(side);
  GridWalk at(path, t_max, grid_.x0 - static_cast<double>(across) * grid_.dx,
              grid_.y0 - static_cast<double>(along) * grid_.dy, length * grid_.dx, length * grid_.dy,
              parts(columns_, across), parts(rows_, along));
  SphereSearch search(*this, path, SpherePath::flight, radius, t_max, left);
  if (at.is_over()) return {std::nullopt, known};
  search.start_at(at.enter());
  constexpr int at_once = 4;  // cells per part, where the sphere is well clear
  for (; !at.is_over() && at.enter() <= search.best().t; at.advance()) {
    if (search.seems_clear_at(at.leave())) {
      GridWalk ahead = at;
      for (int k = 1; k < at_once && !ahead.is_last(); ++k) ahead.advance();
      if (!ahead.is_over() && search.seems_clear_at(ahead.leave()) && search.skip_to(ahead.leave())) {
        at = ahead;
        continue;
      }
    }
    search.search_to(at.leave());
  }
  const auto contact = search.best().contact();
  if (contact && search.highest_bound() > known) known = max_height(path, contact->t, known);
  return {contact, known};
}

std::optional<Contact> RasterSurface::first_contact_on_leg(const Parabola& leg, double radius, double t_max,
                                                           const SupportPlanes& on) const {
  SphereSearch search(*this, leg, SpherePath::leg, radius, t_max, on);
  search.start_at(0);
  search.search_to(t_max);
  return search.best().contact();
}

}  // namespace talus
