#pragma once
// Drag on a rock that slides or rolls, proportional to its velocity: a force -k m v on the centre, in addition to
// friction.
//
// On soft ground k is a property of the ground: the viscous part of a viscoplastic (Bingham) resistance whose constant
// part is the friction of the contact, m dv/dt = m (pull - mu N v/|v|) - k m v. This is the ground drag of
// RAMMS::ROCKFALL, which acts on the centre while the rock is in contact (P. Bartelt et al., RAMMS::ROCKFALL user
// manual, WSL 2016). A forest higher than the rock's centre adds its drag (rocks/drag.hpp), k = b/m.
//
// A leg with drag is a leg of the law without drag and with a reduced footing, such that the velocity at its end is
// exact for straight motion:
//   v(t) = v0 e^(-k t) + (pull - mu N) (1 - e^(-k t))/k = v0 + t phi (pull - k v0 - mu N), phi = (1 - e^(-k t))/(k t);
// its displacement is accurate to second order in its duration. A rolling sphere is braked by 5/7 of the
// drag, because of its spin.
//
// Left out: drag during impacts, which take no time here; and laws that depend on how deep the rock has sunk in: the
// slip-dependent friction of Leine et al. 2014, and the drag with the square of the velocity in a layer of given
// strength of Lu et al. 2019 (both in RAMMS::ROCKFALL). Checked by test/sliding/drag_test.cpp and
// test/trajectory/drag_test.cpp.

#include <algorithm>
#include <cmath>

#include "talus/sliding/leg.hpp"

namespace talus {

/// The duration [s] of a leg with drag: a tenth of the time in which drag alone would brake by a factor of e. Or the
/// timestep, if that is shorter, or if the rock is so near its terminal velocity that the difference is invisible
/// (tolerance::unseen_way) in that time. `net`: the pull, less friction along the motion [m/s2].
[[nodiscard]] inline double dragged_timestep(double rate, double timestep, const Vec3& net, const Vec3& velocity) {
  if (rate * timestep <= 0.1 || (net / rate - velocity).norm() * timestep < tolerance::unseen_way) return timestep;
  return 0.1 / rate;
}

/// The pull, less friction along the motion [m/s2].
[[nodiscard]] inline Vec3 net_pull(const Footing& footing, double friction, const Vec3& velocity) {
  return footing.pull - friction / std::max(velocity.norm(), tolerance::least_speed) * velocity;
}

/// phi, for `braking` = k t.
[[nodiscard]] inline double share_with_drag(double braking) { return -std::expm1(-braking) / braking; }

/// The footing for a leg of `timestep` with drag of this `rate` k [1/s]. `share`: the share of a force on the centre
/// that accelerates it, 1 for sliding, rolling_share for rolling.
[[nodiscard]] inline Footing dragged(const Footing& footing, const Vec3& velocity, double rate, double timestep,
                                     double share) {
  const double phi = share_with_drag(share * rate * timestep);
  return {phi * (footing.pull - rate * velocity), phi * footing.normal_acceleration};
}

/// A leg cut to at most `longest` [s].
[[nodiscard]] inline Leg cut_short(Leg leg, double longest) {
  if (leg.duration > longest) {
    leg.duration = longest;
    leg.end_velocity = leg.path.velocity(longest);
  }
  return leg;
}

}  // namespace talus
