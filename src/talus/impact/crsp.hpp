#pragma once
// Impact of a lumped mass with rotation: the law of the Colorado Rockfall Simulation Program (CRSP).
//
// Source: verification manual, section 2.3; Pfeiffer and Bowen, "Computer simulation of rockfalls", Bulletin of the
// Association of Engineering Geologists 26 (1989). Symbols:
//   vn, v1, v2   velocity along n, t1, t2 [m/s]     w1, w2   spin about t1, t2 [rad/s]
//   r, m, I      radius, mass, inertia              Rn, Rt   restitution
//
//   SF   = Rt / ((vn / (f2 Rn))^2 + 1)                                            scaling factor
//   f(F) = Rt + (1 - Rt) / (((v1 - w2 r)/f1)^2 + ((v2 + w1 r)/f1)^2 + 1.2)         friction function
//   vn'  = -Rn vn
//   v1'  = sign(v1) sqrt(r^2 (I w2^2 + m v1^2) f(F) SF / (I + m r^2)),  w2' =  v1'/r
//   v2'  = sign(v2) sqrt(r^2 (I w1^2 + m v2^2) f(F) SF / (I + m r^2)),  w1' = -v2'/r
//
// The manual prints vn^2/(f2 Rn) in SF; its number 0.65422 requires the square of the whole quotient. In the tangent
// frame a spinning rock has w1 = 0 (t2 along the tangential spin, t1 = t2 x n); a rock without spin has t1 along its
// tangential velocity. The manual does not state this; its table 2-4 requires it. With Rn = 0 the scaling factor is 0:
// the rock keeps no tangential speed. Nothing of the published law is left out. Tested against tables 2-4 and 2-5.

#include "talus/impact/restitution.hpp"

namespace talus {

inline constexpr double crsp_f1 = 6.096;  // [m/s], 20 ft/s
inline constexpr double crsp_f2 = 76.2;   // [m/s], 250 ft/s

/// The scaling factor SF for the impact's normal speed.
[[nodiscard]] double crsp_scaling_factor(double vn, Restitution restitution);
/// The friction function f(F) for the slip speed of the contact point.
[[nodiscard]] double crsp_friction_function(double slip_speed, double rt);

/// A rock's motion before an impact, in the tangent frame: the part of the law that does not depend on restitution.
struct CrspImpact {
  Vec3 n, t1, t2;
  double vn = 0, wn = 0;  // [m/s], [rad/s]
  double v1 = 0, v2 = 0, w2 = 0;
  double slip = 0;  // speed of the contact point along the ground [m/s]
};

/// `n`: unit normal, out of the ground.
[[nodiscard]] CrspImpact crsp_impact(const Vec3& velocity, const Vec3& spin, const Vec3& n, double radius);

[[nodiscard]] Rebound crsp_rebound(const CrspImpact& impact, const Rock& rock, Restitution restitution);

[[nodiscard]] inline Rebound crsp_rebound(const Vec3& velocity, const Vec3& spin, const Vec3& n, const Rock& rock,
                                          Restitution restitution) {
  return crsp_rebound(crsp_impact(velocity, spin, n, rock.radius), rock, restitution);
}

/// The impact law (law.hpp) of a lumped mass with rotation.
struct CrspLaw {
  template <class DrawRestitution, class DrawFriction>
  [[nodiscard]] Rebound rebound(const Approach& a, DrawRestitution&& restitution, DrawFriction&&) const {
    // Computed before the draws, which take as long and do not depend on it: both can run at the same time.
    const CrspImpact impact = crsp_impact(a.velocity, a.spin, a.normal(), a.rock.radius);
    return crsp_rebound(impact, a.rock, restitution());
  }
};

}  // namespace talus
