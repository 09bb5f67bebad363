#pragma once
// One contact of a rigid body in its own frame: the impulse that changes its velocity as wanted, or as far as friction
// can. Private to impact/; rigid_body.hpp has the equations.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "talus/core/tolerances.hpp"
#include "talus/impact/rigid_body.hpp"

namespace talus {

/// Across a normal.
struct Tangent {
  Vec3 a, b;  // unit, at right angles
  explicit Tangent(const Vec3& n) {
    // Away from the axis to which the normal is nearest.
    const Vec3 away = n.abs().place_of_largest() == 2 ? unit_x : unit_z;
    a = tangential(away, n).normalized();
    b = n.cross(a);
  }
};

[[nodiscard]] inline double cross_product(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }
[[nodiscard]] inline Vec2 quarter_turn(const Vec2& a) { return {-a.y(), a.x()}; }

/// One contact in its own frame: the first coordinate along the normal, the others across it.
class ContactFrame {
 public:
  ContactFrame(const ContactPoint& contact, const BodyInertia& body) : contact_(contact), t_(contact.normal) {
    const auto column = [&](const Vec3& direction) {
      const Vec3 turning = body.inverse_inertia * contact.arm.cross(direction);
      return in_frame(direction / body.mass + turning.cross(contact.arm));
    };
    response_ = Mat3::of_columns(column(contact.normal), column(t_.a), column(t_.b));
    resistance_ = response_.inverse();
  }

  [[nodiscard]] Vec3 in_frame(const Vec3& v) const { return {v.dot(contact_.normal), v.dot(t_.a), v.dot(t_.b)}; }
  [[nodiscard]] Vec3 in_terrain(const Vec3& v) const { return v[0] * contact_.normal + v[1] * t_.a + v[2] * t_.b; }
  /// The change of velocity by an impulse, as a matrix.
  [[nodiscard]] const Mat3& response() const { return response_; }
  /// The impulse for a change of velocity.
  [[nodiscard]] const Mat3& resistance() const { return resistance_; }
  [[nodiscard]] std::array<Vec3, 3> axes() const { return {contact_.normal, t_.a, t_.b}; }
  [[nodiscard]] const Vec3& arm() const { return contact_.arm; }

 private:
  ContactPoint contact_;
  Tangent t_;
  Mat3 response_, resistance_;
};

/// A slipping contact: `wanted` is the change of velocity with which it would stick. With the unit direction d of slip,
/// Pn = wanted_n / den, den = Ann - mu Ant.d, and the slip is s = -wanted_t + Pn (Ant - mu Att d): it must be along d.
class Slip {
 public:
  Slip(const Mat3& response, const Vec3& wanted, double friction)
      : wanted_(wanted.y(), wanted.z()),
        coupling_(response.rows[0].y(), response.rows[0].z()),
        first_(response.rows[1].y(), response.rows[1].z()),
        second_(response.rows[2].y(), response.rows[2].z()),
        normal_(response.rows[0].x()),
        wanted_normal_(wanted.x()),
        friction_(friction),
        rounding_(tolerance::slip_direction * (normal_ * wanted.norm())) {}

  /// The impulse, if slip has the direction to which `guess` is near.
  [[nodiscard]] std::optional<Vec3> impulse_near(const Vec2& guess) const {
    if (guess.squared_norm() == 0) return std::nullopt;
    Vec2 d = guess.normalized();
    for (int step = 0; step < max_steps; ++step) {
      const double den = denominator(d);
      const Vec2 s = scaled_slip(d), across = quarter_turn(d);
      const double off = cross_product(s, d);
      if (std::abs(off) <= rounding_) {
        if (den <= 0 || s.dot(d) < -rounding_) return std::nullopt;
        const double normal = wanted_normal_ / den;
        return Vec3{normal, -friction_ * normal * d.x(), -friction_ * normal * d.y()};
      }
      const Vec2 slope = friction_ * coupling_.dot(across) * wanted_ - friction_ * wanted_normal_ * times(across);
      const double change = cross_product(slope, d) + cross_product(s, across);
      if (change == 0) return std::nullopt;
      d = (d + std::clamp(-off / change, -largest_turn, largest_turn) * across).normalized();
    }
    return std::nullopt;
  }
  /// From all sides.
  [[nodiscard]] std::optional<Vec3> impulse_anywhere() const {
    constexpr int directions = 32;
    for (int i = 0; i < directions; ++i) {
      const double angle = 2 * std::numbers::pi * i / directions;
      if (const auto found = impulse_near({std::cos(angle), std::sin(angle)})) return found;
    }
    return std::nullopt;
  }

 private:
  static constexpr int max_steps = 30;
  static constexpr double largest_turn = 0.5;  // tangent

  [[nodiscard]] Vec2 times(const Vec2& d) const { return {first_.dot(d), second_.dot(d)}; }
  [[nodiscard]] double denominator(const Vec2& d) const { return normal_ - friction_ * coupling_.dot(d); }
  /// The slip times the denominator.
  [[nodiscard]] Vec2 scaled_slip(const Vec2& d) const {
    return wanted_normal_ * (coupling_ - friction_ * times(d)) - denominator(d) * wanted_;
  }

  Vec2 wanted_, coupling_, first_, second_;
  double normal_, wanted_normal_, friction_;
  double rounding_;  // of the scaled slip
};

/// The impulse that changes the contact's velocity by `wanted`, as far as friction can; zero if that is no push.
/// `near`: one to which it may be near.
[[nodiscard]] inline Vec3 impulse_for(const ContactFrame& frame, const Vec3& wanted, double friction,
                                      const Vec3& near) {
  if (wanted.x() <= 0) return {};
  const Mat3& response = frame.response();
  const Vec3 sticking = frame.resistance() * wanted;
  const Vec2 holding(sticking.y(), sticking.z());
  const double most = friction * sticking.x();
  if (sticking.x() >= 0 && holding.squared_norm() <= most * most) return sticking;
  const Slip slip(response, wanted, friction);
  if (const auto found = slip.impulse_near({-near.y(), -near.z()})) return *found;
  if (const auto found = slip.impulse_near(-holding)) return *found;
  if (const auto found = slip.impulse_near({-wanted.y(), -wanted.z()})) return *found;
  if (const auto found = slip.impulse_anywhere()) return *found;
  return {wanted.x() / response.rows[0].x(), 0, 0};  // no direction of slip fits it: without friction
}

}  // namespace talus
