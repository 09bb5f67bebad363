#pragma once
// Sliding of a lumped mass in steps: semi-implicit Euler, velocity first, then position. This is RocFall3 (verification
// manual, tables A-2 and B-2). Acceleration: the pull along the facet, and tan(phi) times the normal acceleration
// against the motion (section 3.3.3). A step in which the velocity would reverse ends when the speed is zero, and does
// not move the rock. Spin does not change during sliding.

#include "talus/sliding/leg.hpp"

namespace talus {

/// The next step. `mu` = tan(phi). A rock at rest starts along the pull.
[[nodiscard]] inline Leg stepped_leg(const Vec3& position, const Vec3& velocity, const Vec3& spin,
                                     const Footing& footing, double mu, double timestep) {
  const double speed = velocity.norm(), pull = footing.pull.norm();
  const Vec3 heading = speed > 0 ? velocity / speed : pull > 0 ? footing.pull / pull : Vec3{};
  const double drag = mu * footing.normal_acceleration;
  const Vec3 pulled = velocity + timestep * footing.pull;
  Leg leg;
  leg.end_spin = spin;
  if (speed > 0 && pulled.dot(heading) < timestep * drag) {
    leg.duration = speed / (drag - footing.pull.dot(heading));
    leg.end_velocity = Vec3{};  // a pull across the motion would add speed without displacement
    leg.path = {position, Vec3{}, Vec3{}};
    return leg;
  }
  // Friction acts against the velocity at the end of the step. On a straight line it has the direction of that at the
  // start; across it, friction against the start velocity would amplify rounding a hundredfold per step at low speed.
  const double size = pulled.norm();
  const Vec3 after = size > timestep * drag ? (1 - timestep * drag / size) * pulled : Vec3{};
  leg.duration = timestep;
  leg.end_velocity = after;
  leg.path = {position, after, Vec3{}};
  return leg;
}

}  // namespace talus
