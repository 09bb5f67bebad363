#pragma once
// A rigid sphere in contact with the ground: it rolls, or slips with Coulomb friction, with rolling resistance.
//
// Per unit of mass, with n the normal, N the normal acceleration, g_t the pull, I = 2/5 m r^2, u = v + r n x w the slip
// velocity:
//  - rolling (u = 0): a = 5/7 (g_t - mu_r N v/|v|), with the friction -2/7 g_t - 5/7 mu_r N v/|v|; the contact slips
//    if that exceeds mu N. Straight down a plane of slope s this is a = 5/7 g (sin s - mu_r cos s). Along a valley,
//    where the contacts are nearer to the axis than the radius, 5/7 becomes m r^2 / (m r^2 + I).
//  - slipping: a = g_t - mu N u/|u|, I dw/dt = m mu N r (n x u/|u|) - m mu_r N r w_t/|w_t|, until u = 0. A leg has the
//    direction of u at its end.
// mu_r is the coefficient of rolling friction: a moment mu_r N r against the spin (physics of a ball on an inclined
// plane, any text on mechanics; rolling resistance as RocFall's "rolling friction").

#include "talus/rocks/contact_friction.hpp"
#include "talus/rocks/rock.hpp"
#include "talus/sliding/leg.hpp"

namespace talus {

/// The share of a force on its centre that accelerates a rolling sphere, m r^2 / (m r^2 + I); the rest changes its
/// spin.
[[nodiscard]] inline double rolling_share(const Rock& rock) {
  const double spun = rock.mass * rock.radius * rock.radius;
  return spun / (spun + rock.inertia);
}

/// The velocity of the contact point along the ground.
[[nodiscard]] inline Vec3 slip_velocity(const Vec3& velocity, const Vec3& spin, const Vec3& n, double radius) {
  return tangential(velocity, n) + radius * n.cross(spin);
}

/// The spin of a sphere that rolls at this velocity; its spin about the normal is kept.
[[nodiscard]] inline Vec3 rolling_spin(const Vec3& velocity, const Vec3& spin, const Vec3& n, double radius) {
  return n.cross(velocity) / radius + spin.dot(n) * n;
}

/// Whether friction holds a sphere that does not move.
[[nodiscard]] inline bool holds(const Footing& footing, ContactFriction friction) {
  return holds(footing, std::min(friction.dynamic, friction.rolling));
}

/// The next leg, of `timestep`, or shorter if the sphere stops, or slip ends and rolling begins. `velocity`: tangential
/// to the ground.
[[nodiscard]] Leg rolling_leg(const Vec3& position, const Vec3& velocity, const Vec3& spin, const Vec3& n,
                              const Footing& footing, const Rock& rock, ContactFriction friction, double timestep);

}  // namespace talus
