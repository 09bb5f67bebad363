#pragma once
// The first contact of a point or a sphere with one triangle, its sides and its corners. Mesh and raster share this;
// they differ in how they find the triangles to test.

#include <array>
#include <cstdint>
#include <optional>

#include "talus/rocks/ridge.hpp"
#include "talus/rocks/touch.hpp"
#include "talus/terrain/contact.hpp"

namespace talus {

/// Corners counter-clockwise, seen from outside the ground.
using Triangle = std::array<Vec3, 3>;

inline constexpr std::array<std::size_t, 3> next_corner{1, 2, 0};

/// Its length is twice the area.
[[nodiscard]] inline Vec3 area_normal(const Triangle& corner) {
  return (corner[1] - corner[0]).cross(corner[2] - corner[0]);
}

/// The corner of a facet that is farthest from a ridge.
[[nodiscard]] inline Vec3 far_corner(const Triangle& facet, const Ridge& ridge) {
  const Vec3 along = ridge.to - ridge.from;
  const auto distance = [&](const Vec3& corner) { return along.cross(corner - ridge.from).squared_norm(); };
  std::size_t farthest = 0;
  for (std::size_t c = 1; c < 3; ++c) {
    if (distance(facet[c]) > distance(facet[farthest])) farthest = c;
  }
  return facet[farthest];
}

/// Whether the facet beyond a side falls away from the plane of this one, by more than `min_bend` (a sine).
[[nodiscard]] inline bool bends_down(const Triangle& corner, const Ridge& side, const Triangle& beyond,
                                     double min_bend) {
  const Vec3 along = side.to - side.from, far = far_corner(beyond, side) - side.from;
  const Vec3 n = area_normal(corner);
  return -n.dot(far) * along.norm() > min_bend * n.norm() * along.cross(far).norm();
}

[[nodiscard]] inline bool reaches_into(const Ridge& ridge, const Vec3& low, const Vec3& high) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (std::min(ridge.from[k], ridge.to[k]) > high[k] || std::max(ridge.from[k], ridge.to[k]) < low[k]) return false;
  }
  return true;
}

/// The first contact so far. At equal times a facet has priority over sides and corners, then the lower source number.
struct ContactCandidate {
  static constexpr std::uint32_t none = 0xffffffffU;

  double t;
  Vec3 normal;
  std::uint32_t facet = none;
  std::uint32_t source = none;
  Feature feature = Feature::facet;

  [[nodiscard]] bool found() const { return facet != none; }
  [[nodiscard]] bool beaten_by(double t_new, Feature feature_new, std::uint32_t source_new) const {
    if (t_new != t) return t_new < t;
    if (!found()) return true;
    return feature_new != feature ? feature_new < feature : source_new < source;
  }
  [[nodiscard]] std::optional<Contact> contact() const {
    if (!found()) return std::nullopt;
    return Contact{t, normal, FacetId{facet}, feature};
  }
};

/// The numbers of a triangle, for the contact.
struct FacetName {
  std::uint32_t facet, source;
};

/// The contact of a point with the triangle, written to `best` if it is earlier.
void meet_point(const Parabola& path, const Triangle& corner, FacetName name, const SupportPlanes& left,
                ContactCandidate& best);

/// Whether a sphere flies, or rolls along a leg. The plane on which it rolls is no contact.
enum class SpherePath { flight, leg };

/// The contact of a sphere with the triangle, as meet_point(). `window` must contain every time at which it may touch
/// the triangle. Sides (0 to 2, from corner k to the next) and corners (3 to 5) are tested only if sharp(k, t) is true,
/// that is if they may be touched before a facet. It is called with t < 0 first, to save work, then for a contact at t.
template <class Sharp>
void meet_sphere(const Parabola& path, SpherePath kind, double radius, const TimeWindow& window, const Triangle& corner,
                 FacetName name, const SupportPlanes& left, Sharp&& sharp, ContactCandidate& best);

/// The point of a triangle nearest to `p`.
[[nodiscard]] Vec3 closest_point(const Triangle& corner, const Vec3& p);

/// How far outside a facet's outline [m] a contact may be and still belong to the facet: a path with this ratio of
/// tangential to normal speed passes that far beyond the outline through a facet of thickness contact_slack.
[[nodiscard]] inline double outline_slack(double tangential_speed, double normal_speed) {
  return contact_slack * (1 + std::min(tangential_speed / std::max(normal_speed, tolerance::least_speed),
                                       tolerance::flattest_approach));
}

/// Whether a sphere that touches a facet's plane at the start of its path, outside the facet, moves further away: it
/// leaves what it was on. `inside`, `rate`: the distance from a side, positive inside, and its growth. (Not used for a
/// point, which may be outside a facet by rounding where a wall rises from it. A sphere keeps its distance from the
/// wall.)
[[nodiscard]] inline bool leaves_side(double t, double inside, double rate, double speed) {
  return t == 0 && inside < 0 && rate < -tolerance::share_by_rounding * speed;
}
/// The direction in which a path begins: that of its velocity or, from standstill, of its acceleration.
[[nodiscard]] inline const Vec3& first_way(const Parabola& path) { return path.v == Vec3{} ? path.a : path.v; }

/// A triangle's sides and unit normal, and the gap between a sphere and its plane, h0 + vn t + an t^2 / 2.
struct SphereOverFacet {
  std::array<Vec3, 3> side;
  Vec3 n;
  double h0, vn, an;

  SphereOverFacet(const Parabola& path, double radius, const Triangle& corner)
      : side{corner[1] - corner[0], corner[2] - corner[1], corner[0] - corner[2]},
        n(side[0].cross(side[1]).normalized()),
        h0(n.dot(path.p - corner[0]) - radius),
        vn(n.dot(path.v)),
        an(n.dot(path.a)) {}
};

/// The contact of a sphere with the triangle's face only.
inline void meet_face(const Parabola& path, double radius, const Triangle& corner, const SphereOverFacet& over,
                      FacetName name, const SupportPlanes& left, ContactCandidate& best) {
  // A sphere that has already sunk into the facet (its centre still above it) must not sink deeper.
  const auto t = falling_root(over.h0, over.vn, over.an, radius);
  if (!t || !best.beaten_by(*t, Feature::facet, name.source)) return;
  const auto is_over = [&](double at, double slack) {
    const Vec3 foot = path.at(at) - radius * over.n;
    for (std::size_t c = 0; c < 3; ++c) {
      if (!(over.n.dot(over.side[c].cross(foot - corner[c])) >= -slack * over.side[c].norm())) return false;
    }
    return true;
  };
  const Vec3 arriving = path.velocity(*t);
  if (!is_over(*t, outline_slack(arriving.norm(), -over.n.dot(arriving)))) return;
  if (*t == 0) {
    const Vec3 foot = path.p - radius * over.n;
    const Vec3& way = first_way(path);
    for (std::size_t c = 0; c < 3; ++c) {
      const Vec3 inward = over.n.cross(over.side[c]);
      if (leaves_side(0, inward.dot(foot - corner[c]), inward.dot(way), inward.norm() * way.norm())) return;
    }
  }
  if (left.excludes(FacetId{name.facet}, over.n, over.h0, over.vn, over.an,
                    [&](double at) { return is_over(at, contact_slack); }) ||
      left.is_at_pivot(path.at(*t) - radius * over.n)) {
    return;
  }
  best = {*t, over.n, name.facet, name.source, Feature::facet};
}

/// The contact of a sphere with the triangle's sides and corners.
template <class Sharp>
void meet_sides(const Parabola& path, SpherePath kind, double radius, const TimeWindow& window, const Triangle& corner,
                FacetName name, const SupportPlanes& left, Sharp&& sharp, ContactCandidate& best) {
  const auto offer = [&](double t, const Vec3& away, Feature feature, std::size_t what) {
    const Vec3 out = away.normalized();
    // A rock that rolls on a plane touches the plane's own edges from above, which is no new contact.
    if (kind == SpherePath::leg && left.contain(out, tolerance::facet_normal)) return;
    if (!best.beaten_by(t, feature, name.source) || !sharp(what, t)) return;
    best = {t, out, name.facet, name.source, feature};
  };
  for (std::size_t c = 0; c < 3; ++c) {
    const TimeWindow until_now{window.enter, std::min(window.leave, best.t)};
    if (until_now.is_empty()) return;
    if (sharp(c, -1.0)) {
      const Vec3 side = corner[next_corner[c]] - corner[c];
      const double length = side.norm();
      const Vec3 e = side / length;
      const auto t = touch_edge(path, corner[c], e, length, radius, until_now);
      if (t) offer(*t, tangential(path.at(*t) - corner[c], e), Feature::edge, c);
    }
    if (sharp(3 + c, -1.0)) {
      const auto t = touch_point(path, corner[c], radius, until_now);
      if (t) offer(*t, path.at(*t) - corner[c], Feature::vertex, 3 + c);
    }
  }
}

template <class Sharp>
void meet_sphere(const Parabola& path, SpherePath kind, double radius, const TimeWindow& window, const Triangle& corner,
                 FacetName name, const SupportPlanes& left, Sharp&& sharp, ContactCandidate& best) {
  const SphereOverFacet over(path, radius, corner);
  // The sphere rolls on this plane: neither the face nor its sides and corners are new contacts.
  if (kind == SpherePath::leg && std::abs(over.h0) <= tolerance::touching_plane && left.contain(over.n, same_plane)) {
    return;
  }
  if (over.an <= 0) {
    // The height over the plane is a concave function of time: a sphere above the plane at both ends of the window is
    // above it in between, and so above the sides and corners.
    const auto height = [&](double t) { return over.h0 + t * (over.vn + 0.5 * over.an * t); };
    if (height(window.enter) > box_pad && height(window.leave) > box_pad) return;
  }
  meet_face(path, radius, corner, over, name, left, best);
  meet_sides(path, kind, radius, window, corner, name, left, sharp, best);
}

}  // namespace talus
