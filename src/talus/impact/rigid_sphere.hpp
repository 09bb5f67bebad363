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
//
// Rolling resistance of the impulse (not in RocFall): while the impulse Jn acts, so does the moment that resists
// rolling on the ground, with Jn in place of the normal force (sliding/rolling.hpp), in total K = mu_r r Jn against the
// spin. A contact that does not slip passes its share on to the velocity,
//   dv = -K r/(m r^2 + I),  r dw = dv;   at most mu Jn of friction in all; a contact that slips: dw = -K/I.
// It ends the rolling at most. A sphere that bounces along the ground thus loses what one that rolls there loses: over
// a stretch of ground the impulses of both are the same.

#include "talus/impact/restitution.hpp"
#include "talus/rocks/contact_friction.hpp"

namespace talus {

/// With a rolling friction of 0, the law of the manual.
[[nodiscard]] Rebound rigid_sphere_rebound(const Vec3& velocity, const Vec3& spin, const Vec3& n, const Rock& rock,
                                           Restitution restitution, ContactFriction friction);

/// "Tangential CRSP damping" for the rigid sphere: the tangential restitution sqrt(f(F) SF), with f(F) and SF of
/// crsp.hpp. The manual names the option without an equation; CRSP's product f(F) SF scales an energy, hence the root.
[[nodiscard]] double crsp_damped_tangential_restitution(const Vec3& velocity, const Vec3& spin, const Vec3& n,
                                                        const Rock& rock, Restitution restitution);

/// The impact law (law.hpp) of a rigid sphere.
struct RigidSphereImpact {
  bool has_crsp_damping = false;       // of the tangential restitution
  bool has_rolling_resistance = true;  // of the impulse

  template <class DrawRestitution, class DrawFriction>
  [[nodiscard]] Rebound rebound(const Approach& a, DrawRestitution&& restitution, DrawFriction&& friction) const {
    Restitution drawn = restitution();
    if (has_crsp_damping) {
      drawn.tangential = crsp_damped_tangential_restitution(a.velocity, a.spin, a.normal(), a.rock, drawn);
    }
    ContactFriction drawn_friction = friction();
    if (!has_rolling_resistance) drawn_friction.rolling = 0;
    return rigid_sphere_rebound(a.velocity, a.spin, a.normal(), a.rock, drawn, drawn_friction);
  }
};

}  // namespace talus
