#include "talus/terrain/triangle_mesh.hpp"

#include <algorithm>

#include "talus/core/check.hpp"
#include "talus/core/stop.hpp"
#include "talus/terrain/height_in_sight.hpp"
#include "talus/terrain/leaning_bounds.hpp"
#include "talus/terrain/surface.hpp"

namespace talus {

static_assert(TerrainSurface<TriangleMesh>);

namespace {

// When a point that moves from `from` at `velocity` on plan is over a triangle, or within the slack of it, in [0,
// t_end].
TimeWindow time_over(const Triangle& corner, const Vec2& from, const Vec2& velocity, double t_end, double slack = 0) {
  TimeWindow over{0, t_end};
  const double turn = area_normal(corner).z() > 0 ? 1 : -1;
  for (std::size_t c = 0; c < 3 && !over.is_empty(); ++c) {
    const Vec3 along = turn * (corner[next_corner[c]] - corner[c]);
    const double inside = along.x() * (from.y() - corner[c].y()) - along.y() * (from.x() - corner[c].x()) +
                          slack * (std::abs(along.x()) + std::abs(along.y()));
    const double rate = along.x() * velocity.y() - along.y() * velocity.x();
    if (rate > 0) {
      over.enter = std::max(over.enter, -inside / rate);
    } else if (rate < 0) {
      over.leave = std::min(over.leave, -inside / rate);
    } else if (inside < 0) {
      over.leave = -1;
    }
  }
  return over;
}

// A flight over a triangle that faces up, in [0, t_end].
OverPlane over_facet(const Triangle& corner, const Vec3& area_normal, const Parabola& path, double t_end,
                     double slack = 0) {
  return {time_over(corner, path.p.xy(), path.v.xy(), t_end, slack),
          area_normal.dot(path.p - corner[0]) / area_normal.z(), area_normal.dot(path.v) / area_normal.z()};
}

}  // namespace

TriangleMesh::TriangleMesh(std::span<const Vec3> vertices, std::span<const Corners> triangles,
                           std::span<const Corners> neighbours) {
  TALUS_PROMISE(triangles.size() == neighbours.size(), "every triangle has its neighbours");
  std::vector<Box> boxes(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (const std::uint32_t v : triangles[i]) boxes[i].grow(vertices[v]);
    bounds_.grow(boxes[i]);
  }
  bvh_ = Bvh(boxes);
  std::vector<std::uint32_t> place(triangles.size());
  for (std::uint32_t k = 0; k < place.size(); ++k) place[bvh_.order()[k]] = k;

  facets_.resize(triangles.size());
  for (std::size_t k = 0; k < facets_.size(); ++k) {
    stop_point(k);
    const std::uint32_t source = bvh_.order()[k];
    Facet& facet = facets_[k];
    facet.source = source;
    facet.sharp = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      facet.corner[c] = vertices[triangles[source][c]];
      const std::uint32_t beyond = neighbours[source][c];
      facet.neighbour[c] = beyond == no_neighbour ? no_neighbour : place[beyond];
    }
    const double upwards = normal({static_cast<std::uint32_t>(k)}).z();
    if (upwards <= 0) is_height_field_ = false;
    if (upwards > 0) slant_ = std::max(slant_, 1 / upwards);
  }
  find_sharp_features(triangles);
  add_leaning_bounds(bvh_, [&](std::uint32_t facet) -> const Triangle& { return facets_[facet].corner; });
}

void TriangleMesh::find_sharp_features(std::span<const Corners> triangles) {
  std::uint32_t vertex_count = 0;
  for (const Corners& corners : triangles) {
    for (const std::uint32_t v : corners) vertex_count = std::max(vertex_count, v + 1);
  }
  std::vector<bool> sharp_vertex(vertex_count, false);
  for (Facet& facet : facets_) {
    const Vec3 n = (facet.corner[1] - facet.corner[0]).cross(facet.corner[2] - facet.corner[0]).normalized();
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t beyond = facet.neighbour[c];
      bool sharp = beyond == no_neighbour;
      bool owned = true;
      if (!sharp) {
        // Convex where the neighbour's far corner lies below this facet's plane.
        const Facet& other = facets_[beyond];
        double lowest = 0, reach = 0;
        for (const Vec3& corner : other.corner) {
          lowest = std::min(lowest, n.dot(corner - facet.corner[c]));
          reach = std::max(reach, (corner - facet.corner[c]).norm());
        }
        sharp = lowest < -tolerance::sharp_bend * reach;
        owned = facet.source < other.source;
      }
      if (!sharp) continue;
      if (owned) facet.sharp |= 1U << c;
      sharp_vertex[triangles[facet.source][c]] = true;
      sharp_vertex[triangles[facet.source][next_corner[c]]] = true;
    }
  }
  for (Facet& facet : facets_) {
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t v = triangles[facet.source][c];
      if (!sharp_vertex[v]) continue;
      sharp_vertex[v] = false;  // taken by this facet
      facet.sharp |= 8U << c;
    }
  }
}

std::size_t TriangleMesh::bytes() const { return facets_.size() * sizeof(Facet) + bvh_.bytes(); }

Vec3 TriangleMesh::normal(FacetId facet) const {
  const auto& corner = facets_[facet.index].corner;
  return (corner[1] - corner[0]).cross(corner[2] - corner[0]).normalized();
}

Outline TriangleMesh::outline(FacetId id) const {
  const Facet& facet = facets_[id.index];
  Outline outline;
  outline.point = facet.corner[0];
  outline.normal = normal(id);
  outline.edge_count = 3;
  for (std::size_t c = 0; c < 3; ++c) {
    OutlineEdge& edge = outline.edges[c];
    edge.point = facet.corner[c];
    edge.inward = outline.normal.cross(facet.corner[next_corner[c]] - facet.corner[c]).normalized();
    if (facet.neighbour[c] != no_neighbour) edge.beyond = FacetId{facet.neighbour[c]};
  }
  return outline;
}

template <class EachFacet>
std::optional<Contact> TriangleMesh::search_flight(const Parabola& path, double radius, double t_max,
                                                   const SupportPlanes& left, EachFacet&& each_facet) const {
  ContactCandidate best{t_max};
  const auto fetch_facets = [&](std::uint32_t first, std::uint32_t last) {
    for (std::uint32_t k = first; k < last; ++k) fetch_soon(facets_[k].corner);
  };
  if (radius == 0) {
    bvh_.visit_flight(
        path, box_pad, best.t,
        [&](std::uint32_t first, std::uint32_t last, double&) {
          for (std::uint32_t k = first; k < last; ++k) {
            each_facet();
            meet_point(path, facets_[k].corner, {k, facets_[k].source}, left, best);
          }
        },
        fetch_facets);
    return best.contact();
  }
  const FlightSlabs slabs(path);
  bvh_.visit_flight(
      path, radius + box_pad, best.t,
      [&](std::uint32_t first, std::uint32_t last, double&) {
        for (std::uint32_t k = first; k < last; ++k) {
          const Triangle& corner = facets_[k].corner;
          const Box box{corner[0].min(corner[1]).min(corner[2]), corner[0].max(corner[1]).max(corner[2])};
          const TimeWindow window = slabs.window(box, radius + box_pad, best.t);
          if (window.is_empty()) continue;
          each_facet();
          meet_sphere(path, SpherePath::flight, radius, window, corner, {k, facets_[k].source}, left, sharp_of(k),
                      best);
        }
      },
      fetch_facets);
  return best.contact();
}

std::optional<Contact> TriangleMesh::first_contact(const Parabola& path, double radius, double t_max,
                                                   const SupportPlanes& left) const {
  return search_flight(path, radius, t_max, left, [] {});
}

std::uint32_t TriangleMesh::facets_tested(const Parabola& path, double radius, double t_max) const {
  std::uint32_t count = 0;
  (void)search_flight(path, radius, t_max, {}, [&] { ++count; });
  return count;
}

std::optional<Contact> TriangleMesh::first_contact_on_leg(const Parabola& leg, double radius, double t_max,
                                                          const SupportPlanes& on) const {
  ContactCandidate best{t_max};
  const Box swept = swept_box(leg, t_max, radius + box_pad);
  bvh_.visit_box(swept.low, swept.high, [&](std::uint32_t first, std::uint32_t last) {
    for (std::uint32_t k = first; k < last; ++k) {
      meet_sphere(leg, SpherePath::leg, radius, {0, t_max}, facets_[k].corner, {k, facets_[k].source}, on, sharp_of(k),
                  best);
    }
  });
  return best.contact();
}

template <class Visit>
void TriangleMesh::visit_under_among(std::uint32_t first, std::uint32_t last, const Parabola& path, double t_end,
                                     double slack, Visit&& visit) const {
  for (std::uint32_t k = first; k < last; ++k) {
    const Vec3 n = area_normal(facets_[k].corner);
    if (n.z() <= 0) continue;
    const OverPlane over = over_facet(facets_[k].corner, n, path, t_end, slack);
    if (!over.window.is_empty()) visit(over, k);
  }
}

template <class Visit>
void TriangleMesh::visit_under(const Parabola& path, double t_end, double slack, Visit&& visit) const {
  static constexpr double any = -1e300;
  bvh_.visit_under(
      path, t_end, [] { return any; },
      [&](std::uint32_t first, std::uint32_t last) { visit_under_among(first, last, path, t_end, slack, visit); });
}

Exit TriangleMesh::exit(const Parabola& path) const {
  const double floor = bounds_.low.z(), half_g = 0.5 * path.a.z();
  const double t_floor = falling_root(path.p.z() - floor, path.v.z(), path.a.z(), 1e300).value_or(0);
  const double t_end = falling_root(path.p.z() - floor + 1, path.v.z(), path.a.z(), 1e300).value_or(0);
  // A flight without contact leaves where it is above ground for the last time: at a rim, or at a brow with nothing
  // beyond. If that is within a facet, it fell through.
  using tolerance::fell_through;
  double last = -1;
  bool falls_through = false;
  const auto look = [&](const OverPlane& over, std::uint32_t k) {
    if (max_height_over(over, half_g) < -fell_through) return;  // the facet is above the path
    double end = over.window.leave;
    const bool crosses = over.h0 + end * (over.h1 + half_g * end) < -fell_through;
    if (crosses) {
      end = falling_root(over.h0 + fell_through, over.h1, path.a.z(), 1e300).value_or(end);
    } else {
      // The slack decides which facets it is over, not when it leaves them.
      const double without = time_over(facets_[k].corner, path.p.xy(), path.v.xy(), t_end).leave;
      if (without >= 0) end = std::min(end, without);
    }
    if (end < last) return;
    falls_through = crosses || (end == last && falls_through);
    last = end;
  };
  // (Within the slack of a steep facet, its plane may be lower than the facet: by less than this.)
  constexpr double worth = -1;
  bvh_.visit_under_from_the_end(path, last, t_end, worth, [&](std::uint32_t first, std::uint32_t end, double&) {
    visit_under_among(first, end, path, t_end, contact_slack, look);
  });
  if (last < 0) return ground_over(path.p) ? Exit{t_floor, true} : Exit{0, false};
  return falls_through ? Exit{t_floor, true} : Exit{last, false};
}

double TriangleMesh::max_height_in_sight(const Parabola& path, double flight, const TimeWindow& window,
                                         std::uint32_t facet) const {
  const Parabola part{path.at(window.enter), path.velocity(window.enter), path.a};
  const double t_end = window.leave - window.enter;
  const Triangle& corner = facets_[facet].corner;
  OverPlane over = over_facet(corner, area_normal(corner), part, t_end);
  over.window = {0, t_end};
  HeightInSight height(over, 0.5 * path.a.z(), flight);
  visit_under(part, t_end, 0, [&](const OverPlane& other, std::uint32_t k) {
    if (k != facet) height.hide(other);
  });
  return height.maximum();
}

double TriangleMesh::max_height(const Parabola& path, double t_end, double known) const {
  const double half_g = 0.5 * path.a.z();
  bvh_.visit_under(
      path, t_end, [&] { return known; },
      [&](std::uint32_t first, std::uint32_t last) {
        for (std::uint32_t k = first; k < last; ++k) {
          const Vec3 n = area_normal(facets_[k].corner);
          if (n.z() <= 0) continue;
          const OverPlane over = over_facet(facets_[k].corner, n, path, t_end);
          if (over.window.is_empty()) continue;
          const double height = max_height_over(over, half_g);
          if (height <= known) continue;
          known = is_height_field_ ? height : std::max(known, max_height_in_sight(path, t_end, over.window, k));
        }
      });
  return known;
}

// One search for all parts: a search for each part takes most of the time of maps.
void TriangleMesh::max_heights(const Parabola& path, std::span<const double> borders, std::span<double> heights) const {
  std::fill(heights.begin(), heights.end(), 0);
  const double half_g = 0.5 * path.a.z();
  visit_under(path, borders.back(), 0, [&](const OverPlane& over, std::uint32_t facet) {
    const auto [enter, leave] = over.window;
    const auto first = std::lower_bound(borders.begin() + 1, borders.end() - 1, enter) - borders.begin() - 1;
    for (auto k = static_cast<std::size_t>(first); k < heights.size() && borders[k] <= leave; ++k) {
      const TimeWindow within{std::max(enter, borders[k]), std::min(leave, borders[k + 1])};
      double height = max_height_over({within, over.h0, over.h1}, half_g);
      if (height <= heights[k]) continue;
      if (!is_height_field_) height = max_height_in_sight(path, borders[k + 1] - borders[k], within, facet);
      heights[k] = std::max(heights[k], height);
    }
  });
}

std::optional<double> TriangleMesh::height_at(std::uint32_t facet, const Vec3& n, double x, double y) const {
  const Triangle& corner = facets_[facet].corner;
  for (std::size_t c = 0; c < 3; ++c) {
    const Vec3 along = corner[next_corner[c]] - corner[c];
    const double area = along.x() * (y - corner[c].y()) - along.y() * (x - corner[c].x());
    if (!((n.z() > 0 ? area : -area) >= -contact_slack * (std::abs(along.x()) + std::abs(along.y())))) {
      return std::nullopt;
    }
  }
  return corner[0].z() - (n.x() * (x - corner[0].x()) + n.y() * (y - corner[0].y())) / n.z();
}

template <class Visit>
void TriangleMesh::visit_column(double x, double y, double z_low, double z_high, Visit&& visit) const {
  const Vec3 low(x - contact_slack, y - contact_slack, z_low), high(x + contact_slack, y + contact_slack, z_high);
  bvh_.visit_box(low, high, [&](std::uint32_t first, std::uint32_t last) {
    for (std::uint32_t k = first; k < last; ++k) {
      const auto& corner = facets_[k].corner;
      const Vec3 n = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
      if (n.z() == 0) continue;
      const auto z = height_at(k, n, x, y);
      if (z && *z >= z_low && *z <= z_high) visit(*z, n.z(), k);
    }
  });
}

std::optional<double> TriangleMesh::elevation(double x, double y, double below) const {
  std::optional<double> highest;
  const double top = std::min(below, bounds_.high.z() + 1);
  visit_column(x, y, bounds_.low.z() - 1, top,
               [&](double z, double, std::uint32_t) { highest = std::max(highest.value_or(z), z); });
  return highest;
}

bool TriangleMesh::has_ground_below(const Vec3& place, FacetId near) const {
  // The facet below is a step or two away, across sides.
  constexpr int most_steps = 8;
  std::uint32_t k = near.index;
  for (int step = 0; step < most_steps && k != no_neighbour; ++step) {
    const Facet& facet = facets_[k];
    const Vec3 n = area_normal(facet.corner);
    if (n.z() <= 0) break;
    double least = 0;
    std::size_t side = 3;
    for (std::size_t c = 0; c < 3; ++c) {
      const Vec3 along = facet.corner[next_corner[c]] - facet.corner[c];
      const Vec3 from = place - facet.corner[c];
      const double inside = along.x() * from.y() - along.y() * from.x();
      if (inside >= least) continue;
      least = inside;
      side = c;
    }
    if (side == 3) {
      if (n.dot(place - facet.corner[0]) >= 0) return true;
      break;
    }
    k = facet.neighbour[side];
  }
  return elevation(place.x(), place.y(), place.z()).has_value();
}

std::optional<GroundBelow> TriangleMesh::ground_below(const Vec3& place) const {
  std::optional<GroundBelow> below;
  visit_column(place.x(), place.y(), bounds_.low.z() - 1, place.z() + contact_slack,
               [&](double z, double, std::uint32_t facet) {
                 if (!below || z > below->z) below = GroundBelow{z, FacetId{facet}};
               });
  return below;
}

std::optional<double> TriangleMesh::ground_over(const Vec3& place) const {
  std::optional<double> nearest;
  bool faces_up = false;
  visit_column(place.x(), place.y(), place.z() + contact_slack, bounds_.high.z() + 1,
               [&](double z, double n_z, std::uint32_t) {
                 if (nearest && z >= *nearest) return;
                 nearest = z;
                 faces_up = n_z > 0;
               });
  return faces_up ? nearest : std::nullopt;
}

std::vector<Vec3> TriangleMesh::draped(const Vec2& from, const Vec2& to) const {
  const Vec2 d = to - from;
  std::vector<double> bends;
  const Vec3 low(std::min(from.x(), to.x()), std::min(from.y(), to.y()), bounds_.low.z());
  const Vec3 high(std::max(from.x(), to.x()), std::max(from.y(), to.y()), bounds_.high.z());
  bvh_.visit_box(low, high, [&](std::uint32_t first, std::uint32_t last) {
    for (std::uint32_t k = first; k < last; ++k) {
      const auto& corner = facets_[k].corner;
      const TimeWindow over = time_over(corner, from, d, 1);
      if (over.is_empty()) continue;
      bends.push_back(over.enter);
      bends.push_back(over.leave);
    }
  });
  std::sort(bends.begin(), bends.end());
  // Between two bends there is one facet. Its elevations at both are used, since the ground steps at vertical and
  // overhanging faces.
  constexpr double same = 1e-6;  // [m]
  std::vector<Vec3> line;
  const auto put = [&](const Vec3& p) {
    if (line.empty() || (p - line.back()).norm() > same) line.push_back(p);
  };
  for (std::size_t i = 0; i + 1 < bends.size(); ++i) {
    const double begin = bends[i], end = bends[i + 1];
    if (end - begin < 1e-9) continue;
    const Vec2 middle = from + 0.5 * (begin + end) * d;
    const auto ground = ground_below({middle.x(), middle.y(), bounds_.high.z() + 1});
    if (!ground) continue;
    const auto& corner = facets_[ground->facet.index].corner;
    const Vec3 n = area_normal(corner);
    for (const double s : {begin, end}) {
      const Vec2 at = from + s * d;
      put({at.x(), at.y(), corner[0].z() - n.xy().dot(at - corner[0].xy()) / n.z()});
    }
  }
  return line;
}

}  // namespace talus
