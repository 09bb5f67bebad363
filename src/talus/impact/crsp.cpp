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

CrspImpact crsp_impact(const Vec3& velocity, const Vec3& spin, const Vec3& n, double radius) {
  CrspImpact impact;
  impact.n = n;
  impact.vn = velocity.dot(n);
  impact.wn = spin.dot(n);
  const Vec3 vt = velocity - impact.vn * n, wt = spin - impact.wn * n;
  const double vt_length = vt.norm(), wt_length = wt.norm();

  // The frame. Spin whose surface speed is below a billionth of the rock's speed is rounding.
  const bool spins = wt_length * radius > 1e-9 * vt_length;
  if (!spins && vt_length == 0) {
    impact.t1 = impact.t2 = Vec3{};
    return impact;
  }
  impact.t1 = spins ? wt.cross(n) / wt_length : vt / vt_length;
  impact.t2 = n.cross(impact.t1);
  impact.v1 = vt.dot(impact.t1);
  impact.v2 = spins ? vt.dot(impact.t2) : 0;
  impact.w2 = spins ? wt_length : 0;  // and w1 = 0 in this frame
  const double slip_1 = impact.v1 - impact.w2 * radius;
  impact.slip = std::sqrt(slip_1 * slip_1 + impact.v2 * impact.v2);
  return impact;
}

Rebound crsp_rebound(const CrspImpact& impact, const Rock& rock, Restitution restitution) {
  const auto& [n, t1, t2, vn, wn, v1, v2, w2, slip] = impact;
  const double r = rock.radius;
  const double kept = r * r * crsp_friction_function(slip, restitution.tangential) *
                      crsp_scaling_factor(vn, restitution) / (rock.inertia + rock.mass * r * r);
  // The sign of a velocity that is tiny compared to the spin, as of a spinning rock set down, is rounding.
  const double direction = std::abs(v1) > 1e-6 * w2 * r ? v1 : w2;
  const double v1_after = std::copysign(std::sqrt(kept * (rock.inertia * w2 * w2 + rock.mass * v1 * v1)), direction);
  const double v2_after = std::copysign(std::sqrt(kept * rock.mass * v2 * v2), v2);
  return {-restitution.normal * vn * n + v1_after * t1 + v2_after * t2, wn * n - v2_after / r * t1 + v1_after / r * t2};
}

}  // namespace talus
