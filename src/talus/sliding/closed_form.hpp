#pragma once
// Sliding of a lumped mass in closed form: on a plane facet the acceleration along a straight path is constant, so
// that it is solved exactly up to rest, reversal or the facet's edge. This is RocFall2 (verification manual, section
// 3.3.3 and tables A-1 and B-1). Spin does not change while sliding.
//
// In 3D a rock may cross the line of steepest descent at an angle; friction then turns with its velocity and the path
// is curved. Such a path is followed by legs of `timestep`, each with the friction of its own middle (second order).
// Checked against the exact hodograph v(psi) = C tan(psi/2)^k / sin(psi), k = mu N / |pull|, psi from the pull.

#include <limits>

#include "talus/sliding/leg.hpp"

namespace talus {

/// The next leg. `mu` = tan(phi); a rock that stands still starts down the pull.
[[nodiscard]] inline Leg closed_form_leg(const Vec3& position, const Vec3& velocity, const Vec3& spin,
                                         const Footing& footing, double mu, double timestep) {
  const double speed = velocity.norm(), pull = footing.pull.norm();
  const Vec3 heading = speed > 0 ? Vec3(velocity / speed) : pull > 0 ? Vec3(footing.pull / pull) : Vec3(Vec3::Zero());
  const double drag = mu * footing.pressure;
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
  const Vec3 middle = velocity + 0.5 * timestep * (footing.pull - drag * heading);
  const double middle_speed = middle.norm();
  Vec3 middle_heading = middle_speed > 0 ? Vec3(middle / middle_speed) : heading;
  // Close to rest the middle may lie behind: friction that would push the rock is none, that of the start brakes it.
  const double advance = middle_speed + 0.5 * timestep * drag * (heading.dot(middle_heading) - 1);
  if (heading.dot(middle_heading) <= 0 || advance <= 0) middle_heading = heading;
  return braked(footing.pull - drag * middle_heading, timestep);
}

}  // namespace talus
