#include "talus/rocks/elliptic.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace talus {

namespace {

/// Carlson's R_C(x, y), x >= 0, y > 0.
double carlson_c(double x, double y) {
  double a0 = (x + 2 * y) / 3, a = a0, q = std::abs(a0 - x) * 500, shrink = 1;
  const double y0 = y;
  while (shrink * q > std::abs(a)) {
    const double lambda = 2 * std::sqrt(x) * std::sqrt(y) + y;
    x = (x + lambda) / 4;
    y = (y + lambda) / 4;
    a = (a + lambda) / 4;
    shrink /= 4;
  }
  const double s = (y0 - a0) * shrink / a;
  return (1 + s * s * (3.0 / 10 + s * (1.0 / 7 + s * (3.0 / 8 + s * (9.0 / 22 + s * (159.0 / 208 + s * 9.0 / 8)))))) /
         std::sqrt(a);
}

/// Carlson's R_F(x, y, z); at most one of them 0.
double carlson_f(double x, double y, double z) {
  const double a0 = (x + y + z) / 3;
  const double q = 500 * std::max({std::abs(a0 - x), std::abs(a0 - y), std::abs(a0 - z)});
  const double x0 = x, y0 = y;
  double a = a0, shrink = 1;
  while (shrink * q > std::abs(a)) {
    const double sx = std::sqrt(x), sy = std::sqrt(y), sz = std::sqrt(z), lambda = sx * sy + sx * sz + sy * sz;
    x = (x + lambda) / 4;
    y = (y + lambda) / 4;
    z = (z + lambda) / 4;
    a = (a + lambda) / 4;
    shrink /= 4;
  }
  const double u = (a0 - x0) * shrink / a, v = (a0 - y0) * shrink / a, w = -u - v;
  const double e2 = u * v - w * w, e3 = u * v * w;
  return (1 - e2 / 10 + e3 / 14 + e2 * e2 / 24 - 3 * e2 * e3 / 44) / std::sqrt(a);
}

/// Carlson's R_J(x, y, z, p), p > 0; at most one of x, y, z 0.
double carlson_j(double x, double y, double z, double p) {
  const double a0 = (x + y + z + 2 * p) / 5, delta = (p - x) * (p - y) * (p - z);
  const double q = 500 * std::max({std::abs(a0 - x), std::abs(a0 - y), std::abs(a0 - z), std::abs(a0 - p)});
  const double x0 = x, y0 = y, z0 = z;
  double a = a0, shrink = 1, sum = 0, e_scale = 1;
  while (shrink * q > std::abs(a)) {
    const double sx = std::sqrt(x), sy = std::sqrt(y), sz = std::sqrt(z), sp = std::sqrt(p);
    const double lambda = sx * sy + sx * sz + sy * sz, d = (sp + sx) * (sp + sy) * (sp + sz);
    const double e = e_scale * delta / (d * d);
    sum += shrink / d * carlson_c(1, 1 + e);
    x = (x + lambda) / 4;
    y = (y + lambda) / 4;
    z = (z + lambda) / 4;
    p = (p + lambda) / 4;
    a = (a + lambda) / 4;
    shrink /= 4;
    e_scale /= 64;
  }
  const double u = (a0 - x0) * shrink / a, v = (a0 - y0) * shrink / a, w = (a0 - z0) * shrink / a;
  const double s = (-u - v - w) / 2;
  const double e2 = u * v + u * w + v * w - 3 * s * s, e3 = u * v * w + 2 * e2 * s + 4 * s * s * s;
  const double e4 = (2 * u * v * w + e2 * s + 3 * s * s * s) * s, e5 = u * v * w * s * s;
  const double series = 1 - 3 * e2 / 14 + e3 / 6 + 9 * e2 * e2 / 88 - 3 * e4 / 22 - 9 * e2 * e3 / 52 + 3 * e5 / 26;
  return shrink * series / (a * std::sqrt(a)) + 6 * sum;
}

/// Of an integral over the angle that is odd and has the period pi: `within(sine, cosine)` from 0 to an angle of at
/// most a quarter turn.
template <class Within>
double unrolled(double angle, Within&& within) {
  const double half_turns = std::round(angle / std::numbers::pi);
  const double rest = angle - half_turns * std::numbers::pi;
  const double part = within(std::sin(rest), std::cos(rest));
  return half_turns == 0 ? part : part + 2 * half_turns * within(1, 0);
}

}  // namespace

JacobiSeries::JacobiSeries(double m1) : m1_(m1) {
  double a = 1, b = std::sqrt(m1), c = std::sqrt(1 - m1);
  while (c > 1e-17 * a && terms_ < max_terms) {
    const double next = 0.5 * (a + b);
    c = 0.5 * (a - b);
    b = std::sqrt(a * b);
    a = next;
    ratio_[terms_++] = c / a;
  }
  scale_ = std::ldexp(a, terms_);
}

JacobiFunctions JacobiSeries::at(double u) const {
  double am = scale_ * u;
  for (int n = terms_ - 1; n >= 0; --n) am = 0.5 * (am + std::asin(ratio_[n] * std::sin(am)));
  const double sn = std::sin(am), cn = std::cos(am);
  return {am, sn, cn, std::sqrt(cn * cn + m1_ * sn * sn)};
}

double elliptic_f(double am, double m1) {
  return unrolled(am, [&](double s, double c) { return s * carlson_f(c * c, c * c + m1 * s * s, 1); });
}

double elliptic_pi(double n, double am, double m1) {
  return unrolled(am, [&](double s, double c) {
    const double delta = c * c + m1 * s * s;
    return s * carlson_f(c * c, delta, 1) + n / 3 * s * s * s * carlson_j(c * c, delta, 1, 1 - n * s * s);
  });
}

}  // namespace talus
