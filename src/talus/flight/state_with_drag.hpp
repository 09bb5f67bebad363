#pragma once
// A flight with linear drag at any time, in closed form (drag.hpp has the equation and its sources).

#include <cmath>

#include "talus/core/vec.hpp"

namespace talus {

/// (e^-x - 1 + x) / x^2 = 1/2 - x/6 + x^2/24 - ...: the height fallen from rest in a time t over g t^2, for x = k t.
[[nodiscard]] inline double fall_with_drag(double x) {
  if (x > 0.1) return (std::expm1(-x) + x) / (x * x);  // without loss of digits
  double sum = 0;
  for (int n = 12; n >= 2; --n) sum = (1 - x * sum) / n;
  return sum;
}

struct FlightState {
  Vec3 place;     // [m]
  Vec3 velocity;  // [m/s]
};

/// The state after `time` [s], from `p` [m] with the velocity `v` [m/s], with the gravity `g` [m/s2] and the drag's
/// rate k = b/m [1/s]; 0: a parabola.
[[nodiscard]] inline FlightState state_with_drag(const Vec3& p, const Vec3& v, const Vec3& g, double rate,
                                                 double time) {
  const double s = rate == 0 ? time : -std::expm1(-rate * time) / rate;
  return {p + s * v + time * time * fall_with_drag(rate * time) * g, (1 - rate * s) * v + s * g};
}

}  // namespace talus
