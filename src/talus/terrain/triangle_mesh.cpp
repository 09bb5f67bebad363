#include "talus/terrain/triangle_mesh.hpp"

#include <algorithm>

#include "talus/core/check.hpp"
#include "talus/flight/touch.hpp"

namespace talus {

namespace {

constexpr std::array<std::size_t, 3> next{1, 2, 0};

constexpr double pad = 1e-6;  // by which boxes are grown, so that rounding hides no contact [m]

// How far outside a facet's outline [m] a contact may lie and still belong to it: what a facet of thickness
// contact_slack shows to a path that comes in under the given ratio of tangential to normal speed. Beyond a ratio of
// 1e4 it grows no further (a rock cannot fall on a facet so flatly; only rounding can).
double outline_slack(double tangential_speed, double normal_speed) {
  return contact_slack * (1 + std::min(tangential_speed / std::max(normal_speed, 1e-300), 1e4));
}

}  // namespace

// The best contact so far, and on whose side a tie falls: at equal times the triangle that came first in the input.
struct TriangleMesh::Candidate {
  double t;
  Vec3 normal = Vec3::Zero();
  std::uint32_t facet = no_neighbour;
  std::uint32_t source = no_neighbour;
  Feature feature = Feature::facet;

  [[nodiscard]] bool beaten_by(double t_new, Feature feature_new, std::uint32_t source_new) const {
    if (t_new != t) return t_new < t;
    if (facet == no_neighbour) return true;
    return feature_new != feature ? feature_new < feature : source_new < source;
  }
  [[nodiscard]] std::optional<Contact> contact() const {
    if (facet == no_neighbour) return std::nullopt;
    return Contact{t, normal, FacetId{facet}, feature};
  }
};

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
      if (beyond == no_neighbour) rim_.push_back({facet.corner[c], vertices[triangles[source][next[c]]]});
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
      sharp_vertex[triangles[facet.source][next[c]]] = true;
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
    edge.inward = outline.normal.cross(facet.corner[next[c]] - facet.corner[c]).normalized();
    if (facet.neighbour[c] != no_neighbour) edge.beyond = FacetId{facet.neighbour[c]};
  }
  return outline;
}

void TriangleMesh::meet_point(const Parabola& path, std::uint32_t k, const LeftPlanes& left, Candidate& best) const {
  const Facet& facet = facets_[k];
  const Vec3 first = facet.corner[1] - facet.corner[0], last = facet.corner[2] - facet.corner[0];
  // The normal is not made a unit vector before that is needed: times do not depend on its length.
  const Vec3 n = first.cross(last);
  const double vn = n.dot(path.v), an = n.dot(path.a);
  if (vn >= 0 && an >= 0) return;
  const Vec3 from_corner = path.p - facet.corner[0];
  const double h0 = n.dot(from_corner);
  const auto t = falling_root(h0, vn, an, contact_slack * n.lpNorm<1>());
  if (!t || !best.beaten_by(*t, Feature::facet, facet.source)) return;

  // Distances from the sides, times the lengths of n and of the side; they sum up to the square of n.
  const Vec3 q = from_corner + *t * path.v + (0.5 * *t * *t) * path.a;
  const double n2 = n.squaredNorm();
  const double inside_first = n.dot(first.cross(q)), inside_last = n.dot(q.cross(last));
  const double inside_middle = n2 - inside_first - inside_last;
  const double n_length = std::sqrt(n2);
  const Vec3 unit = n / n_length;
  if (std::min({inside_first, inside_middle, inside_last}) < 0) {
    const Vec3 arriving = path.velocity(*t);
    const double slack = outline_slack(arriving.norm(), -unit.dot(arriving)) * n_length;
    if (inside_first < -slack * first.norm() || inside_last < -slack * last.norm() ||
        inside_middle < -slack * (last - first).norm()) {
      return;
    }
  }
  if (h0 <= 1e-7 * n_length && left.contain(unit, same_plane)) return;
  best = {*t, unit, k, facet.source, Feature::facet};
}

void TriangleMesh::meet_sphere(const Parabola& path, Path kind, double radius, const TimeWindow& window,
                               std::uint32_t k, const LeftPlanes& left, Candidate& best) const {
  const Facet& facet = facets_[k];
  const std::array<Vec3, 3> side{facet.corner[1] - facet.corner[0], facet.corner[2] - facet.corner[1],
                                 facet.corner[0] - facet.corner[2]};
  const Vec3 n = side[0].cross(side[1]).normalized();
  const double vn = n.dot(path.v), an = n.dot(path.a);
  const double h0 = n.dot(path.p - facet.corner[0]) - radius;
  const bool in_left_plane = h0 <= 1e-7 && left.contain(n, same_plane);
  // A sphere that is in the facet already (its centre still above it) is not let any deeper.
  if (const auto t = falling_root(h0, vn, an, radius);
      t && !in_left_plane && best.beaten_by(*t, Feature::facet, facet.source)) {
    const Vec3 foot = path.at(*t) - radius * n;
    const Vec3 arriving = path.velocity(*t);
    const double slack = outline_slack(arriving.norm(), -n.dot(arriving));
    bool inside = true;
    for (std::size_t c = 0; c < 3; ++c) {
      inside = inside && n.dot(side[c].cross(foot - facet.corner[c])) >= -slack * side[c].norm();
    }
    if (inside) best = {*t, n, k, facet.source, Feature::facet};
  }
  // A rock that rolls on a plane touches that plane's own edges from above, which is no new contact.
  const auto offer = [&](double t, const Vec3& away, Feature feature) {
    const Vec3 out = away.normalized();
    if (kind == Path::leg && left.contain(out, 1e-9)) return;
    if (best.beaten_by(t, feature, facet.source)) best = {t, out, k, facet.source, feature};
  };
  for (std::size_t c = 0; c < 3; ++c) {
    const TimeWindow until_now{window.enter, std::min(window.leave, best.t)};
    if (until_now.is_empty()) return;
    if ((facet.sharp & (1U << c)) != 0) {
      const double length = side[c].norm();
      const Vec3 e = side[c] / length;
      const auto t = touch_edge(path, facet.corner[c], e, length, radius, until_now);
      if (t) offer(*t, tangential(path.at(*t) - facet.corner[c], e), Feature::edge);
    }
    if ((facet.sharp & (8U << c)) != 0) {
      const auto t = touch_point(path, facet.corner[c], radius, until_now);
      if (t) offer(*t, path.at(*t) - facet.corner[c], Feature::vertex);
    }
  }
}

template <class EachFacet>
std::optional<Contact> TriangleMesh::search_flight(const Parabola& path, double radius, double t_max,
                                                   const LeftPlanes& left, EachFacet&& each_facet) const {
  Candidate best{t_max};
  if (radius == 0) {
    bvh_.visit_flight(path, pad, best.t, [&](std::uint32_t first, std::uint32_t last, double&) {
      for (std::uint32_t k = first; k < last; ++k) {
        each_facet();
        meet_point(path, k, left, best);
      }
    });
    return best.contact();
  }
  const FlightSlabs slabs(path);
  bvh_.visit_flight(path, radius + pad, best.t, [&](std::uint32_t first, std::uint32_t last, double&) {
    for (std::uint32_t k = first; k < last; ++k) {
      const auto& corner = facets_[k].corner;
      const Box box{corner[0].cwiseMin(corner[1]).cwiseMin(corner[2]),
                    corner[0].cwiseMax(corner[1]).cwiseMax(corner[2])};
      const TimeWindow window = slabs.window(box, radius + pad, best.t);
      if (window.is_empty()) continue;
      each_facet();
      meet_sphere(path, Path::flight, radius, window, k, left, best);
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
  Candidate best{t_max};
  Box swept;
  swept.grow(leg.p);
  swept.grow(leg.at(0.5 * t_max));
  swept.grow(leg.at(t_max));
  // The arc between these three points stays within an eighth of a t^2 of their box.
  const Vec3 margin = Vec3::Constant(radius + pad) + 0.125 * t_max * t_max * leg.a.cwiseAbs();
  bvh_.visit_box(swept.low - margin, swept.high + margin, [&](std::uint32_t first, std::uint32_t last) {
    for (std::uint32_t k = first; k < last; ++k) meet_sphere(leg, Path::leg, radius, {0, t_max}, k, on, best);
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
          // The part of the path above this triangle: three lines cut it on plan.
          double enter = 0, leave = t_end;
          for (std::size_t c = 0; c < 3 && enter <= leave; ++c) {
            const Vec3 along = corner[next[c]] - corner[c];
            const double inside = along.x() * (path.p.y() - corner[c].y()) - along.y() * (path.p.x() - corner[c].x());
            const double rate = along.x() * path.v.y() - along.y() * path.v.x();
            if (rate > 0) {
              enter = std::max(enter, -inside / rate);
            } else if (rate < 0) {
              leave = std::min(leave, -inside / rate);
            } else if (inside < 0) {
              leave = -1;
            }
          }
          if (enter > leave) continue;
          // Height above the facet's plane: h0 + h1 t + half_g t^2, greatest where its derivative is zero.
          const double h0 = n.dot(path.p - corner[0]) / n.z(), h1 = n.dot(path.v) / n.z();
          const double t = std::clamp(half_g < 0 ? -h1 / (2 * half_g) : enter, enter, leave);
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
        const Vec3 along = corner[next[c]] - corner[c];
        const double area = along.x() * (y - corner[c].y()) - along.y() * (x - corner[c].x());
        inside = inside && (n.z() > 0 ? area : -area) >= -contact_slack * (std::abs(along.x()) + std::abs(along.y()));
      }
      if (!inside) continue;
      const double z = corner[0].z() - (n.x() * (x - corner[0].x()) + n.y() * (y - corner[0].y())) / n.z();
      if (z >= z_low && z <= z_high) visit(z, n.z());
    }
  });
}

std::optional<double> TriangleMesh::elevation(double x, double y, double below) const {
  std::optional<double> highest;
  const double top = std::min(below, bounds_.high.z() + 1);
  visit_column(x, y, bounds_.low.z() - 1, top, [&](double z, double) { highest = std::max(highest.value_or(z), z); });
  return highest;
}

std::optional<double> TriangleMesh::ground_over(const Vec3& place) const {
  std::optional<double> nearest;
  bool faces_up = false;
  visit_column(place.x(), place.y(), place.z() + contact_slack, bounds_.high.z() + 1, [&](double z, double n_z) {
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
      double enter = 0, leave = 1;
      const double turn = (corner[1] - corner[0]).cross(corner[2] - corner[0]).z() > 0 ? 1 : -1;
      for (std::size_t c = 0; c < 3 && enter <= leave; ++c) {
        const Vec3 along = corner[next[c]] - corner[c];
        const double inside = turn * (along.x() * (from.y() - corner[c].y()) - along.y() * (from.x() - corner[c].x()));
        const double rate = turn * (along.x() * d.y() - along.y() * d.x());
        if (rate > 0) {
          enter = std::max(enter, -inside / rate);
        } else if (rate < 0) {
          leave = std::min(leave, -inside / rate);
        } else if (inside < 0) {
          leave = -1;
        }
      }
      if (enter > leave) continue;
      bends.push_back(enter);
      bends.push_back(leave);
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

// Ericson, "Real-time collision detection" (2005), section 5.1.5.
Vec3 TriangleMesh::closest_point(std::uint32_t k, const Vec3& p) const {
  const auto& [a, b, c] = facets_[k].corner;
  const Vec3 ab = b - a, ac = c - a, ap = p - a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0) return a;
  const Vec3 bp = p - b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3) return b;
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return a + d1 / (d1 - d3) * ab;
  const Vec3 cp = p - c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6) return c;
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return a + d2 / (d2 - d6) * ac;
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b);
  const double scale = 1 / (va + vb + vc);
  return a + vb * scale * ab + vc * scale * ac;
}

}  // namespace talus
