#pragma once
// The impact laws there are, behind one door: a law is chosen once and asked at every impact.
//
// A law is a type with
//   rebound(approach, restitution, friction) -> Rebound
// where restitution() draws the ground's coefficients and friction() its dynamic friction, each at most once: what a
// law does not need is not drawn. To add one: a file here with its equations, a type here, its name in the list, and in
// impact_law() when it is meant.

#include <variant>

#include "talus/impact/crsp.hpp"
#include "talus/impact/plain.hpp"
#include "talus/impact/rigid_sphere.hpp"

namespace talus {

/// How a rock comes to the ground.
struct Approach {
  const Vec3& velocity;  // [m/s]
  const Vec3& spin;      // [rad/s]
  const Vec3& normal;    // unit, out of the ground as the rock meets it, roughness included
  const Rock& rock;
};

/// A lumped mass without rotation (plain.hpp).
struct PlainImpact {
  template <class DrawRestitution, class DrawFriction>
  [[nodiscard]] Rebound rebound(const Approach& a, DrawRestitution&& restitution, DrawFriction&&) const {
    return plain_rebound(a.velocity, a.spin, a.normal, restitution());
  }
};

/// A lumped mass with rotation (crsp.hpp).
struct CrspLaw {
  template <class DrawRestitution, class DrawFriction>
  [[nodiscard]] Rebound rebound(const Approach& a, DrawRestitution&& restitution, DrawFriction&&) const {
    // Before the draws, which take as long as it does and do not wait for it.
    const CrspImpact impact = crsp_impact(a.velocity, a.spin, a.normal, a.rock.radius);
    return crsp_rebound(impact, a.rock, restitution());
  }
};

/// A rigid sphere (rigid_sphere.hpp).
struct RigidSphereImpact {
  bool has_crsp_damping = false;  // of the tangential restitution

  template <class DrawRestitution, class DrawFriction>
  [[nodiscard]] Rebound rebound(const Approach& a, DrawRestitution&& restitution, DrawFriction&& friction) const {
    Restitution drawn = restitution();
    if (has_crsp_damping) {
      drawn.tangential = crsp_damped_tangential_restitution(a.velocity, a.spin, a.normal, a.rock, drawn);
    }
    return rigid_sphere_rebound(a.velocity, a.spin, a.normal, a.rock, drawn, friction());
  }
};

using ImpactLaw = std::variant<CrspLaw, PlainImpact, RigidSphereImpact>;

}  // namespace talus
