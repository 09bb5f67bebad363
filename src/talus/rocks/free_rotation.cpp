#include "talus/rocks/free_rotation.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace talus {

namespace {

constexpr std::array<Vec3, 3> axes{unit_x, unit_y, unit_z};

/// Below this share of the spin, its part across an axis is rounding.
constexpr double steady_share = 1e-14;

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
  const bool turns = largest > steady_share * steady_share * w.squared_norm() && squared_rate > 0;
  if (!turns) {
    is_steady_ = true;
    return;
  }
  rate_ = std::sqrt(squared_rate);
  amplitude_a_ = std::sqrt(largest);
  amplitude_c_ = std::copysign(std::sqrt(circled), wc);
  amplitude_b_ = sigma * (ic - ia) * amplitude_a_ * amplitude_c_ / (ib * rate_);
  m1_ = std::clamp((beyond(c_) + beyond(a_)) / (circled * ic * (ic - ib)), 1e-300, 1.0);
  jacobi_ = JacobiSeries(m1_);
  const double am0 = std::atan2(wb / amplitude_b_, wa / amplitude_a_);
  u0_ = elliptic_f(am0, m1_);

  const bool pole_is_a = ia * amplitude_a_ < ic * std::abs(amplitude_c_);
  pole_ = pole_is_a ? a_ : c_;
  const double ip = inertia[pole_], l = std::sqrt(l2);
  const double reach = ip * (pole_is_a ? amplitude_a_ : amplitude_c_) / l, q = reach * reach;
  even_rate_ = l / ip;
  factor_ = (twice_energy * ip - l2) / (l * ip * (1 - q) * rate_);
  n_ = -q / (1 - q) * (pole_is_a ? 1 : 1 - m1_);
  pi0_ = elliptic_pi(n_, am0, m1_);

  axis_ = start.to_world(momentum) / l;
  ahead_ = tangential(start.to_world(axes[pole_]), axis_).normalized();
  aside_ = axis_.cross(ahead_);
}

Vec3 FreeRotation::body_spin(const JacobiFunctions& jacobi) const {
  Vec3 w;
  w[a_] = amplitude_a_ * jacobi.cn;
  w[b_] = amplitude_b_ * jacobi.sn;
  w[c_] = amplitude_c_ * jacobi.dn;
  return w;
}

FreeRotation::State FreeRotation::at(double t) const {
  if (is_steady_) return {Orientation::of_turn(t * start_spin_) * start_, start_spin_};
  const JacobiFunctions jacobi = jacobi_.at(rate_ * t + u0_);
  const Vec3 w = body_spin(jacobi);
  const double psi = even_rate_ * t + factor_ * (elliptic_pi(n_, jacobi.am, m1_) - pi0_);
  // The same three directions in both frames: along L, the pole across L, and across both.
  const Vec3 axis = inertia_.times(w).normalized();
  const Vec3 ahead = tangential(axes[pole_], axis).normalized(), aside = axis.cross(ahead);
  const Vec3 ahead_now = std::cos(psi) * ahead_ + std::sin(psi) * aside_;
  const Mat3 turned = Mat3::of_columns(ahead_now, axis_.cross(ahead_now), axis_) * Mat3{{ahead, aside, axis}};
  const Orientation orientation = Orientation::of_matrix(turned);
  return {orientation, turned * w};
}

}  // namespace talus
