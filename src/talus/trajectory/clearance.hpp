#pragma once
// How far the corners of a body are above the ground, and where they touch it. Private to trajectory/.
//
// Corners of the body are tested against the ground; corners and edges of the ground against the body are not: a ridge
// or a spike narrower than a face of the body may sink into that face.

#include <algorithm>
#include <limits>
#include <optional>

#include "talus/impact/contact_set.hpp"
#include "talus/rocks/shape.hpp"
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

/// Calls visit(corner, clearance) for each corner of a body that may be no higher than a bound; it returns the bound
/// from there on.
template <class Surface, class Visit>
void visit_low_corners(const Surface& surface, const Posture& body, double bound, Visit&& visit) {
  if constexpr (requires { surface.visit_low_corners(body, bound, visit); }) {
    if (!surface.may_overhang()) return surface.visit_low_corners(body, bound, visit);
  }
  for (std::size_t i = 0; i < body.corners.size(); ++i) visit(i, clearance(surface, body.place(i)));
}

/// The corner of a body that has the least clearance [m].
struct LowestCorner {
  std::size_t corner = 0;
  double gap = std::numeric_limits<double>::infinity();
};

template <class Surface>
[[nodiscard]] LowestCorner lowest_corner(const Surface& surface, const Posture& body) {
  LowestCorner lowest;
  visit_low_corners(surface, body, lowest.gap, [&](std::size_t corner, double gap) {
    if (gap < lowest.gap) lowest = {corner, gap};
    return lowest.gap;
  });
  return lowest;
}

/// The contacts of a body, the first 64 of them. Of more than a set holds, those that hold the body as all of them do:
/// the first, the farthest from it, the farthest from the line through both, and the farthest on the line's other side.
class Touched {
 public:
  void add(const ContactPoint& point) {
    if (size_ < found_.size()) found_[size_++] = point;
  }
  [[nodiscard]] bool is_empty() const { return size_ == 0; }
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

/// Where corners within `tolerance` [m] of the ground touch it, or have sunk into it. `first`: the corner whose contact
/// comes first.
template <class Surface>
[[nodiscard]] Touched touched_by(const Surface& surface, const Posture& body, double tolerance,
                                 std::optional<std::size_t> first = {}) {
  Touched touched;
  const auto look_at = [&](std::size_t corner, double gap) {
    if (const auto touch = touch_of(surface, body, corner, gap, tolerance)) touched.add(*touch);
  };
  if (first) look_at(*first, clearance(surface, body.place(*first)));
  const double bound = vertically(surface, tolerance);
  visit_low_corners(surface, body, bound, [&](std::size_t corner, double gap) {
    if (corner != first) look_at(corner, gap);
    return bound;
  });
  return touched;
}

/// Where corners that are in the ground `at` have come through its surface on the way `from` there, and then where
/// others touch it.
template <class Surface>
[[nodiscard]] Touched struck_between(const Surface& surface, const Posture& from, const Posture& at, double tolerance) {
  Touched touched;
  visit_low_corners(surface, at, 0, [&](std::size_t corner, double gap) {
    if (gap > 0) return 0.0;
    const Vec3 arm = from.arm(corner), start = from.centre + arm;
    if (const auto near = touch_of(surface, from, corner, clearance(surface, start), tolerance)) {
      touched.add(*near);
    } else if (const auto met = surface.first_contact({start, at.place(corner) - start, Vec3{}}, 0, 1, {})) {
      touched.add({arm, met->normal, met->facet, static_cast<std::uint32_t>(corner)});
    }
    return 0.0;
  });
  const ContactSet struck = touched.contacts();
  const double bound = vertically(surface, tolerance);
  visit_low_corners(surface, from, bound, [&](std::size_t corner, double gap) {
    const bool is_known =
        std::any_of(struck.begin(), struck.end(), [&](const ContactPoint& known) { return known.corner == corner; });
    if (is_known) return bound;
    if (const auto near = touch_of(surface, from, corner, gap, tolerance)) touched.add(*near);
    return bound;
  });
  return touched;
}

}  // namespace talus
