#include "talus/sliding/rolling.hpp"

#include <algorithm>

namespace talus {

namespace {

using tolerance::no_slip;
using tolerance::standstill;

Leg rolling_without_slip(const Vec3& position, const Vec3& velocity, const Vec3& spin, const Vec3& n, const Vec3& a,
                         const Footing& footing, double radius, double timestep) {
  const double speed = velocity.norm();
  Leg leg{{position, velocity, a}, timestep, velocity + timestep * a, spin};
  if (speed > standstill) {
    const Vec3 heading = velocity / speed;
    const double rate = a.dot(heading);
    if (rate < 0 && -speed / rate <= timestep) {
      leg.duration = -speed / rate;
      leg.end_velocity = halted(velocity + leg.duration * a, footing, heading);
    }
  } else if (a.isZero(0)) {
    leg.end_velocity = Vec3::Zero();
  }
  leg.end_spin = rolling_spin(leg.end_velocity, spin, n, radius);
  return leg;
}

}  // namespace

Leg rolling_leg(const Vec3& position, const Vec3& velocity, const Vec3& spin, const Vec3& n, const Footing& footing,
                const Rock& rock, ContactFriction friction, double timestep) {
  const double normal = footing.normal_acceleration, r = rock.radius;
  const double speed = velocity.norm(), pull = footing.pull.norm();
  const Vec3 heading = speed > standstill ? Vec3(velocity / speed)
                       : pull > 0         ? Vec3(footing.pull / pull)
                                          : Vec3(Vec3::Zero());
  const Vec3 slip = slip_velocity(velocity, spin, n, r);
  Vec3 slip_heading;
  if (slip.norm() <= no_slip) {
    const double resistance = friction.rolling * normal;
    // Resistance holds a sphere at rest, but does not drive it.
    const double resisting = speed > standstill ? resistance : std::min(resistance, pull);
    const Vec3 a = rolling_share(rock) * (footing.pull - resisting * heading);
    const Vec3 needed = a - footing.pull;
    if (needed.norm() <= friction.dynamic * normal) {
      return rolling_without_slip(position, velocity, spin, n, a, footing, r, timestep);
    }
    slip_heading = -needed.normalized();
  } else {
    slip_heading = slip.normalized();
  }

  const Vec3 a = footing.pull - friction.dynamic * normal * slip_heading;
  const double moment = rock.mass * normal * r / rock.inertia;
  const Vec3 spun_up = friction.dynamic * moment * n.cross(slip_heading);
  const Vec3 tangential_spin = tangential(spin, n);
  const double spin_rate = tangential_spin.norm();
  // Rolling resistance brakes the spin; without spin, it reduces the moment that would start it.
  const Vec3 resistance = spin_rate * r > no_slip ? Vec3(-friction.rolling * moment * tangential_spin / spin_rate)
                          : friction.rolling < friction.dynamic ? Vec3(-friction.rolling / friction.dynamic * spun_up)
                                                                : Vec3(-spun_up);
  const Vec3 angular = spun_up + resistance;
  Leg leg{{position, velocity, a}, timestep, velocity + timestep * a, spin + timestep * angular};
  const Vec3 slip_change = a + r * n.cross(angular);
  const double slip_rate = slip_change.dot(slip_heading);
  const double slip_speed = slip.norm();
  // Resistance brakes the spin to zero, and must not reverse it.
  const double spin_change = spin_rate * r > no_slip ? angular.dot(tangential_spin) / spin_rate : 0;
  if (spin_change < 0 && -spin_rate / spin_change <= timestep) {
    leg.duration = -spin_rate / spin_change;
    leg.end_velocity = velocity + leg.duration * a;
    leg.end_spin = spin + leg.duration * angular;
  }
  if (slip_speed > no_slip && slip_rate < 0 && -slip_speed / slip_rate <= leg.duration) {
    leg.duration = -slip_speed / slip_rate;
    leg.end_velocity = velocity + leg.duration * a;
    leg.end_spin = spin + leg.duration * angular;
    // Rolling begins: a spin that agrees with the velocity except for rounding is made to agree exactly.
    const Vec3 rolling = rolling_spin(leg.end_velocity, leg.end_spin, n, r);
    if ((rolling - leg.end_spin).norm() * r <= no_slip * (1 + leg.end_velocity.norm())) leg.end_spin = rolling;
  }
  return leg;
}

}  // namespace talus
