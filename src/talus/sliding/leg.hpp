#pragma once
// Motion along the ground, a leg at a time. A leg has constant acceleration; how long it lasts and how the next one
// begins is the law's business (closed_form.hpp, stepped.hpp, rolling.hpp), where it is cut short - at a facet's edge,
// at a barrier - the caller's.

#include "talus/core/tolerances.hpp"
#include "talus/flight/parabola.hpp"

namespace talus {

/// What pulls a rock that moves along the ground, and what the ground carries of it, per unit of its mass.
struct Footing {
  Vec3 pull;                       // gravity along the directions in which it can move [m/s2]
  double normal_acceleration = 0;  // sum of the normal forces, over its mass [m/s2]

  /// On a facet of unit normal `n`. The normal acceleration is negative where gravity pulls away from
  /// it.
  [[nodiscard]] static Footing on_plane(const Vec3& gravity, const Vec3& n) {
    const double gn = gravity.dot(n);
    return {gravity - gn * n, -gn};
  }
};

/// Whether friction of coefficient `mu` keeps a rock there that does not move.
[[nodiscard]] inline bool holds(const Footing& footing, double mu) {
  return footing.normal_acceleration > 0 &&
         footing.pull.norm() <= (mu + tolerance::friction_by_rounding) * footing.normal_acceleration;
}

/// Whether a rock with this heading stays on a straight line: the pull has no part across it but rounding.
[[nodiscard]] inline bool is_straight(const Footing& footing, const Vec3& heading) {
  return footing.pull.cross(heading).norm() <= tolerance::straight_pull * footing.pull.norm();
}

/// What is left of a velocity when its part along the heading has come to zero.
[[nodiscard]] inline Vec3 halted(const Vec3& velocity, const Footing& footing, const Vec3& heading) {
  return is_straight(footing, heading) ? Vec3(Vec3::Zero()) : tangential(velocity, heading);
}

struct Leg {
  Parabola path;        // of the centre
  double duration = 0;  // [s]; infinite for a closed form that only something else ends
  Vec3 end_velocity = Vec3::Zero();
  Vec3 end_spin = Vec3::Zero();
};

/// What is left of a leg where two facets, touched at once, let the rock move along the unit vector `e` only.
[[nodiscard]] inline Leg guided(const Leg& leg, const Vec3& e) {
  return {{leg.path.p, leg.path.v.dot(e) * e, leg.path.a.dot(e) * e},
          leg.duration,
          leg.end_velocity.dot(e) * e,
          leg.end_spin};
}

}  // namespace talus
