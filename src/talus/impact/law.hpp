#pragma once
// The list of impact laws. The law is chosen once per run.
//
// A law is a type with
//   rebound(approach, restitution, friction) -> Rebound
// where restitution() draws the ground's coefficients and friction() its dynamic friction, each called at most once:
// what a law does not need is not drawn. To add a law: a file with its equations, a type here and its name in the list,
// and a line in Laws::impact_law() (trajectory/scene.hpp).

#include <variant>

#include "talus/impact/crsp.hpp"
#include "talus/impact/plain.hpp"
#include "talus/impact/rigid_sphere.hpp"

namespace talus {

/// A rock's motion before an impact.
struct Approach {
  const Vec3& velocity;  // [m/s]
  const Vec3& spin;      // [rad/s]
  const Vec3& normal;    // unit, out of the ground, roughness included
  const Rock& rock;
};

/// Lumped mass without rotation (plain.hpp).
struct PlainImpact {
  template <class DrawRestitution, class DrawFriction>
  [[nodiscard]] Rebound rebound(const Approach& a, DrawRestitution&& restitution, DrawFriction&&) const {
    return plain_rebound(a.velocity, a.spin, a.normal, restitution());
  }
};

/// Lumped mass with rotation (crsp.hpp).
struct CrspLaw {
  template <class DrawRestitution, class DrawFriction>
  [[nodiscard]] Rebound rebound(const Approach& a, DrawRestitution&& restitution, DrawFriction&&) const {
    // Computed before the draws, which take as long and do not depend on it: both can run at the same time.
    const CrspImpact impact = crsp_impact(a.velocity, a.spin, a.normal, a.rock.radius);
    return crsp_rebound(impact, a.rock, restitution());
  }
};

/// Rigid sphere (rigid_sphere.hpp).
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
