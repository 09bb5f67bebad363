#pragma once
// Sliding of a lumped mass by steps: semi-implicit Euler, velocity first, then position. This is RocFall3 (verification
// manual, tables A-2 and B-2). Acceleration: the pull along the facet, less tan(phi) times the normal acceleration
// against the motion (section 3.3.3). A step in which the speed would change sign is cut short where it is zero and
// moves nothing. Spin does not change while sliding.

#include "talus/sliding/leg.hpp"

namespace talus {

/// The next step. `mu` = tan(phi); a rock that stands still starts down the pull.
[[nodiscard]] inline Leg stepped_leg(const Vec3& position, const Vec3& velocity, const Vec3& spin,
                                     const Footing& footing, double mu, double timestep) {
  const double speed = velocity.norm(), pull = footing.pull.norm();
  const Vec3 heading = speed > 0 ? Vec3(velocity / speed) : pull > 0 ? Vec3(footing.pull / pull) : Vec3(Vec3::Zero());
  const double drag = mu * footing.normal_acceleration;
  const Vec3 pulled = velocity + timestep * footing.pull;
  Leg leg;
  leg.end_spin = spin;
  if (speed > 0 && pulled.dot(heading) < timestep * drag) {
    leg.duration = speed / (drag - footing.pull.dot(heading));
    leg.end_velocity = Vec3::Zero();  // what pulls across the motion would be speed without way
    leg.path = {position, Vec3::Zero(), Vec3::Zero()};
    return leg;
  }
  // Friction acts against the motion at the end of the step. On a straight line that is its motion at the start; across
  // it, friction of the start would make rounding grow a hundredfold a step where the rock is slow.
  const double size = pulled.norm();
  const Vec3 after = size > timestep * drag ? Vec3((1 - timestep * drag / size) * pulled) : Vec3(Vec3::Zero());
  leg.duration = timestep;
  leg.end_velocity = after;
  leg.path = {position, after, Vec3::Zero()};
  return leg;
}

}  // namespace talus
