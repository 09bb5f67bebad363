#include "talus/impact/rigid_sphere.hpp"

#include <algorithm>
#include <cmath>

#include "talus/core/tolerances.hpp"
#include "talus/impact/crsp.hpp"

namespace talus {

namespace {

using tolerance::no_slip;

Vec3 contact_point_velocity(const Vec3& velocity, const Vec3& spin, const Vec3& n, double radius) {
  return velocity - radius * spin.cross(n);
}

/// The share s of `added`, at most 1, with |given + s added| <= most.
double share_within(const Vec3& given, const Vec3& added, double most) {
  const double a = added.squared_norm(), b = given.dot(added), c = most * most - given.squared_norm();
  if (c <= 0 || a == 0) return 0;
  return std::min(1.0, c / (b + std::sqrt(b * b + a * c)));
}

/// After the moment impulse `moment` against the spin [N m s]. `jt`: the friction impulse so far, of which there may be
/// `most`; both 0 if the contact slips.
Rebound resisted(const Rebound& rebound, const Vec3& n, const Rock& rock, double moment, const Vec3& jt, double most) {
  const double m = rock.mass, r = rock.radius;
  const Vec3 rolling = tangential(rebound.spin, n);
  const double spin = rolling.norm();
  if (spin == 0) return rebound;
  const Vec3 axis = rolling / spin, heading = axis.cross(n);
  // The friction that keeps the contact from slipping backwards. It must not drive a sphere that slips forwards.
  const Vec3 reaction = -(moment * m * r / (m * r * r + rock.inertia)) * heading;
  const bool helps = contact_point_velocity(rebound.velocity, rebound.spin, n, r).dot(heading) >= -no_slip;
  const double share = helps ? share_within(jt, reaction, most) : 0;
  const double spun_down = (moment - share * reaction.norm() * r) / rock.inertia;
  const double part = spun_down > spin ? spin / spun_down : 1;
  return {rebound.velocity + part * share / m * reaction, rebound.spin - part * spun_down * axis};
}

}  // namespace

Rebound rigid_sphere_rebound(const Vec3& velocity, const Vec3& spin, const Vec3& n, const Rock& rock,
                             Restitution restitution, ContactFriction friction) {
  const double m = rock.mass, r = rock.radius;
  const Vec3 u = contact_point_velocity(velocity, spin, n, r);
  const double un = u.dot(n);
  const Vec3 ut = u - un * n;
  const double jn = (1 + restitution.normal) * m * std::max(-un, 0.0);
  Vec3 jt = -(1 - restitution.tangential) * ut / (1 / m + r * r / rock.inertia);
  const double unlimited = jt.norm(), most = friction.dynamic * jn;
  const bool slips = unlimited > most;
  if (slips) jt *= most / unlimited;
  const Rebound rebound{velocity + (jn * n + jt) / m, spin - r / rock.inertia * n.cross(jt)};
  if (friction.rolling == 0 || jn == 0) return rebound;
  return resisted(rebound, n, rock, friction.rolling * jn * r, slips ? Vec3{} : jt, slips ? 0 : most);
}

double crsp_damped_tangential_restitution(const Vec3& velocity, const Vec3& spin, const Vec3& n, const Rock& rock,
                                          Restitution restitution) {
  const Vec3 u = contact_point_velocity(velocity, spin, n, rock.radius);
  const double slip = tangential(u, n).norm();
  return std::sqrt(crsp_friction_function(slip, restitution.tangential) *
                   crsp_scaling_factor(velocity.dot(n), restitution));
}

}  // namespace talus
