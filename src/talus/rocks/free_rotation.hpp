#pragma once
// The free rotation of a rigid body, exact at any time: Euler's equations without a moment.
//
// The angular momentum L is constant. With the principal moments Ia, Ib, Ic of the axes a, b, c - b the intermediate
// one, c that about which L turns in the body, (a, b, c) right-handed if sigma = 1 -
//   wa = A cn u,  wb = B sn u,  wc = C dn u,  u = p t + u0                    (Jacobi functions of m = k^2)
//   A^2 = wa^2 + Ib (Ib - Ic) / (Ia (Ia - Ic)) wb^2,   C^2 = wc^2 + Ib (Ib - Ia) / (Ic (Ic - Ia)) wb^2
//   p^2 = C^2 (Ic - Ia) (Ic - Ib) / (Ia Ib),   B = sigma (Ic - Ia) A C / (Ib p)
//   m = A^2 Ia (Ib - Ia) / (C^2 Ic (Ic - Ib))
// The angle psi about L of that of the axes a, c which never comes near to L (its "pole", with Iq, Ir the other two):
//   psi' = L (Iq wq^2 + Ir wr^2) / (Iq^2 wq^2 + Ir^2 wr^2)
//   psi  = L t / Ip + (2 T Ip - L^2) / (L Ip (1 - q) p) [Pi(n; am u | m)],  q = (Ip wp_max / L)^2,
//   n = -q / (1 - q), and m times that if the pole is c.
// Source: any text on the dynamics of rigid bodies (L. D. Landau and E. M. Lifshitz, Mechanics, section 37); psi
// follows with 1 - q cn^2 = (1 - q) (1 - n sn^2). Energy and angular momentum are constant by construction, and a disc
// that spins about its axis stays upright. Tested against numerical integration and computed periods.

#include "talus/core/orientation.hpp"
#include "talus/rocks/elliptic.hpp"

namespace talus {

class FreeRotation {
 public:
  /// From an orientation and a spin [rad/s] in the frame of the terrain. `inertia`: principal moments along the body's
  /// axes [kg m2], or their ratios.
  FreeRotation(const Vec3& inertia, const Orientation& start, const Vec3& spin);

  /// Orientation and spin in the frame of the terrain.
  struct State {
    Orientation orientation;
    Vec3 spin;  // [rad/s]
  };
  /// `t`: since the start [s].
  [[nodiscard]] State at(double t) const;

 private:
  [[nodiscard]] Vec3 body_spin(const JacobiFunctions& jacobi) const;

  Orientation start_;
  Vec3 start_spin_;
  bool is_steady_ = false;  // the spin is constant

  JacobiSeries jacobi_;
  std::size_t a_ = 0, b_ = 1, c_ = 2, pole_ = 0;
  double amplitude_a_ = 0, amplitude_b_ = 0, amplitude_c_ = 0;  // A, B, C [rad/s]
  double rate_ = 0, u0_ = 0;                                    // p [1/s]
  double m1_ = 1;
  Vec3 inertia_;
  // Of the pole's angle about the angular momentum.
  double even_rate_ = 0, factor_ = 0, n_ = 0, pi0_ = 0;
  Vec3 axis_, ahead_,
      aside_;  // of the terrain, unit: along L; where the pole points across L at the start; both across
};

}  // namespace talus
