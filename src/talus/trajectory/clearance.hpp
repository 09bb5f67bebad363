#pragma once
// How far the corners of a body are above the ground, and where they touch it. Private to trajectory/.
//
// Corners of the body are tested against the ground; corners and edges of the ground against the body are not: a ridge
// or a spike narrower than a face of the body may sink into that face.

#include <algorithm>
#include <limits>
#include <optional>

#include "talus/core/orientation.hpp"
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

/// A body in one place.
struct Posture {
  Vec3 centre;
  Mat3 turned;  // from the body's frame to that of the terrain

  [[nodiscard]] Vec3 place(const Body& body, std::size_t corner) const { return centre + turned * body.corner(corner); }
};

/// The least clearance of a body's corners [m].
template <class Surface>
[[nodiscard]] double clearance(const Surface& surface, const Body& body, const Posture& at) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < body.corners.size(); ++i) least = std::min(least, clearance(surface, at.place(body, i)));
  return least;
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

/// Where corners within `tolerance` [m] of the ground touch it, or have sunk into it.
template <class Surface>
[[nodiscard]] Touched touched_by(const Surface& surface, const Body& body, const Posture& at, double tolerance) {
  Touched touched;
  for (std::size_t i = 0; i < body.corners.size(); ++i) {
    const Vec3 place = at.place(body, i);
    const double gap = clearance(surface, place);
    if (!(gap <= 1e3 * tolerance)) continue;  // no facet is so steep
    const auto below = surface.ground_below({place.xy(), place.z() - std::min(gap, 0.0) + contact_slack});
    if (!below) continue;
    const Vec3 normal = surface.normal(below->facet);
    if (gap > tolerance && gap * normal.z() > tolerance) continue;
    touched.add({place - at.centre, normal, below->facet, static_cast<std::uint32_t>(i)});
  }
  return touched;
}

/// Where corners that are in the ground `at` have come through its surface on the way `from` there.
template <class Surface>
[[nodiscard]] Touched struck_between(const Surface& surface, const Body& body, const Posture& from, const Posture& at,
                                     double tolerance) {
  Touched touched;
  for (std::size_t i = 0; i < body.corners.size(); ++i) {
    const Vec3 start = from.place(body, i), way = at.place(body, i) - start;
    if (clearance(surface, start + way) > 0) continue;
    const auto contact = surface.first_contact({start, way, Vec3{}}, 0, 1, {});
    if (contact) touched.add({start - from.centre, contact->normal, contact->facet, static_cast<std::uint32_t>(i)});
  }
  const ContactSet struck = touched.contacts();
  const Touched others = touched_by(surface, body, from, tolerance);
  for (const ContactPoint& near : others.contacts()) {
    const bool is_known = std::any_of(struck.begin(), struck.end(),
                                      [&](const ContactPoint& known) { return known.corner == near.corner; });
    if (!is_known) touched.add(near);
  }
  return touched;
}

}  // namespace talus
