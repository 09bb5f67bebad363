#include "talus/impact/crsp.hpp"

#include <cmath>

namespace talus {

double crsp_scaling_factor(double vn, Restitution restitution) {
  if (restitution.normal <= 0) return 0;
  const double q = vn / (crsp_f2 * restitution.normal);
  return restitution.tangential / (q * q + 1);
}

double crsp_friction_function(double slip_speed, double rt) {
  const double q = slip_speed / crsp_f1;
  return rt + (1 - rt) / (q * q + 1.2);
}

Rebound crsp_rebound(const Vec3& velocity, const Vec3& spin, const Vec3& n, const Rock& rock, Restitution restitution) {
  const double r = rock.radius;
  const double vn = velocity.dot(n), wn = spin.dot(n);
  const Vec3 vt = velocity - vn * n, wt = spin - wn * n;
  const double vt_length = vt.norm(), wt_length = wt.norm();

  // The frame. Spin that moves the rock's skin less than a billionth of its speed is rounding, not spin.
  const bool spins = wt_length * r > 1e-9 * vt_length;
  if (!spins && vt_length == 0) return {-restitution.normal * vn * n, wn * n};
  const Vec3 t1 = spins ? Vec3(wt.cross(n) / wt_length) : Vec3(vt / vt_length);
  const Vec3 t2 = n.cross(t1);
  const double v1 = vt.dot(t1), v2 = spins ? vt.dot(t2) : 0;
  const double w2 = spins ? wt_length : 0;  // and w1 = 0 in this frame

  const double slip_1 = v1 - w2 * r, slip = std::sqrt(slip_1 * slip_1 + v2 * v2);
  const double kept = r * r * crsp_friction_function(slip, restitution.tangential) *
                      crsp_scaling_factor(vn, restitution) / (rock.inertia + rock.mass * r * r);
  const double direction = v1 != 0 ? v1 : w2;
  const double v1_after = std::copysign(std::sqrt(kept * (rock.inertia * w2 * w2 + rock.mass * v1 * v1)), direction);
  const double v2_after = std::copysign(std::sqrt(kept * rock.mass * v2 * v2), v2);
  return {-restitution.normal * vn * n + v1_after * t1 + v2_after * t2, wn * n - v2_after / r * t1 + v1_after / r * t2};
}

}  // namespace talus
