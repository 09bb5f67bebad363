#pragma once
// Moves a release point that is in the ground, or too near to it for its rock, up or down to where the rock fits.

#include <algorithm>
#include <optional>

#include "talus/core/id.hpp"
#include "talus/core/orientation.hpp"
#include "talus/rocks/parabola.hpp"
#include "talus/rocks/ridge.hpp"
#include "talus/rocks/touch.hpp"

namespace talus {

/// Whether a rock fits where it is to be released.
enum class Fit {
  as_given,
  moved,   // lifted, or lowered from a ceiling
  no_room  // between floor and ceiling
};

/// The elevation at which a rock can be released.
struct ClearPlace {
  double z;
  Fit fit = Fit::as_given;
};

namespace lift_detail {

constexpr double by_rounding = 1e-9;  // [m]

/// Raises a sphere that reaches into facets until it only touches them; each round clears the deepest one.
template <class Surface>
[[nodiscard]] Vec3 raised(const Surface& surface, Vec3 centre, double radius) {
  for (int round = 0; round < 64; ++round) {
    double rise = 0;
    surface.supports(centre, radius, 0, [&](const Vec3& away, const Vec3&, double distance, FacetId) {
      if (distance < radius - by_rounding) rise = std::max(rise, (radius - distance) / std::max(away.z(), 0.1));
    });
    if (rise == 0) break;
    centre.z() += rise;
  }
  return centre;
}

/// Whether there is no ground between a place in the open and an elevation straight above or below it.
template <class Surface>
[[nodiscard]] bool is_open(const Surface& surface, const Vec3& place, double z) {
  const auto ground_at = [&](double height) { return surface.elevation(place.x(), place.y(), height + contact_slack); };
  return !surface.may_overhang() || ground_at(place.z()) == ground_at(z);
}

/// The first elevation at which a sphere fits, straight up (`way` is 1) or down (-1) from a place in the open. Each
/// step is the depth of the nearest facet: the distance to a facet cannot change by more than the sphere moves.
template <class Surface>
[[nodiscard]] std::optional<double> clear_along(const Surface& surface, const Vec3& place, double radius, double way) {
  constexpr int most_steps = 1000;
  Vec3 centre = place;
  for (int step = 0; step < most_steps; ++step) {
    double nearest = radius;
    surface.supports(centre, radius, 0, [&](const Vec3&, const Vec3&, double distance, FacetId) {
      nearest = std::min(nearest, distance);
    });
    if (nearest >= radius - by_rounding) return centre.z();
    centre.z() += way * (radius - nearest);
    if (!is_open(surface, place, centre.z())) return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace lift_detail

/// Where a rock of this radius (0: a point) can be released: above the ground if the place is in it, and far enough
/// from all ground for the rock to fit. It is never moved through a ceiling.
template <class Surface>
[[nodiscard]] ClearPlace clear_place(const Surface& surface, const Vec3& place, double radius) {
  using namespace lift_detail;
  Vec3 open = place;
  if (const auto ground = surface.ground_over(place)) open.z() = *ground;
  Vec3 centre = radius > 0 ? raised(surface, open, radius) : open;
  if (!(centre.z() > place.z())) return {place.z()};
  if (radius > 0) {
    if (!is_open(surface, open, centre.z())) {
      auto z = clear_along(surface, open, radius, 1);
      if (!z) z = clear_along(surface, open, radius, -1);
      return z ? ClearPlace{*z, Fit::moved} : ClearPlace{open.z(), Fit::no_room};
    }
    // Next to an edge or a corner it was raised too far, and is lowered again until it touches.
    const double rise = centre.z() - place.z();
    const auto touched = surface.first_contact({centre, {0, 0, -1}, Vec3{}}, radius, rise);
    const double down = touched ? touched->t : rise;
    if (down > by_rounding) centre.z() -= down;
  }
  return centre.z() > place.z() ? ClearPlace{centre.z(), Fit::moved} : ClearPlace{place.z()};
}

/// How far a body must rise, at least, until no ridge of the ground below it is in it [m].
template <class Surface>
[[nodiscard]] double rise_over_ridges(const Surface& surface, const Posture& body) {
  if (!body.has_faces()) return 0;
  const Vec3 reach = Vec3::all(body.reach);
  double rise = 0;
  surface.visit_ridges(body.centre - reach, body.centre + reach, 0, [&](const Ridge& ridge) {
    const auto at = ridge_gap(body, body.hull->all, ridge, -lift_detail::by_rounding);
    if (at) rise = std::max(rise, height_in(body, ridge.from + at->s * (ridge.to - ridge.from)));
  });
  return rise;
}

/// Where a rock with a shape can be released, turned like this: as `place`, or raised until none of its corners is in
/// the ground, nor the ground in it, and it touches. It is never moved through a ceiling.
template <class Surface>
[[nodiscard]] ClearPlace clear_place(const Surface& surface, const Vec3& place, const Body& body,
                                     const Orientation& orientation) {
  using namespace lift_detail;
  constexpr int max_rounds =
      64;  // a corner may come into the next ground over it; of a ridge, another point is highest
  Vec3 open = place;
  if (const auto ground = surface.ground_over(place)) open.z() = *ground;
  Posture posture = body.at(place, orientation.matrix());
  for (int round = 0; round < max_rounds; ++round) {
    double rise = 0;
    for (std::size_t i = 0; i < body.corners.size(); ++i) {
      const Vec3 corner = posture.place(i);
      if (const auto ground = surface.ground_over(corner)) rise = std::max(rise, *ground - corner.z());
    }
    if (rise <= by_rounding) rise = rise_over_ridges(surface, posture);
    if (rise <= by_rounding) break;
    posture.centre.z() += rise;
  }
  const double z = posture.centre.z();
  if (!(z > place.z())) return {place.z()};
  return is_open(surface, open, std::max(open.z(), z)) ? ClearPlace{z, Fit::moved} : ClearPlace{open.z(), Fit::no_room};
}

}  // namespace talus
