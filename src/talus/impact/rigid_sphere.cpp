#include "talus/impact/rigid_sphere.hpp"

#include <algorithm>
#include <cmath>

#include "talus/impact/crsp.hpp"

namespace talus {

namespace {

Vec3 contact_point_velocity(const Vec3& velocity, const Vec3& spin, const Vec3& n, double radius) {
  return velocity - radius * spin.cross(n);
}

}  // namespace

Rebound rigid_sphere_rebound(const Vec3& velocity, const Vec3& spin, const Vec3& n, const Rock& rock,
                             Restitution restitution, double mu) {
  const double m = rock.mass, r = rock.radius;
  const Vec3 u = contact_point_velocity(velocity, spin, n, r);
  const double un = u.dot(n);
  const Vec3 ut = u - un * n;
  const double jn = (1 + restitution.normal) * m * std::max(-un, 0.0);
  Vec3 jt = -(1 - restitution.tangential) * ut / (1 / m + r * r / rock.inertia);
  const double unlimited = jt.norm();
  if (unlimited > mu * jn) jt *= mu * jn / unlimited;
  return {velocity + (jn * n + jt) / m, spin - r / rock.inertia * n.cross(jt)};
}

double crsp_damped_tangential_restitution(const Vec3& velocity, const Vec3& spin, const Vec3& n, const Rock& rock,
                                          Restitution restitution) {
  const Vec3 u = contact_point_velocity(velocity, spin, n, rock.radius);
  const double slip = tangential(u, n).norm();
  return std::sqrt(crsp_friction_function(slip, restitution.tangential) *
                   crsp_scaling_factor(velocity.dot(n), restitution));
}

}  // namespace talus
