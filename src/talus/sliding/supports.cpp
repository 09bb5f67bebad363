#include "talus/sliding/supports.hpp"

#include <algorithm>

namespace talus {

namespace {

using tolerance::same_support;

}  // namespace

void Supports::add(const Vec3& n) {
  for (int i = 0; i < count_; ++i) {
    if ((*this)[i].dot(n) > 1 - same_support) return;
  }
  if (count_ < static_cast<int>(normals_.size())) normals_[static_cast<std::size_t>(count_++)] = n;
}

Footing footing_on(const Vec3& gravity, const Supports& supports) {
  const double g = gravity.norm();
  const auto enters_none = [&](const Vec3& a) {
    for (int i = 0; i < supports.count(); ++i) {
      if (a.dot(supports[i]) < -same_support * g) return false;
    }
    return true;
  };
  const int n = supports.count();
  if (enters_none(gravity)) return {gravity, 0};
  for (int i = 0; i < n; ++i) {
    const double force = -gravity.dot(supports[i]);
    const Vec3 left = gravity + force * supports[i];
    if (force >= 0 && enters_none(left)) return {left, force};
  }
  for (int i = 0; i < n; ++i) {
    for (int j = i + 1; j < n; ++j) {
      const double c = supports[i].dot(supports[j]), s = 1 - c * c;
      if (s < same_support) continue;
      const double bi = -gravity.dot(supports[i]), bj = -gravity.dot(supports[j]);
      const double fi = (bi - c * bj) / s, fj = (bj - c * bi) / s;
      const Vec3 left = gravity + fi * supports[i] + fj * supports[j];
      if (fi >= 0 && fj >= 0 && enters_none(left)) return {left, fi + fj};
    }
  }
  for (int i = 0; i < n; ++i) {
    for (int j = i + 1; j < n; ++j) {
      for (int k = j + 1; k < n; ++k) {
        const Vec3 &a = supports[i], &b = supports[j], &c = supports[k];
        const double volume = a.dot(b.cross(c));
        if (std::abs(volume) < same_support) continue;
        const Vec3 share = -gravity / volume;  // Cramer's rule
        const Vec3 forces(share.dot(b.cross(c)), share.dot(c.cross(a)), share.dot(a.cross(b)));
        if (Vec3{}.is_at_most(forces)) return {Vec3{}, forces.sum()};
      }
    }
  }
  return {gravity, 0};
}

bool is_caught_between(const Vec3& gravity, const Vec3& first, const Vec3& second, const Vec3& velocity,
                       double cutoff) {
  const Vec3 edge = first.cross(second);
  const double sine = edge.norm();
  if (sine < same_support) return false;
  const Vec3 e = edge / sine;
  // In each plane, at right angles away from the other one.
  Vec3 out_on_second = e.cross(second), out_on_first = e.cross(first);
  if (out_on_second.dot(first) < 0) out_on_second = -out_on_second;
  if (out_on_first.dot(second) < 0) out_on_first = -out_on_first;
  if (gravity.dot(out_on_second) >= 0 || gravity.dot(out_on_first) >= 0) return false;
  return velocity.dot(out_on_second) < cutoff;
}

Valley valley_between(const Vec3& gravity, const Vec3& first, const Vec3& second) {
  const Vec3 edge = first.cross(second);
  Supports both;
  both.add(first);
  both.add(second);
  // Gravity drives the rock from each onto the other: both carry it.
  const double c = first.dot(second), on_first = -gravity.dot(first), on_second = -gravity.dot(second);
  const double share = (on_first - c * on_second) / ((1 - c) * (on_first + on_second));
  return {edge / edge.norm(), footing_on(gravity, both), std::clamp(share, 0.0, 1.0)};
}

}  // namespace talus
