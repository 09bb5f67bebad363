#pragma once
// A flight with linear drag at any time, in closed form (drag.hpp has the equation and its sources).

#include "talus/rocks/drag.hpp"

namespace talus {

struct FlightState {
  Vec3 place;     // [m]
  Vec3 velocity;  // [m/s]
};

/// The state after `time` [s], from `p` [m] with the velocity `v` [m/s]; without drag on a parabola.
[[nodiscard]] inline FlightState state_with_drag(const Vec3& p, const Vec3& v, const LinearDrag& drag, double time) {
  const double s = drag.parameter(time);
  const bool is_weak = drag.rate * s < 0.1;  // time - s has lost digits there
  const Vec3 place = is_weak ? drag.piece(p, v, s).at(s) : p + s * v + (time - s) / drag.rate * drag.gravity;
  return {place, drag.velocity({p, v, drag.gravity}, s)};
}

}  // namespace talus
