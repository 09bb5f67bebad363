#pragma once
// Drag on a rock that slides or rolls, proportional to its velocity: a force -k m v on the centre, beside the friction.
//
// On soft ground k is the ground's own: the viscous part of a viscoplastic (Bingham) resistance whose constant part is
// the friction of the contact, m dv/dt = m (pull - mu N v/|v|) - k m v. That is the ground drag of RAMMS::ROCKFALL,
// which acts on the centre while the rock is in contact (P. Bartelt et al., RAMMS::ROCKFALL user manual, WSL 2016). In
// a forest lower than which the centre is, its drag (flight/drag.hpp) adds k = b/m.
//
// A leg with drag is one of the laws' own with a footing that has been made smaller, so that at its end the velocity is
// exact where the motion is straight:
//   v(t) = v0 e^(-k t) + (pull - mu N) (1 - e^(-k t))/k = v0 + t phi (pull - k v0 - mu N), phi = (1 - e^(-k t))/(k t);
// its way is second order in its length. A rolling sphere is braked by 5/7 of it, its spin taking part.
//
// Left out: drag during impacts, which take no time here; what depends on how deep the rock has sunk in: the slip-
// dependent friction of Leine et al. 2014 and the drag with the square of the velocity in a layer of given strength of
// Lu et al. 2019 (both in RAMMS::ROCKFALL).
// Checked by test/sliding/drag_test.cpp and test/trajectory/drag_test.cpp.

#include <algorithm>
#include <cmath>

#include "talus/sliding/leg.hpp"

namespace talus {

/// How long a leg with drag may be [s]: a tenth of the time in which drag alone would brake by a factor of e; or the
/// timestep, where that is shorter, or where the rock goes at the velocity to which all forces bring it, but for less
/// than a tenth of a millimetre in that time. `net` is the pull less the friction against the motion [m/s2].
[[nodiscard]] inline double dragged_timestep(double rate, double timestep, const Vec3& net, const Vec3& velocity) {
  if (rate * timestep <= 0.1 || (net / rate - velocity).norm() * timestep < tolerance::unseen_way) return timestep;
  return 0.1 / rate;
}

/// The footing for a leg of `timestep` with drag of this `rate` [1/s]. `share`: how much of a force on the centre
/// accelerates it, 1 for what slides, rolling_share for what rolls.
[[nodiscard]] inline Footing dragged(const Footing& footing, const Vec3& velocity, double rate, double timestep,
                                     double share) {
  const double braking = share * rate * timestep;
  const double phi = -std::expm1(-braking) / braking;
  return {phi * (footing.pull - rate * velocity), phi * footing.normal_acceleration};
}

/// A leg that lasts no longer than `longest` [s].
[[nodiscard]] inline Leg cut_short(Leg leg, double longest) {
  if (leg.duration > longest) {
    leg.duration = longest;
    leg.end_velocity = leg.path.velocity(longest);
  }
  return leg;
}

}  // namespace talus
