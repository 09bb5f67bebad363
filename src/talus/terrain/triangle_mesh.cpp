#include "talus/terrain/triangle_mesh.hpp"

#include <algorithm>

#include "talus/core/check.hpp"

namespace talus {

namespace {

// When a point that goes from `from` at `velocity` on plan is over a triangle, in [0, t_end]: three lines cut its way.
TimeWindow time_over(const Triangle& corner, const Vec2& from, const Vec2& velocity, double t_end) {
  TimeWindow over{0, t_end};
  const double turn = area_normal(corner).z() > 0 ? 1 : -1;
  for (std::size_t c = 0; c < 3 && !over.is_empty(); ++c) {
    const Vec3 along = turn * (corner[next_corner[c]] - corner[c]);
    const double inside = along.x() * (from.y() - corner[c].y()) - along.y() * (from.x() - corner[c].x());
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
    const std::uint32_t source = bvh_.order()[k];
    Facet& facet = facets_[k];
    facet.source = source;
    facet.sharp = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      facet.corner[c] = vertices[triangles[source][c]];
      const std::uint32_t beyond = neighbours[source][c];
      facet.neighbour[c] = beyond == no_neighbour ? no_neighbour : place[beyond];
      if (beyond == no_neighbour) rim_.push_back({facet.corner[c], vertices[triangles[source][next_corner[c]]]});
    }
    if (normal({static_cast<std::uint32_t>(k)}).z() <= 0) is_height_field_ = false;
  }
  find_sharp_features(triangles);
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
        sharp = lowest < -1e-9 * reach;
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

std::size_t TriangleMesh::bytes() const {
  return facets_.size() * sizeof(Facet) + rim_.size() * sizeof(rim_[0]) + bvh_.bytes();
}

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
                                                   const LeftPlanes& left, EachFacet&& each_facet) const {
  ContactCandidate best{t_max};
  if (radius == 0) {
    bvh_.visit_flight(path, box_pad, best.t, [&](std::uint32_t first, std::uint32_t last, double&) {
      for (std::uint32_t k = first; k < last; ++k) {
        each_facet();
        meet_point(path, facets_[k].corner, {k, facets_[k].source}, left, best);
      }
    });
    return best.contact();
  }
  const FlightSlabs slabs(path);
  bvh_.visit_flight(path, radius + box_pad, best.t, [&](std::uint32_t first, std::uint32_t last, double&) {
    for (std::uint32_t k = first; k < last; ++k) {
      const Triangle& corner = facets_[k].corner;
      const Box box{corner[0].cwiseMin(corner[1]).cwiseMin(corner[2]),
                    corner[0].cwiseMax(corner[1]).cwiseMax(corner[2])};
      const TimeWindow window = slabs.window(box, radius + box_pad, best.t);
      if (window.is_empty()) continue;
      each_facet();
      meet_sphere(path, SpherePath::flight, radius, window, corner, {k, facets_[k].source}, left, sharp_of(k), best);
    }
  });
  return best.contact();
}

std::optional<Contact> TriangleMesh::first_contact(const Parabola& path, double radius, double t_max,
                                                   const LeftPlanes& left) const {
  return search_flight(path, radius, t_max, left, [] {});
}

std::uint32_t TriangleMesh::facets_tested(const Parabola& path, double radius, double t_max) const {
  std::uint32_t count = 0;
  (void)search_flight(path, radius, t_max, {}, [&] { ++count; });
  return count;
}

std::optional<Contact> TriangleMesh::first_contact_on_leg(const Parabola& leg, double radius, double t_max,
                                                          const LeftPlanes& on) const {
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

Exit TriangleMesh::exit(const Parabola& path) const {
  // The last crossing of the surface's rim from inside to outside, above the rim: after it nothing was met.
  double last = -1;
  for (const auto& [a, b] : rim_) {
    const Vec3 along = b - a;
    const double outward_speed = along.y() * path.v.x() - along.x() * path.v.y();
    if (outward_speed <= 0) continue;
    const double distance = along.y() * (a.x() - path.p.x()) - along.x() * (a.y() - path.p.y());
    const double t = std::max(0.0, distance / outward_speed);
    if (distance < -contact_slack * (std::abs(along.x()) + std::abs(along.y())) || t <= last) continue;
    const double plan_length2 = along.x() * along.x() + along.y() * along.y();
    const double s =
        ((path.p.x() + t * path.v.x() - a.x()) * along.x() + (path.p.y() + t * path.v.y() - a.y()) * along.y()) /
        plan_length2;
    if (s < -1e-9 || s > 1 + 1e-9) continue;
    if (path.z(t) >= a.z() + s * along.z() - 1e-6) last = t;
  }
  if (last >= 0) return {last, false};
  // A sphere may touch the rim while its centre is beyond it: it has left already.
  if (!elevation(path.p.x(), path.p.y())) return {0, false};
  // It never crossed the rim: it fell through.
  const double floor = bounds_.low.z();
  const auto t = falling_root(path.p.z() - floor, path.v.z(), path.a.z(), 1e300);
  return {t.value_or(0), true};
}

double TriangleMesh::greatest_height(const Parabola& path, double t_end, double known) const {
  const double half_g = 0.5 * path.a.z();
  bvh_.visit_under(
      path, t_end, [&] { return known; },
      [&](std::uint32_t first, std::uint32_t last) {
        for (std::uint32_t k = first; k < last; ++k) {
          const auto& corner = facets_[k].corner;
          const Vec3 n = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
          if (n.z() <= 0) continue;
          const TimeWindow above = time_over(corner, path.p.head<2>(), path.v.head<2>(), t_end);
          if (above.is_empty()) continue;
          // Height above the facet's plane: h0 + h1 t + half_g t^2, greatest where its derivative is zero.
          const double h0 = n.dot(path.p - corner[0]) / n.z(), h1 = n.dot(path.v) / n.z();
          const double t = std::clamp(half_g < 0 ? -h1 / (2 * half_g) : above.enter, above.enter, above.leave);
          double height = h0 + t * (h1 + half_g * t);
          if (height <= known) continue;
          if (!is_height_field_) {
            const Vec3 q = path.at(t);
            if (const auto ground = elevation(q.x(), q.y(), q.z() + contact_slack)) height = q.z() - *ground;
          }
          known = std::max(known, height);
        }
      });
  return known;
}

template <class Visit>
void TriangleMesh::visit_column(double x, double y, double z_low, double z_high, Visit&& visit) const {
  const Vec3 low(x - contact_slack, y - contact_slack, z_low), high(x + contact_slack, y + contact_slack, z_high);
  bvh_.visit_box(low, high, [&](std::uint32_t first, std::uint32_t last) {
    for (std::uint32_t k = first; k < last; ++k) {
      const auto& corner = facets_[k].corner;
      const Vec3 n = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
      if (n.z() == 0) continue;
      bool inside = true;
      for (std::size_t c = 0; c < 3; ++c) {
        const Vec3 along = corner[next_corner[c]] - corner[c];
        const double area = along.x() * (y - corner[c].y()) - along.y() * (x - corner[c].x());
        inside = inside && (n.z() > 0 ? area : -area) >= -contact_slack * (std::abs(along.x()) + std::abs(along.y()));
      }
      if (!inside) continue;
      const double z = corner[0].z() - (n.x() * (x - corner[0].x()) + n.y() * (y - corner[0].y())) / n.z();
      if (z >= z_low && z <= z_high) visit(z, n.z(), k);
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
  std::vector<Vec3> line;
  double previous = -1;
  for (const double s : bends) {
    if (s - previous < 1e-9) continue;
    previous = s;
    const Vec2 at = from + s * d;
    if (const auto z = elevation(at.x(), at.y())) line.emplace_back(at.x(), at.y(), *z);
  }
  return line;
}

}  // namespace talus
