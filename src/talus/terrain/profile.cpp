#include "talus/terrain/profile.hpp"

#include <algorithm>

#include "talus/core/check.hpp"
#include "talus/rocks/touch.hpp"
#include "talus/terrain/facet_contact.hpp"
#include "talus/terrain/height_in_sight.hpp"
#include "talus/terrain/surface.hpp"

namespace talus {

static_assert(TerrainSurface<Profile>);

namespace {

// Folded profiles with fewer segments are searched one by one, which is faster than a tree.
constexpr std::size_t short_profile = 48;

using tolerance::widest_slack;

Vec3 in_plane(const Vec3& v) { return {v.x(), 0, v.z()}; }

}  // namespace

struct Profile::Candidate {
  double t;
  Vec3 normal;
  std::uint32_t facet = 0;
  Feature feature = Feature::facet;
  bool found = false;

  void offer(double t_new, Feature feature_new, std::uint32_t facet_new, const Vec3& normal_new) {
    const bool earlier = t_new < t || (t_new == t && (!found || feature_new < feature));
    if (earlier) *this = {t_new, normal_new, facet_new, feature_new, true};
  }
  [[nodiscard]] std::optional<Contact> contact() const {
    if (!found) return std::nullopt;
    return Contact{t, normal, FacetId{facet}, feature};
  }
};

Profile::Profile(std::span<const Vec2> vertices) {
  segments_.resize(vertices.empty() ? 0 : vertices.size() - 1);
  move_vertices(vertices);
  if (is_height_field_ || segments_.size() <= short_profile) return;
  std::vector<Box> boxes;
  for (const Segment& segment : segments_) {
    Box box;
    box.grow(segment.a);
    box.grow(segment.a + segment.length * segment.along);
    boxes.push_back(box);
  }
  bvh_ = Bvh(boxes);
}

void Profile::move_vertices(std::span<const Vec2> vertices) {
  TALUS_PROMISE(vertices.size() == segments_.size() + 1, "a profile keeps its number of vertices");
  bvh_ = Bvh();
  bounds_ = Box();
  is_height_field_ = true;
  for (const Vec2& v : vertices) bounds_.grow(Vec3(v.x(), 0, v.y()));
  for (std::size_t k = 0; k < segments_.size(); ++k) {
    Segment& segment = segments_[k];
    const Vec2 d = vertices[k + 1] - vertices[k];
    segment.length = d.norm();
    segment.a = {vertices[k].x(), 0, vertices[k].y()};
    segment.along = Vec3(d.x(), 0, d.y()) / segment.length;
    segment.normal = {-segment.along.z(), 0, segment.along.x()};
    segment.sharp_start = k == 0 || segments_[k - 1].normal.dot(segment.along) < -tolerance::sharp_bend;
    segment.sharp_end = k + 1 == segments_.size();
    if (!(segment.normal.z() > 0)) is_height_field_ = false;
  }
}

template <class Visit>
void Profile::visit_near(const Parabola& path, double pad, double& t_max, Visit&& visit) const {
  if (is_height_field_) {
    // The segments are in order of x: visits those that the path passes, from its start.
    const auto start_x = [](const Segment& s) { return s.a.x(); };
    const auto end_x = [](const Segment& s) { return s.a.x() + s.length * s.along.x(); };
    const double x = path.p.x(), vx = path.v.x(), reach = 0.5 * t_max * t_max * std::abs(path.a.x());
    if (vx >= 0) {
      auto k = std::partition_point(segments_.begin(), segments_.end(),
                                    [&](const Segment& s) { return end_x(s) < x - pad - reach; });
      for (; k != segments_.end() && start_x(*k) <= x + vx * t_max + pad + reach; ++k) visit(index_of(*k));
    } else {
      auto k = std::partition_point(segments_.begin(), segments_.end(),
                                    [&](const Segment& s) { return start_x(s) <= x + pad + reach; });
      while (k != segments_.begin() && end_x(*--k) >= x + vx * t_max - pad - reach) visit(index_of(*k));
    }
    return;
  }
  if (bvh_.order().empty() || path.a.x() != 0) {
    for (std::uint32_t k = 0; k < segments_.size(); ++k) visit(k);
    return;
  }
  bvh_.visit_flight(path, pad, t_max, [&](std::uint32_t first, std::uint32_t last, double&) {
    for (std::uint32_t place = first; place < last; ++place) visit(bvh_.order()[place]);
  });
}

void Profile::meet(const Parabola& path, Path kind, double radius, std::uint32_t k, const SupportPlanes& left,
                   Candidate& best) const {
  const Segment& segment = segments_[k];
  const Vec3& n = segment.normal;
  const double vn = n.dot(path.v), an = n.dot(path.a);
  const double h0 = n.dot(path.p - segment.a) - radius;
  const auto t = falling_root(h0, vn, an, radius > 0 ? radius : contact_slack);
  if (t && *t <= best.t) {
    const auto is_over = [&](double at, double slack) {
      const double along = segment.along.dot(path.at(at) - segment.a);
      return along >= -slack && along <= segment.length + slack;
    };
    const double normal_speed = std::max(-(vn + *t * an), 1e-300);
    const double slack = outline_slack(path.velocity(*t).norm(), normal_speed);
    const double along = segment.along.dot(path.at(*t) - segment.a);
    const Vec3& way = first_way(path);
    const double rate = segment.along.dot(way), speed = way.norm();
    const bool leaves =
        radius > 0 && (leaves_side(*t, along, rate, speed) || leaves_side(*t, segment.length - along, -rate, speed));
    const bool is_met =
        is_over(*t, slack) && !leaves && !left.is_at_pivot(path.at(*t) - radius * n) &&
        !left.excludes(FacetId{k}, n, h0, vn, an, [&](double at) { return is_over(at, contact_slack); });
    if (is_met) best.offer(*t, Feature::facet, k, n);
  }
  if (radius == 0) return;
  const auto corner = [&](const Vec3& q, std::uint32_t owner) {
    const Parabola planar{in_plane(path.p), in_plane(path.v), in_plane(path.a)};
    const auto touch = touch_point(planar, q, radius, {0, best.t});
    if (!touch) return;
    const Vec3 out = (planar.at(*touch) - q).normalized();
    if (kind == Path::leg && left.contain(out, tolerance::facet_normal))
      return;  // the end of the plane that it rolls on
    best.offer(*touch, Feature::edge, owner, out);
  };
  // The corner between two segments belongs to the first, as the edge between two facets of a mesh does.
  if (segment.sharp_start) corner(segment.a, k > 0 ? k - 1 : k);
  if (segment.sharp_end) corner(segment.a + segment.length * segment.along, k);
}

std::optional<Contact> Profile::first_contact(const Parabola& path, double radius, double t_max,
                                              const SupportPlanes& left) const {
  Candidate best{t_max};
  visit_near(path, radius + widest_slack, best.t,
             [&](std::uint32_t k) { meet(path, Path::flight, radius, k, left, best); });
  return best.contact();
}

std::optional<Contact> Profile::first_contact_on_leg(const Parabola& leg, double radius, double t_max,
                                                     const SupportPlanes& on) const {
  Candidate best{t_max};
  visit_near(leg, radius + widest_slack, best.t, [&](std::uint32_t k) { meet(leg, Path::leg, radius, k, on, best); });
  return best.contact();
}

Exit Profile::exit(const Parabola& path) const {
  const double end = path.v.x() > 0 ? bounds_.high.x() : bounds_.low.x();
  const double t = std::max(0.0, (end - path.p.x()) * slabs_detail::reciprocal(path.v.x()));
  const Segment& last = path.v.x() > 0 ? segments_.back() : segments_.front();
  const double z_end = path.v.x() > 0 ? last.a.z() + last.length * last.along.z() : last.a.z();
  const double x_end = path.v.x() > 0 ? last.a.x() + last.length * last.along.x() : last.a.x();
  if (path.v.x() == 0) {
    const auto fallen = falling_root(path.p.z() - bounds_.low.z(), path.v.z(), path.a.z(), 1e300);
    return {fallen.value_or(0), path.p.x() > bounds_.low.x() && path.p.x() < bounds_.high.x()};
  }
  // A disc may still touch the end when its centre has left the model.
  if (path.p.x() <= bounds_.low.x() || path.p.x() >= bounds_.high.x()) return {0, false};
  // A rock that leaves below the end of the profile is lost, unless the profile overhangs beyond its end.
  return {t, x_end == end && path.z(t) < z_end - tolerance::fell_through};
}

std::optional<OverPlane> Profile::over_segment(const Segment& segment, const Parabola& path, double t_end) {
  if (segment.along.x() <= 0) return std::nullopt;
  const double inverse_vx = slabs_detail::reciprocal(path.v.x());
  const double t1 = (segment.a.x() - path.p.x()) * inverse_vx;
  const double t2 = t1 + segment.length * segment.along.x() * inverse_vx;
  const TimeWindow window{std::max(0.0, std::min(t1, t2)), std::min(t_end, std::max(t1, t2))};
  if (window.is_empty()) return std::nullopt;
  const double slope = segment.along.z() / segment.along.x();
  return OverPlane{window, path.p.z() - segment.a.z() - slope * (path.p.x() - segment.a.x()),
                   path.v.z() - slope * path.v.x()};
}

double Profile::max_height(const Parabola& path, double t_end, double known) const {
  const auto look = [&](std::uint32_t k) {
    const auto over = over_segment(segments_[k], path, t_end);
    if (!over) return;
    const double half_g = 0.5 * path.a.z(), height = max_height_over(*over, half_g);
    if (height <= known) return;
    if (is_height_field_) {
      known = height;
      return;
    }
    HeightInSight in_sight(*over, half_g, t_end);
    for (const Segment& segment : segments_) {
      const auto other = over_segment(segment, path, t_end);
      if (other && &segment != &segments_[k]) in_sight.hide(*other);
    }
    known = std::max(known, in_sight.maximum());
  };
  if (is_height_field_) {
    double t = t_end;
    visit_near(path, widest_slack, t, look);
  } else if (bvh_.order().empty()) {
    for (std::uint32_t k = 0; k < segments_.size(); ++k) look(k);
  } else {
    bvh_.visit_under(
        path, t_end, [&] { return known; },
        [&](std::uint32_t first, std::uint32_t last) {
          for (std::uint32_t place = first; place < last; ++place) look(bvh_.order()[place]);
        });
  }
  return known;
}

template <class Visit>
void Profile::visit_column(double x, Visit&& visit) const {
  for (const Segment& segment : segments_) {
    const double reach = segment.length * segment.along.x();
    if (reach == 0) continue;
    const double s = (x - segment.a.x()) / reach;
    if (s >= -1e-12 && s <= 1 + 1e-12)
      visit(segment.a.z() + s * segment.length * segment.along.z(), segment.normal.z());
  }
}

std::optional<double> Profile::elevation(double x, double, double below) const {
  std::optional<double> highest;
  visit_column(x, [&](double z, double) {
    if (z <= below) highest = std::max(highest.value_or(z), z);
  });
  return highest;
}

bool Profile::has_ground_below(const Vec3& place, FacetId near) const {
  const Segment& segment = segments_[near.index];
  const double along = place.x() - segment.a.x(), reach = segment.length * segment.along.x();
  const bool is_over = reach > 0 && along >= 0 && along <= reach && segment.normal.dot(place - segment.a) >= 0;
  return is_over || elevation(place.x(), 0, place.z()).has_value();
}

std::optional<GroundBelow> Profile::ground_below(const Vec3& place) const {
  std::optional<GroundBelow> below;
  const auto look = [&](const Segment& segment) {
    const double reach = segment.length * segment.along.x();
    if (reach == 0) return;
    const double s = (place.x() - segment.a.x()) / reach;
    if (s < -1e-12 || s > 1 + 1e-12) return;
    const double z = segment.a.z() + s * segment.length * segment.along.z();
    if (z <= place.z() + contact_slack && (!below || z > below->z)) below = GroundBelow{z, FacetId{index_of(segment)}};
  };
  if (is_height_field_) {
    const auto after = std::partition_point(segments_.begin(), segments_.end(),
                                            [&](const Segment& s) { return s.a.x() <= place.x(); });
    if (after != segments_.begin()) look(*std::prev(after));
  } else {
    for (const Segment& segment : segments_) look(segment);
  }
  return below;
}

std::optional<double> Profile::ground_over(const Vec3& place) const {
  std::optional<double> nearest;
  bool faces_up = false;
  visit_column(place.x(), [&](double z, double n_z) {
    if (z <= place.z() + contact_slack || (nearest && z >= *nearest)) return;
    nearest = z;
    faces_up = n_z > 0;
  });
  return faces_up ? nearest : std::nullopt;
}

Outline Profile::outline(FacetId facet) const {
  const Segment& segment = segments_[facet.index];
  Outline outline;
  outline.point = segment.a;
  outline.normal = segment.normal;
  outline.edge_count = 2;
  outline.edges[0] = {segment.a, segment.along, std::nullopt};
  outline.edges[1] = {segment.a + segment.length * segment.along, -segment.along, std::nullopt};
  if (facet.index > 0) outline.edges[0].beyond = FacetId{facet.index - 1};
  if (facet.index + 1 < segments_.size()) outline.edges[1].beyond = FacetId{facet.index + 1};
  return outline;
}

}  // namespace talus
