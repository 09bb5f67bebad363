#pragma once
// Elliptic functions and integrals, of a modulus k with m = k^2 in [0, 1): what the free rotation of a body needs.

#include <array>
#include <numbers>

namespace talus {

/// F(am | m) of the first kind: the integral of 1 / sqrt(1 - m sin^2) from 0 to the angle am with this sine and cosine,
/// by duplication (B. C. Carlson, "Numerical computation of real or complex elliptic integrals", Numerical Algorithms
/// 10, 1995, doi 10.1007/BF02198293). The cosine must not be negative. `m1` = 1 - m.
[[nodiscard]] double elliptic_f(double sine, double cosine, double m1);

/// Jacobi's theta functions of one nome q, and one of them at a complex argument (Abramowitz and Stegun 16.27): sums of
/// sines and cosines whose terms fall as q^(n^2). All are of z = pi u / (2 K).
class ThetaSeries {
 public:
  ThetaSeries() = default;
  /// `m` + `m1` = 1, both given so that neither loses its digits.
  ThetaSeries(double m, double m1);

  /// pi / (2 K).
  [[nodiscard]] double rate() const { return rate_; }
  /// pi K' / (2 K), infinite if m is 0.
  [[nodiscard]] double half_height() const { return half_height_; }

  /// The functions of the real z: sn, cn and dn times one common factor.
  struct Values {
    double sn, cn, dn;
    double re, im;  // of theta4(z + i y), or of theta1(z - i y), times a constant
  };
  /// Which function at() takes at a complex argument, and its `y` in [0, half_height()): theta4 needs one below half of
  /// it, theta1 one that is not 0.
  void take_theta4(double y);
  void take_theta1(double y);
  [[nodiscard]] Values at(double z) const;

  /// Jacobi's zeta function Z(i eta) / i, y = pi eta / (2 K), for y up to half of half_height().
  [[nodiscard]] double zeta(double y) const;

 private:
  static constexpr int max_terms = 18;
  double rate_ = 1, half_height_ = 0, nome_ = 0;
  double sn_ = 1, cn_ = 1, dn_ = 1;  // factors of the series
  bool is_odd_ = false;              // theta1
  int terms_ = 1;
  std::array<double, max_terms> even_{}, odd_{};  // q^(n^2), q^(n (n + 1))
  std::array<double, max_terms> re_{}, im_{};     // of the function at a complex argument
};

}  // namespace talus
