#pragma once
// Flight with linear drag, as in a forest: m dv/dt = m g - b v.
//
// Source: RAMMS::ROCKFALL and RocFall brake rocks in forests by a force -b v on the centre, b in kg/s, below an
// effective height (P. Bartelt et al., RAMMS::ROCKFALL user manual, WSL 2016; R. I. Leine et al., "Simulation of
// rockfall trajectories with consideration of rock shape", Multibody System Dynamics 32 (2014) 241-271). The closed
// form, with the rate k = b/m [1/s], is in any text on mechanics:
//   v(t) = v0 e^(-k t) + (g/k) (1 - e^(-k t)),   p(t) = p0 + (v0 - g/k) (1 - e^(-k t))/k + (g/k) t.
//
// With the parameter s = (1 - e^(-k t))/k instead of the time this is
//   v = (1 - k s) v0 + s g,   p = p0 + s v0 + g (s + ln(1 - k s)/k)/k = p0 + s v0 + g (s^2/2 + k s^3/3 + ...):
// straight on plan and almost a parabola in height. Surfaces and barriers only handle parabolas. They are therefore
// queried with pieces that are parabolas in s, each with the vertical acceleration that gives the exact height at its
// end. Between its ends a piece runs below the exact path by at most `tolerance::drag_piece`; velocities and times are
// exact for its s. Energy cannot grow: on the exact path it does not, and a lower place has less.
//
// Left out: drag with the square of the velocity, single trees, wind. Spin is not braked. Checked by
// test/rocks/drag_test.cpp.

#include <cmath>

#include "talus/core/tolerances.hpp"
#include "talus/rocks/parabola.hpp"

namespace talus {

/// 2 (-ln(1 - q) - q) / q^2 = 1 + 2 q/3 + q^2/2 + ...: the ratio of a piece's curvature in s to that of a free flight,
/// for q = k s in [0, 1).
[[nodiscard]] inline double bend_of_drag(double q) {
  if (q > 0.1) return 2 * (-std::log1p(-q) - q) / (q * q);  // without loss of digits
  double sum = 0;
  for (int n = 14; n >= 0; --n) sum = sum * q + 2.0 / (n + 2);
  return sum;
}

/// The drag of a flight. With rate 0 the parameter of a piece is time.
struct LinearDrag {
  double rate = 0;  // k = b/m [1/s]
  Vec3 gravity;     // [m/s2]; only with drag

  /// The time [s] at the parameter s, which is below 1/rate.
  [[nodiscard]] double time(double s) const { return rate == 0 ? s : -std::log1p(-rate * s) / rate; }
  /// The parameter s [s] at a time.
  [[nodiscard]] double parameter(double time) const { return rate == 0 ? time : -std::expm1(-rate * time) / rate; }
  /// The velocity at s on a piece that starts with `piece.v`.
  [[nodiscard]] Vec3 velocity(const Parabola& piece, double s) const {
    return rate == 0 ? piece.velocity(s) : (1 - rate * s) * piece.v + s * gravity;
  }

  /// The piece from `p` with the velocity `v` that is exact at s = `length`, which is below 1/rate.
  [[nodiscard]] Parabola piece(const Vec3& p, const Vec3& v, double length) const {
    return {p, v, bend_of_drag(rate * length) * gravity};
  }
  /// Whether the rock sinks at terminal velocity g/k, to within a thousandth.
  [[nodiscard]] bool sinks_evenly(const Vec3& v) const {
    return (v - gravity / rate).norm() < 1e-3 * gravity.norm() / rate;
  }
  /// The longest piece, in s [s], within `tolerance::drag_piece`. A piece is below the exact path by k g (s^2 length -
  /// s^3)/3, at most 4/81 k g length^3, and a third more if k length is a quarter.
  [[nodiscard]] double longest_piece() const {
    const double by_height = std::cbrt(14 * tolerance::drag_piece / (rate * gravity.norm()));
    return std::min(by_height, 0.25 / rate);
  }
};

}  // namespace talus
