#pragma once
// How far a body is above the ground, and where it touches it. Private to trajectory/.
//
// Its corners are tested against the ground, straight below them, and convex edges of the ground, ridges, with the
// vertices at their ends, against its faces (rocks/ridge.hpp). Where a convex body first touches ground of facets, it
// is in one of these ways: concave edges and the vertices where only such meet touch corners only.
//
// Left out are ridges where the slope changes by less than `one_touch` over the body's reach. A face that bridges one
// sinks in there by no more than half of that.

#include <algorithm>
#include <limits>
#include <optional>
#include <span>

#include "talus/impact/contact_set.hpp"
#include "talus/rocks/ridge.hpp"
#include "talus/terrain/raster_under_body.hpp"
#include "talus/terrain/surface.hpp"

namespace talus {

/// Of a place above the ground straight below it [m]; negative in the ground, infinite off the terrain.
template <class Surface>
[[nodiscard]] double clearance(const Surface& surface, const Vec3& place) {
  if (!surface.may_overhang()) {
    const auto ground = surface.elevation(place.x(), place.y(), std::numeric_limits<double>::infinity());
    return ground ? place.z() - *ground : std::numeric_limits<double>::infinity();
  }
  if (const auto below = surface.ground_below(place)) return place.z() - below->z;
  if (const auto over = surface.ground_over(place)) return place.z() - *over;
  return std::numeric_limits<double>::infinity();
}

/// What is below a body, where a surface has nothing of its own: all corners, and ridges in the box about them.
template <class Surface>
class UnderBody {
 public:
  UnderBody(const Surface& surface, const Posture& body) : surface_(surface), body_(body) {}

  template <class Visit>
  void visit_low_corners(double bound, Visit&& visit) const {
    if constexpr (requires { surface_.visit_low_corners(body_, bound, visit); }) {
      if (!surface_.may_overhang()) return surface_.visit_low_corners(body_, bound, visit);
    }
    for (std::size_t i = 0; i < body_.corners.size(); ++i) visit(i, clearance(surface_, body_.place(i)));
  }
  template <class Visit>
  void visit_ridges(double top, double min_bend, Visit&& visit) const {
    Vec3 low = body_.centre, high = body_.centre;
    for (std::size_t i = 0; i < body_.corners.size(); ++i) {
      const Vec3 place = body_.place(i);
      low = low.min(place);
      high = high.max(place);
    }
    const Vec3 pad = Vec3::all(std::min(top, body_.reach));
    surface_.visit_ridges(low - pad, high + pad, min_bend,
                          [&](const Ridge& ridge) { visit(ridge, RidgePart{}, body_.hull->all); });
  }
  [[nodiscard]] static double slant() { return 1; }
  [[nodiscard]] static double least_height() { return -std::numeric_limits<double>::infinity(); }

 private:
  const Surface& surface_;
  const Posture& body_;
};

template <class Surface>
[[nodiscard]] auto under(const Surface& surface, const Posture& body) {
  if constexpr (requires { typename Surface::UnderBody; }) {
    return typename Surface::UnderBody(surface, body);
  } else {
    return UnderBody<Surface>(surface, body);
  }
}

/// The change of slope at a ridge that counts.
[[nodiscard]] inline double min_bend(const Posture& body) { return tolerance::one_touch / body.reach; }

/// A corner of a body, or a ridge of the ground: the side of a facet.
struct TouchPart {
  std::uint32_t corner = 0;
  FacetId facet{};

  static constexpr std::uint32_t is_side = 0x80000000U;  // in `corner`, beside the number of the side
  [[nodiscard]] static TouchPart of(const Ridge& ridge) { return {is_side | ridge.side, ridge.facet}; }
  [[nodiscard]] static TouchPart of(const ContactPoint& contact) { return {contact.corner, contact.facet}; }
  [[nodiscard]] static TouchPart of_corner(std::size_t corner) { return {static_cast<std::uint32_t>(corner), {}}; }
  [[nodiscard]] bool is_ridge() const { return (corner & is_side) != 0; }
  [[nodiscard]] std::uint32_t side() const { return corner & ~is_side; }
  /// A corner is the same over any facet.
  [[nodiscard]] friend bool operator==(const TouchPart& a, const TouchPart& b) {
    return a.corner == b.corner && (!a.is_ridge() || a.facet == b.facet);
  }
};

/// What is nearest to touching. `gap`: of a corner, its clearance; of a ridge, how far outside of the body it is [m].
struct NearestPart {
  TouchPart part;
  double gap = std::numeric_limits<double>::infinity();
};

/// The nearest corner.
template <class Surface>
[[nodiscard]] NearestPart nearest_corner(const Surface& surface, const Posture& body) {
  NearestPart nearest;
  under(surface, body).visit_low_corners(nearest.gap, [&](std::size_t corner, double gap) {
    if (gap < nearest.gap) nearest = {TouchPart::of_corner(corner), gap};
    return nearest.gap;
  });
  return nearest;
}

/// Ridges count if they are nearer than a quarter of the clearance of all corners: a search for a touch need not know
/// of others.
template <class Surface>
[[nodiscard]] NearestPart nearest_part(const Surface& surface, const Posture& body) {
  constexpr double share = 0.25;
  constexpr double deep = 1e-9;  // [m] ridges in a body are sought also if it has a corner in the ground
  NearestPart nearest;
  auto below = under(surface, body);
  below.visit_low_corners(nearest.gap, [&](std::size_t corner, double gap) {
    if (gap < nearest.gap) nearest = {TouchPart::of_corner(corner), gap};
    return nearest.gap;
  });
  double bound = nearest.gap > 0 ? share * nearest.gap : nearest.gap;
  // None is nearer than this height.
  if (!body.has_faces() || (bound > 0 && below.least_height() > bound)) return nearest;
  below.visit_ridges(std::max(bound, deep), min_bend(body),
                     [&](const Ridge& ridge, const RidgePart& part, std::span<const std::uint32_t> faces) {
                       const auto found = ridge_gap(body, faces, ridge, bound, part);
                       if (!found || found->gap >= nearest.gap) return;
                       bound = found->gap;
                       nearest = {TouchPart::of(ridge), bound};
                     });
  return nearest;
}

/// The contacts of a body, the first 64 of them. Of more than a set holds, those that hold the body as all of them do:
/// the first, the farthest from it, the farthest from the line through both, and the farthest on the line's other side.
class Touched {
 public:
  void add(const ContactPoint& point) {
    if (size_ < found_.size()) found_[size_++] = point;
  }
  [[nodiscard]] bool is_empty() const { return size_ == 0; }
  /// Whether there is a contact with this normal, or nearly, within a distance [m].
  [[nodiscard]] bool has_near(const Vec3& arm, const Vec3& normal, double distance) const {
    const auto end = found_.begin() + static_cast<std::ptrdiff_t>(size_);
    return std::any_of(found_.begin(), end, [&](const ContactPoint& known) {
      return (known.arm - arm).squared_norm() <= distance * distance && known.normal.dot(normal) > same_normal;
    });
  }
  /// Takes out those on ridges that lie between two others with the same normal, or nearly, within a distance [m] of
  /// the line: they carry nothing that those do not, and impulses would be shared without end.
  void drop_between(double distance) {
    for (std::size_t k = size_; k-- > 0;) {
      if (!TouchPart::of(found_[k]).is_ridge() || !is_between_others(k, distance)) continue;
      std::move(found_.begin() + static_cast<std::ptrdiff_t>(k) + 1,
                found_.begin() + static_cast<std::ptrdiff_t>(size_), found_.begin() + static_cast<std::ptrdiff_t>(k));
      --size_;
    }
  }
  [[nodiscard]] std::span<const ContactPoint> all() const { return {found_.data(), size_}; }
  [[nodiscard]] ContactSet contacts() const {
    ContactSet set;
    if (size_ <= ContactSet::most) {
      for (std::size_t i = 0; i < size_; ++i) set.add(found_[i]);
      return set;
    }
    const Vec3& first = found_[0].arm;
    const auto farthest = [&](auto&& distance) {
      return *std::max_element(
          found_.begin(), found_.begin() + static_cast<std::ptrdiff_t>(size_),
          [&](const ContactPoint& a, const ContactPoint& b) { return distance(a.arm) < distance(b.arm); });
    };
    const ContactPoint second = farthest([&](const Vec3& arm) { return (arm - first).squared_norm(); });
    const Vec3 across = found_[0].normal.cross(second.arm - first);
    const auto aside = [&](const Vec3& arm) { return (arm - first).dot(across); };
    const ContactPoint left = farthest(aside), right = farthest([&](const Vec3&arm) { return -aside(arm); });
    set.add(found_[0]);
    set.add(second);
    const double rounding = 1e-9 * across.squared_norm();
    if (aside(left.arm) > rounding) set.add(left);
    if (aside(right.arm) < -rounding) set.add(right);
    return set;
  }

 private:
  static constexpr double same_normal = 0.999;  // the cosine of 2.6 degrees
  [[nodiscard]] bool is_between_others(std::size_t k, double distance) const {
    const ContactPoint& point = found_[k];
    const auto is_other = [&](std::size_t i) { return i != k && found_[i].normal.dot(point.normal) > same_normal; };
    for (std::size_t i = 0; i < size_; ++i) {
      if (!is_other(i)) continue;
      for (std::size_t j = i + 1; j < size_; ++j) {
        if (!is_other(j)) continue;
        const Vec3 line = found_[j].arm - found_[i].arm, way = point.arm - found_[i].arm;
        const double along = way.dot(line), squared = line.squared_norm();
        if (along < 0 || along > squared) continue;
        if (way.cross(line).squared_norm() <= distance * distance * squared) return true;
      }
    }
    return false;
  }

  std::array<ContactPoint, 64> found_;
  std::size_t size_ = 0;
};

/// The clearance of what is so far from the ground, at most.
template <class Surface>
[[nodiscard]] double vertically(const Surface& surface, double distance) {
  constexpr double steepest = 1e3;
  if constexpr (requires { surface.slant(); }) {
    return std::min(steepest, surface.slant() * (1 + tolerance::share_by_rounding)) * distance;
  } else {
    return steepest * distance;
  }
}

/// Where a corner with this clearance touches the ground within `tolerance` [m], or has sunk into it.
template <class Surface>
[[nodiscard]] std::optional<ContactPoint> touch_of(const Surface& surface, const Posture& body, std::size_t corner,
                                                   double gap, double tolerance) {
  if (!(gap <= vertically(surface, tolerance))) return std::nullopt;
  const Vec3 arm = body.arm(corner), place = body.centre + arm;
  const auto below = surface.ground_below({place.xy(), place.z() - std::min(gap, 0.0) + contact_slack});
  if (!below) return std::nullopt;
  const Vec3 normal = surface.normal(below->facet);
  if (gap > tolerance && gap * normal.z() > tolerance) return std::nullopt;
  return ContactPoint{arm, normal, below->facet, static_cast<std::uint32_t>(corner), gap * normal.z()};
}

/// Whether ground falls away from a plane through a ridge of it, or lies nearly in it.
[[nodiscard]] inline bool falls_away(const Vec3& place, const Vec3& normal, const Vec3& far) {
  constexpr double max_rise = 0.01;  // a slope
  return normal.dot(far - place) <= max_rise * (far - place).norm();
}

/// Whether ground can carry a body with this normal at a point of a ridge. A face that passes along the ground over a
/// ridge, and is in it by rounding, is not stopped there.
template <class Surface>
[[nodiscard]] bool carries(const Surface& surface, const Ridge& ridge, const RidgeGap& at, const Vec3& place,
                           const Vec3& normal, double min_bend) {
  for (const Vec3& far : surface.beside(ridge)) {
    if (!falls_away(place, normal, far)) return false;
  }
  if (at.s > 0 && at.s < 1) return true;
  bool all_fall = true;
  const Vec3 slack = Vec3::all(contact_slack);
  surface.visit_ridges(place - slack, place + slack, min_bend, [&](const Ridge& other) {
    all_fall = all_fall && falls_away(place, normal, other.from) && falls_away(place, normal, other.to);
  });
  return all_fall;
}

/// Contacts on a ridge that are nearer to another, or to the line between two others, are none of their own: a share of
/// the body's reach.
inline constexpr double one_place = 0.1;

/// Adds the contacts of a ridge with a body that it touches within `tolerance` [m]: one, or, of a ridge along a face,
/// both ends of the part that touches.
template <class Surface>
void add_ridge(const Surface& surface, const Posture& body, const Ridge& ridge, const RidgeGap& at, double tolerance,
               Touched& touched) {
  const Vec3 along = ridge.to - ridge.from, place = ridge.from + at.s * along, normal = normal_at(body, at);
  if (!carries(surface, ridge, at, place, normal, min_bend(body))) return;
  const auto add = [&](const Vec3& point) {
    const Vec3 arm = point + at.gap * normal - body.centre;  // of the body's own point
    if (!touched.has_near(arm, normal, one_place * body.reach))
      touched.add({arm, normal, ridge.facet, TouchPart::of(ridge).corner, at.gap});
  };
  const auto [from, to] = part_within(body, ridge, std::min(at.gap, 0.0) + tolerance);
  if ((to - from) * along.norm() > one_place * body.reach) {
    add(ridge.from + from * along);
    add(ridge.from + to * along);
  } else {
    add(place);
  }
}

/// A contact in another posture of the body. `centre`: of the body where it was found.
[[nodiscard]] inline Vec3 arm_in(const Posture& then, const ContactPoint& contact, const Vec3& centre) {
  return TouchPart::of(contact).is_ridge() ? contact.arm + centre - then.centre : then.arm(contact.corner);
}
/// How far apart body and ground are then, along the normal of the contact [m].
template <class Surface>
[[nodiscard]] double gap_in(const Surface& surface, const Posture& then, const ContactPoint& contact) {
  const TouchPart part = TouchPart::of(contact);
  if (!part.is_ridge()) return clearance(surface, then.place(contact.corner)) * contact.normal.z();
  const auto at =
      ridge_gap(then, then.hull->all, surface.ridge(part.facet, part.side()), std::numeric_limits<double>::infinity());
  return at ? at->gap : 0;
}

/// Where a body touches the ground within `tolerance` [m], or has sunk into it: its corners, then ridges. `first`: the
/// part whose contact comes first.
template <class Surface>
[[nodiscard]] Touched touched_by(const Surface& surface, const Posture& body, double tolerance,
                                 std::optional<TouchPart> first = {}) {
  Touched touched;
  const auto look_at = [&](std::size_t corner, double gap) {
    if (const auto touch = touch_of(surface, body, corner, gap, tolerance)) touched.add(*touch);
  };
  const auto look_at_ridge = [&](const Ridge& ridge) {
    if (const auto at = ridge_gap(body, body.hull->all, ridge, tolerance)) {
      add_ridge(surface, body, ridge, *at, tolerance, touched);
    }
  };
  if (first && first->is_ridge()) {
    look_at_ridge(surface.ridge(first->facet, first->side()));
  } else if (first) {
    look_at(first->corner, clearance(surface, body.place(first->corner)));
  }
  auto below = under(surface, body);
  const double bound = vertically(surface, tolerance);
  below.visit_low_corners(bound, [&](std::size_t corner, double gap) {
    if (TouchPart::of_corner(corner) != first) look_at(corner, gap);
    return bound;
  });
  if (!body.has_faces()) return touched;
  below.visit_ridges(below.slant() * tolerance, min_bend(body),
                     [&](const Ridge& ridge, const RidgePart& part, std::span<const std::uint32_t> faces) {
                       if (TouchPart::of(ridge) == first) return;
                       if (ridge_gap(body, faces, ridge, tolerance, part)) look_at_ridge(ridge);
                     });
  touched.drop_between(one_place * body.reach);
  return touched;
}

/// Where corners that are in the ground `at` have come through its surface on the way `from` there, and then where the
/// body touches it otherwise.
template <class Surface>
[[nodiscard]] Touched struck_between(const Surface& surface, const Posture& from, const Posture& at, double tolerance) {
  Touched touched;
  under(surface, at).visit_low_corners(0, [&](std::size_t corner, double gap) {
    if (gap > 0) return 0.0;
    const Vec3 arm = from.arm(corner), start = from.centre + arm;
    if (const auto near = touch_of(surface, from, corner, clearance(surface, start), tolerance)) {
      touched.add(*near);
    } else if (const auto met = surface.first_contact({start, at.place(corner) - start, Vec3{}}, 0, 1, {})) {
      touched.add({arm, met->normal, met->facet, static_cast<std::uint32_t>(corner)});
    }
    return 0.0;
  });
  const Touched otherwise = touched_by(surface, from, tolerance);
  for (const ContactPoint& near : otherwise.all()) {
    if (!touched.has_near(near.arm, near.normal, 0)) touched.add(near);
  }
  return touched;
}

}  // namespace talus
