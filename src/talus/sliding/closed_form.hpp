#pragma once
// Sliding of a lumped mass in closed form: on a plane facet the acceleration along a straight path is constant, so that
// the motion is exact up to rest, reversal or the facet's edge. This is RocFall2 (verification manual, section 3.3.3
// and tables A-1 and B-1). Spin does not change during sliding.
//
// In 3D a rock may slide at an angle to the line of steepest descent; friction then turns with its velocity, and the
// path is curved. It is followed by legs of `timestep`, each with the friction at its middle (second order). Checked
// against the exact hodograph v(psi) = C tan(psi/2)^k / sin(psi), k = mu N / |pull|, psi measured from the pull.

#include <algorithm>
#include <limits>

#include "talus/sliding/leg.hpp"

namespace talus {

/// The next leg. `mu` = tan(phi). A rock at rest starts along the pull.
[[nodiscard]] inline Leg closed_form_leg(const Vec3& position, const Vec3& velocity, const Vec3& spin,
                                         const Footing& footing, double mu, double timestep) {
  const double speed = velocity.norm(), pull = footing.pull.norm();
  const Vec3 heading = speed > 0 ? velocity / speed : pull > 0 ? footing.pull / pull : Vec3{};
  const double drag = mu * footing.normal_acceleration;
  const auto braked = [&](const Vec3& a, double longest) {
    const double rate = a.dot(heading);
    Leg leg{{position, velocity, a}, longest, velocity + longest * a, spin};
    if (rate < 0 && -speed / rate <= longest) {
      leg.duration = -speed / rate;
      leg.end_velocity = halted(velocity + leg.duration * a, footing, heading);
    }
    return leg;
  };
  if (is_straight(footing, heading)) {
    return braked((footing.pull.dot(heading) - drag) * heading, std::numeric_limits<double>::infinity());
  }
  const double along_pull = footing.pull.dot(heading) / pull;
  if (drag > pull && along_pull >= 0 && speed < 0.5 * timestep * drag) {
    // The last leg before rest. Its duration is exact, v (k + cos psi) / (|pull| (k^2 - 1)); its curvature is
    // neglected.
    const double k = drag / pull;
    const double remaining = speed * (k + along_pull) / (pull * (k * k - 1));
    return {{position, velocity, -velocity / remaining}, remaining, Vec3{}, spin};
  }
  // Close to rest friction turns quickly: the velocity changes by less than half of itself in a leg.
  const double duration = std::min(timestep, 0.5 * speed / (drag + pull));
  const Vec3 middle = velocity + 0.5 * duration * (footing.pull - drag * heading);
  return braked(footing.pull - drag * middle.normalized(), duration);
}

}  // namespace talus
