#pragma once
// The free rotation of a rigid body, exact at any time: Euler's equations without a moment.
//
// The angular momentum L is constant. With the principal moments Ia, Ib, Ic of the axes a, b, c - b the intermediate
// one, c that about which L turns in the body, (a, b, c) right-handed if sigma = 1 -
//   wa = A cn u,  wb = B sn u,  wc = C dn u,  u = p t + u0                    (Jacobi functions of m = k^2)
//   A^2 = wa^2 + Ib (Ib - Ic) / (Ia (Ia - Ic)) wb^2,   C^2 = wc^2 + Ib (Ib - Ia) / (Ic (Ic - Ia)) wb^2
//   p^2 = C^2 (Ic - Ia) (Ic - Ib) / (Ia Ib),   B = sigma (Ic - Ia) A C / (Ib p)
//   m = A^2 Ia (Ib - Ia) / (C^2 Ic (Ic - Ib))
// The angle psi about L of that of the axes a, c which never comes near to L (its "pole"; the polar angle of L from c
// is phi at u = 0, so that is a if tan phi = Ic |C| / (Ia A) > 1):
//   psi' = L (Iq wq^2 + Ir wr^2) / (Iq^2 wq^2 + Ir^2 wr^2),  q and r the other two axes
// Its integral is one of the third kind, and with z = pi u / 2K, y = pi F(phi | 1 - m) / 2K and Jacobi's zeta function
//   pole a:  psi = (L / Ia + s p Z) t + s arg theta1(z - i y)
//   pole c:  psi = (L / Ic + s p (1 / S - Z)) t + s arg theta4(z + i y)
//   s / S = (2 T Ip - L^2) / (L Ip (1 - q) p),  q = (Ip wp_max / L)^2,  Z = Z(i F(phi | 1 - m)) / i,  S > 0
// Source: any text on the dynamics of rigid bodies (L. D. Landau and E. M. Lifshitz, Mechanics, section 37); with theta
// functions R. van Zon and J. Schofield, "Numerical implementation of the exact dynamics of free rigid bodies", Journal
// of Computational Physics 225 (2007), doi 10.1016/j.jcp.2006.11.019. A moment costs two sines and cosines. Energy and
// angular momentum are constant by construction, and a disc that spins about its axis stays upright. Tested against
// numerical integration and computed periods.

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
  /// The same with a matrix from the body's frame to that of the terrain.
  struct Turned {
    Mat3 matrix;
    Vec3 spin;
  };
  [[nodiscard]] Turned turned_at(double t) const;
  /// No spin is larger at any time [rad/s].
  [[nodiscard]] double max_spin() const { return max_spin_; }

 private:
  Orientation start_;
  Vec3 start_spin_;
  bool is_steady_ = false;  // the spin is constant

  ThetaSeries series_;
  std::size_t a_ = 0, b_ = 1, c_ = 2, pole_ = 0;
  Vec3 inertia_, amplitudes_;           // amplitudes: of the angular momentum along the axes, over L
  double momentum_ = 0, max_spin_ = 0;  // L; see max_spin()
  double rate_ = 0, z0_ = 0;            // of z [1/s]; z at the start
  double turning_ = 0, sense_ = 1;      // of psi: its even rate [rad/s], and s
  Vec3 axis_, ahead_, aside_;  // of the terrain, unit: along L; where the pole points across L at psi = 0; both across
};

}  // namespace talus
