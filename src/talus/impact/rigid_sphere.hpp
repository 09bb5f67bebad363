#pragma once
// Impact of a rigid sphere: restitution at the contact point, limited by Coulomb friction.
//
// Source: verification manual, section 7.3, its matrix form written for a sphere, with the dynamic friction limit.
//   rc = -r n           from the centre to the contact point
//   u  = v + w x rc     velocity of the contact point; un = u . n, ut = u - un n
//   target: un' = -Rn un, ut' = Rt ut;  impulses Jn = (1 + Rn) m |un|,  Jt = -(1 - Rt) ut / (1/m + r^2/I)
//   if |Jt| > mu Jn the contact slips and Jt is scaled to mu Jn
//   v' = v + J/m,  w' = w + (rc x J)/I
// RocFall3's table C-2 is this law with Rt = 0.68, RocFall2's table C-1 with Rt = 0.

#include "talus/impact/restitution.hpp"

namespace talus {

/// `mu`: coefficient of dynamic friction.
[[nodiscard]] Rebound rigid_sphere_rebound(const Vec3& velocity, const Vec3& spin, const Vec3& n, const Rock& rock,
                                           Restitution restitution, double mu);

/// "Tangential CRSP damping" for the rigid sphere: the tangential restitution sqrt(f(F) SF), with f(F) and SF of
/// crsp.hpp. The manual names the option without an equation; CRSP's product f(F) SF scales an energy, hence the root.
[[nodiscard]] double crsp_damped_tangential_restitution(const Vec3& velocity, const Vec3& spin, const Vec3& n,
                                                        const Rock& rock, Restitution restitution);

/// The impact law (law.hpp) of a rigid sphere.
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

}  // namespace talus
