#include "talus/rocks/free_rotation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace talus {

namespace {

constexpr std::array<Vec3, 3> axes{unit_x, unit_y, unit_z};

/// Below this share of the spin, its part across an axis, or the rate at which it turns in the body, is rounding.
constexpr double steady_share = 1e-14;

/// Of 1 - m: less is rounding.
constexpr double min_m1 = 1e-22;

}  // namespace

FreeRotation::FreeRotation(const Vec3& inertia, const Orientation& start, const Vec3& spin)
    : start_(start), start_spin_(spin), inertia_(inertia) {
  const Vec3 w = start.to_body(spin), momentum = inertia.times(w);
  const double l2 = momentum.squared_norm(), twice_energy = momentum.dot(w);
  std::array<std::size_t, 3> order{0, 1, 2};
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t k) { return inertia[i] < inertia[k]; });
  b_ = order[1];
  // L turns about the axis of the largest moment, or about that of the smallest: sum Ii (Ii - Ib) wi^2 > 0 or not.
  const auto beyond = [&](std::size_t i) { return inertia[i] * (inertia[i] - inertia[b_]) * w[i] * w[i]; };
  const bool about_largest = beyond(order[2]) + beyond(order[0]) > 0;
  a_ = about_largest ? order[0] : order[2];
  c_ = about_largest ? order[2] : order[0];
  const double ia = inertia[a_], ib = inertia[b_], ic = inertia[c_];
  const double wa = w[a_], wb = w[b_], wc = w[c_];
  const double sigma = axes[a_].cross(axes[b_]).dot(axes[c_]);

  const double largest = ic == ia ? 0 : wa * wa + ib * (ib - ic) / (ia * (ia - ic)) * wb * wb;
  const double circled = ic == ia ? 0 : wc * wc + ib * (ib - ia) / (ic * (ic - ia)) * wb * wb;
  const double squared_rate = circled * (ic - ia) * (ic - ib) / (ia * ib);
  const bool turns = std::min(largest, squared_rate) > steady_share * steady_share * w.squared_norm();
  if (!turns) {
    is_steady_ = true;
    max_spin_ = spin.norm();
    return;
  }
  const double p = std::sqrt(squared_rate), l = std::sqrt(l2);
  const double amplitude_a = std::sqrt(largest), amplitude_c = std::copysign(std::sqrt(circled), wc);
  const double amplitude_b = sigma * (ic - ia) * amplitude_a * amplitude_c / (ib * p);
  const double scale = circled * ic * (ic - ib);
  const double m1 = std::clamp((beyond(c_) + beyond(a_)) / scale, min_m1, 1.0);
  const double m = std::min(largest * ia * (ib - ia) / scale, 1 - min_m1);
  series_ = ThetaSeries(m, m1);

  const double sn = wb / amplitude_b, cn = wa / amplitude_a, unit = 1 / std::sqrt(sn * sn + cn * cn);
  const double quarter = elliptic_f(sn * unit, std::abs(cn) * unit, m1);
  rate_ = p * series_.rate();
  z0_ = series_.rate() * quarter;
  if (cn < 0) z0_ = std::copysign(std::numbers::pi, sn) - z0_;

  const double along_a = ia * amplitude_a / l, along_c = ic * std::abs(amplitude_c) / l;
  const double across = 1 / std::sqrt(along_a * along_a + along_c * along_c);
  const double y = series_.rate() * elliptic_f(along_c * across, along_a * across, m);
  const bool pole_is_a = along_a < along_c;
  pole_ = pole_is_a ? a_ : c_;
  const double ip = inertia[pole_], other = pole_is_a ? along_c : along_a;    // sqrt(1 - q)
  const double factor = (twice_energy * ip - l2) / (l * ip * other * other);  // s p / S
  sense_ = factor < 0 ? -1 : 1;
  // Z, or 1 / S - Z, whichever is not the difference of large numbers.
  const bool is_near = y < 0.5 * series_.half_height();
  const double zeta = is_near ? series_.zeta(y) : series_.rate() + series_.zeta(series_.half_height() - y);
  const double share = sense_ * p * zeta;
  turning_ = l / ip + (pole_is_a == is_near ? share : factor - share);
  pole_is_a ? series_.take_theta1(y) : series_.take_theta4(y);

  momentum_ = l;
  // The square of the spin is a linear function of sn^2.
  const double at_a = largest + circled, at_b = amplitude_b * amplitude_b + m1 * circled;
  max_spin_ = std::sqrt(std::max(at_a, at_b));
  amplitudes_[a_] = along_a;
  amplitudes_[b_] = ib * amplitude_b / l;
  amplitudes_[c_] = ic * amplitude_c / l;
  axis_ = start.to_world(momentum) / l;
  const Vec3 ahead = tangential(start.to_world(axes[pole_]), axis_).normalized(), aside = axis_.cross(ahead);
  const auto [sn0, cn0, dn0, re, im] = series_.at(z0_);
  const double norm = std::sqrt(re * re + im * im), cosine = re / norm, sine = sense_ * im / norm;
  ahead_ = cosine * ahead - sine * aside;
  aside_ = axis_.cross(ahead_);
}

FreeRotation::Turned FreeRotation::turned_at(double t) const {
  if (is_steady_) return {(Orientation::of_turn(t * start_spin_) * start_).matrix(), start_spin_};
  const auto [sn, cn, dn, re, im] = series_.at(rate_ * t + z0_);
  Vec3 axis;  // along L, in the body's frame
  axis[a_] = amplitudes_[a_] * cn;
  axis[b_] = amplitudes_[b_] * sn;
  axis[c_] = amplitudes_[c_] * dn;
  axis /= axis.norm();
  const double even = turning_ * t, c = std::cos(even), s = std::sin(even), arg = sense_ * im;
  const double share = 1 / std::sqrt(re * re + im * im);
  const double cosine = (c * re - s * arg) * share, sine = (s * re + c * arg) * share;
  // The same three directions in both frames: along L, the pole across L, and across both.
  const Vec3 ahead = tangential(axes[pole_], axis).normalized(), aside = axis.cross(ahead);
  const Vec3 ahead_now = cosine * ahead_ + sine * aside_, aside_now = cosine * aside_ - sine * ahead_;
  const Mat3 turned = Mat3::of_columns(ahead_now, aside_now, axis_) * Mat3{{ahead, aside, axis}};
  const Vec3 w(axis[0] / inertia_[0], axis[1] / inertia_[1], axis[2] / inertia_[2]);
  return {turned, turned * (momentum_ * w)};
}

FreeRotation::State FreeRotation::at(double t) const {
  if (is_steady_) return {Orientation::of_turn(t * start_spin_) * start_, start_spin_};
  const auto [matrix, spin] = turned_at(t);
  return {Orientation::of_matrix(matrix), spin};
}

}  // namespace talus
