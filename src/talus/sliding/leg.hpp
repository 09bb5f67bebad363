#pragma once
// Motion along the ground, leg by leg. A leg has constant acceleration. The laws (closed_form.hpp, stepped.hpp,
// rolling.hpp) determine its duration and the motion at its end; the caller cuts it short at a facet's edge or a
// barrier.

#include "talus/core/tolerances.hpp"
#include "talus/rocks/parabola.hpp"

namespace talus {

/// The forces on a rock that moves along the ground, per unit of its mass: the pull of gravity and the normal force.
struct Footing {
  Vec3 pull;                       // the part of gravity along the directions in which it can move [m/s2]
  double normal_acceleration = 0;  // sum of the normal forces over its mass [m/s2]

  /// On a facet of unit normal `n`. The normal acceleration is negative if gravity pulls away from the facet.
  [[nodiscard]] static Footing on_plane(const Vec3& gravity, const Vec3& n) {
    const double gn = gravity.dot(n);
    return {gravity - gn * n, -gn};
  }
};

/// Whether friction of coefficient `mu` holds a rock that does not move.
[[nodiscard]] inline bool holds(const Footing& footing, double mu) {
  return footing.normal_acceleration > 0 &&
         footing.pull.norm() <= (mu + tolerance::friction_by_rounding) * footing.normal_acceleration;
}

/// Whether a rock with this heading stays on a straight line: the pull has no component across it, except by rounding.
[[nodiscard]] inline bool is_straight(const Footing& footing, const Vec3& heading) {
  return footing.pull.cross(heading).norm() <= tolerance::straight_pull * footing.pull.norm();
}

/// A velocity whose component along the heading has become zero.
[[nodiscard]] inline Vec3 halted(const Vec3& velocity, const Footing& footing, const Vec3& heading) {
  return is_straight(footing, heading) ? Vec3{} : tangential(velocity, heading);
}

struct Leg {
  Parabola path;        // of the centre
  double duration = 0;  // [s]; infinite for a closed form without rest or reversal
  Vec3 end_velocity;
  Vec3 end_spin;
};

/// The leg of a rock that touches two facets at once, so that it can only move along the unit vector `e`.
[[nodiscard]] inline Leg guided(const Leg& leg, const Vec3& e) {
  return {{leg.path.p, leg.path.v.dot(e) * e, leg.path.a.dot(e) * e},
          leg.duration,
          leg.end_velocity.dot(e) * e,
          leg.end_spin};
}

}  // namespace talus
