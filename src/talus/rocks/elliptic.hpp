#pragma once
// Elliptic functions and integrals, of a modulus k with m = k^2 in [0, 1): what the free rotation of a body needs.

namespace talus {

/// The Jacobi functions of u.
struct JacobiFunctions {
  double am = 0;  // amplitude [rad]; grows with u without end
  double sn = 0, cn = 1, dn = 1;
};

/// By the arithmetic-geometric mean (Abramowitz and Stegun 16.4), set up once for many arguments.
class JacobiSeries {
 public:
  JacobiSeries() : JacobiSeries(1) {}
  /// `m1` = 1 - m in (0, 1].
  explicit JacobiSeries(double m1);
  [[nodiscard]] JacobiFunctions at(double u) const;

 private:
  static constexpr int max_terms = 16;
  double ratio_[max_terms] = {};  // c_n / a_n
  double scale_ = 1;               // 2^N a_N
  double m1_ = 1;
  int terms_ = 0;
};

/// F(am | m), the integral of the first kind; unrolled, so that it is the inverse of JacobiFunctions::am.
[[nodiscard]] double elliptic_f(double am, double m1);

/// Pi(n; am | m), of the third kind, for n <= 0: the integral of 1 / ((1 - n sin^2) sqrt(1 - m sin^2)) from 0 to am.
/// Unrolled as elliptic_f(). Both by duplication (B. C. Carlson, "Numerical computation of real or complex elliptic
/// integrals", Numerical Algorithms 10, 1995, doi 10.1007/BF02198293).
[[nodiscard]] double elliptic_pi(double n, double am, double m1);

}  // namespace talus
