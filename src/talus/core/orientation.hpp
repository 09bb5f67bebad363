#pragma once
// How a body is turned: a unit quaternion that takes vectors from the frame of the body to that of the terrain.

#include <cmath>
#include <numbers>

#include "talus/core/matrix.hpp"

namespace talus {

/// w + x i + y j + z k, of norm 1.
class Orientation {
 public:
  constexpr Orientation() = default;
  /// Need not be of norm 1, but must not be 0.
  Orientation(double w, double x, double y, double z) : w_(w), v_(x, y, z) {
    const double norm = std::sqrt(w_ * w_ + v_.squared_norm());
    w_ /= norm;
    v_ /= norm;
  }
  /// Of norm 1 but for rounding, which is kept.
  [[nodiscard]] static constexpr Orientation of_unit(double w, const Vec3& xyz) {
    Orientation orientation;
    orientation.w_ = w;
    orientation.v_ = xyz;
    return orientation;
  }
  /// The turn about a rotation vector, by its length [rad].
  [[nodiscard]] static Orientation of_turn(const Vec3& turn) {
    const double angle = turn.norm();
    // sin(a/2)/a; below this angle 1/2 to the last digit.
    const double share = angle > 1e-8 ? std::sin(0.5 * angle) / angle : 0.5;
    const Vec3 v = share * turn;
    return {std::cos(0.5 * angle), v.x(), v.y(), v.z()};
  }
  /// Every orientation is equally likely if the three numbers are uniform in (0, 1): K. Shoemake, "Uniform random
  /// rotations", Graphics Gems III (1992).
  [[nodiscard]] static Orientation uniform(double u, double v, double w) {
    const double p = std::sqrt(1 - u), q = std::sqrt(u), a = 2 * std::numbers::pi * v, b = 2 * std::numbers::pi * w;
    return {q * std::cos(b), p * std::sin(a), p * std::cos(a), q * std::sin(b)};
  }

  /// Of a rotation matrix, by its largest component (S. W. Shepperd, "Quaternion from rotation matrix", 1978).
  [[nodiscard]] static Orientation of_matrix(const Mat3& r) {
    const double xx = r.rows[0][0], yy = r.rows[1][1], zz = r.rows[2][2], trace = xx + yy + zz;
    const double x = r.rows[2][1] - r.rows[1][2], y = r.rows[0][2] - r.rows[2][0], z = r.rows[1][0] - r.rows[0][1];
    const double xy = r.rows[0][1] + r.rows[1][0], xz = r.rows[0][2] + r.rows[2][0], yz = r.rows[1][2] + r.rows[2][1];
    if (trace >= xx && trace >= yy && trace >= zz) return {1 + trace, x, y, z};
    if (xx >= yy && xx >= zz) return {x, 1 + xx - yy - zz, xy, xz};
    if (yy >= zz) return {y, xy, 1 - xx + yy - zz, yz};
    return {z, xz, yz, 1 - xx - yy + zz};
  }

  [[nodiscard]] double w() const { return w_; }
  [[nodiscard]] const Vec3& xyz() const { return v_; }

  /// From the frame of the body to that of the terrain.
  [[nodiscard]] Vec3 to_world(const Vec3& v) const { return turned(v, w_); }
  [[nodiscard]] Vec3 to_body(const Vec3& v) const { return turned(v, -w_); }
  [[nodiscard]] Mat3 matrix() const { return Mat3::of_columns(to_world(unit_x), to_world(unit_y), to_world(unit_z)); }
  /// First `b`, then `a`.
  [[nodiscard]] friend Orientation operator*(const Orientation& a, const Orientation& b) {
    const Vec3 v = a.w_ * b.v_ + b.w_ * a.v_ + a.v_.cross(b.v_);
    return {a.w_ * b.w_ - a.v_.dot(b.v_), v.x(), v.y(), v.z()};
  }
  [[nodiscard]] friend bool operator==(const Orientation& a, const Orientation& b) = default;

 private:
  [[nodiscard]] Vec3 turned(const Vec3& v, double w) const {
    const Vec3 t = 2 * v_.cross(v);
    return v + w * t + v_.cross(t);
  }

  double w_ = 1;
  Vec3 v_;
};

/// A symmetric tensor with these principal values along the axes of a body, in the frame of the terrain.
[[nodiscard]] inline Mat3 in_world(const Orientation& orientation, const Vec3& principal) {
  const Mat3 r = orientation.matrix();
  return r * Mat3::diagonal(principal) * r.transposed();
}

}  // namespace talus
