#include "talus/rocks/elliptic.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace talus {

namespace {

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

/// The arithmetic-geometric mean of 1 and `b`.
double mean_with_one(double b) {
  double a = 1;
  while (a - b > 1e-8 * a) {
    const double next = 0.5 * (a + b);
    b = std::sqrt(a * b);
    a = next;
  }
  return 0.5 * (a + b);
}

}  // namespace

double elliptic_f(double sine, double cosine, double m1) {
  const double c2 = cosine * cosine;
  return sine * carlson_f(c2, c2 + m1 * sine * sine, 1);
}

ThetaSeries::ThetaSeries(double m, double m1) {
  constexpr double small = 1e-9;  // of m: the nome's series after two terms is exact
  const double mean = mean_with_one(std::sqrt(m1));
  rate_ = mean;
  if (m < small) {
    nome_ = m / 16 * (1 + 0.5 * m);
    half_height_ = -0.5 * std::log(nome_);
  } else {
    half_height_ = 0.5 * std::numbers::pi * mean / mean_with_one(std::sqrt(m));
    nome_ = std::exp(-2 * half_height_);
  }
  // Powers of the nome until no term counts any more, and the functions of z = 0.
  const double root = std::sqrt(nome_);
  double even = 1, odd = 1, power = 1, bound = 1;  // power: q^(2 n)
  double theta2 = 0, theta3 = 1, theta4 = 1, sign = 1;
  for (terms_ = 0; terms_ < max_terms && bound > 1e-18; ++terms_) {
    const auto n = static_cast<std::size_t>(terms_);
    even_[n] = even;
    odd_[n] = odd;
    theta2 += odd;
    if (terms_ > 0) {
      theta3 += 2 * even;
      theta4 += 2 * sign * even;
    }
    sign = -sign;
    even *= power * nome_;
    bound *= power * root;
    power *= nome_ * nome_;
    odd *= power;
  }
  sn_ = theta3 / theta2;
  cn_ = theta4 / theta2;
  dn_ = theta4 / theta3;
}

void ThetaSeries::take_theta4(double y) {
  is_odd_ = false;
  const double grow = std::exp(2 * y), shrink = 1 / grow;
  double up = 1, down = 1, sign = 1;
  for (std::size_t n = 0; n < static_cast<std::size_t>(terms_); ++n) {
    const double factor = n == 0 ? 0.5 : sign * even_[n];
    re_[n] = factor * (up + down);
    im_[n] = -factor * (up - down);
    up *= grow;
    down *= shrink;
    sign = -sign;
  }
}

void ThetaSeries::take_theta1(double y) {
  is_odd_ = true;
  // Over exp(y), which may be large.
  const double shrink = std::exp(-2 * y), grow = 1 / shrink;
  double up = 1, down = shrink, sign = 1;
  for (std::size_t n = 0; n < static_cast<std::size_t>(terms_); ++n) {
    re_[n] = sign * odd_[n] * (up + down);
    im_[n] = -sign * odd_[n] * (up - down);
    up *= grow;
    down *= shrink;
    sign = -sign;
  }
}

ThetaSeries::Values ThetaSeries::at(double z) const {
  const double c1 = std::cos(z), s1 = std::sin(z), c2 = c1 * c1 - s1 * s1, s2 = 2 * s1 * c1;
  double sn = 0, cn = 0, dn = 0, re = 0, im = 0, sign = 1;
  double odd_c = c1, odd_s = s1, even_c = 1, even_s = 0;  // of (2 n + 1) z and 2 n z
  for (std::size_t n = 0; n < static_cast<std::size_t>(terms_); ++n) {
    sn += sign * odd_[n] * odd_s;
    cn += odd_[n] * odd_c;
    dn += (n == 0 ? 1 : 2) * even_[n] * even_c;
    re += re_[n] * (is_odd_ ? odd_s : even_c);
    im += im_[n] * (is_odd_ ? odd_c : even_s);
    const double next_odd = odd_c * c2 - odd_s * s2, next_even = even_c * c2 - even_s * s2;
    odd_s = odd_c * s2 + odd_s * c2;
    even_s = even_c * s2 + even_s * c2;
    odd_c = next_odd;
    even_c = next_even;
    sign = -sign;
  }
  return {sn_ * sn, cn_ * cn, dn_ * dn, re, im};
}

double ThetaSeries::zeta(double y) const {
  const double grow = std::exp(2 * y), shrink = 1 / grow;
  double theta = 1, slope = 0, up = 1, down = 1, sign = 1;
  for (int n = 1; n < terms_; ++n) {
    up *= grow;
    down *= shrink;
    sign = -sign;
    const double factor = sign * even_[static_cast<std::size_t>(n)];
    theta += factor * (up + down);
    slope -= 2 * n * factor * (up - down);
  }
  return rate_ * slope / theta;
}

}  // namespace talus
