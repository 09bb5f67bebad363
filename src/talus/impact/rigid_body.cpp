#include "talus/impact/rigid_body.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "talus/core/tolerances.hpp"

namespace talus {

namespace {

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

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }
Vec2 quarter_turn(const Vec2& a) { return {-a.y(), a.x()}; }

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
      const double off = cross(s, d);
      if (std::abs(off) <= rounding_) {
        if (den <= 0 || s.dot(d) < -rounding_) return std::nullopt;
        const double normal = wanted_normal_ / den;
        return Vec3{normal, -friction_ * normal * d.x(), -friction_ * normal * d.y()};
      }
      const Vec2 slope = friction_ * coupling_.dot(across) * wanted_ - friction_ * wanted_normal_ * times(across);
      const double change = cross(slope, d) + cross(s, across);
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
Vec3 impulse_for(const ContactFrame& frame, const Vec3& wanted, double friction, const Vec3& near) {
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

/// The body while impulses are sought.
struct Struck {
  Vec3 velocity, spin;
  void add(const Vec3& impulse, const Vec3& arm, const BodyInertia& body) {
    velocity += impulse / body.mass;
    spin += body.inverse_inertia * arm.cross(impulse);
  }
  [[nodiscard]] Vec3 velocity_at(const Vec3& arm) const { return velocity + spin.cross(arm); }
};

/// The moment that resists rolling over ground of a normal, for as large a push as there is.
class RollingMoment {
 public:
  RollingMoment(const Vec3& n, const BodyInertia& body, double arm) : t_(n), arm_(arm) {
    if (arm_ == 0) return;
    const Vec3 a = body.inverse_inertia * t_.a, b = body.inverse_inertia * t_.b;
    // Of the inverse inertia about both tangents, the inverse.
    const double aa = a.dot(t_.a), ab = a.dot(t_.b), bb = b.dot(t_.b), det = aa * bb - ab * ab;
    first_ = Vec2(bb, -ab) / det;
    second_ = Vec2(-ab, aa) / det;
  }
  [[nodiscard]] bool is_none() const { return arm_ == 0; }
  /// The moment impulse that ends the rolling of a spin to which `moment` has been added, as far as `push` allows.
  [[nodiscard]] Vec3 ending(const Vec3& spin, const Vec3& moment, double push) const {
    const Vec2 rate(spin.dot(t_.a), spin.dot(t_.b));
    Vec2 wanted(moment.dot(t_.a) - first_.dot(rate), moment.dot(t_.b) - second_.dot(rate));
    const double most = arm_ * push, size = wanted.norm();
    if (size > most) wanted = most / size * wanted;
    return wanted.x() * t_.a + wanted.y() * t_.b;
  }

 private:
  Tangent t_;
  double arm_;  // moment over push [m]
  Vec2 first_, second_;
};

class Impulses {
 public:
  /// `rolling_arm`: of the moment that resists rolling [m]; 0: none.
  Impulses(const Vec3& velocity, const Vec3& spin, const BodyInertia& body, const ContactSet& contacts, double friction,
           double rolling_arm)
      : before_{velocity, spin},
        body_(body),
        friction_(friction),
        size_(contacts.size()),
        rolling_(contacts[0].normal, body, rolling_arm) {
    for (std::size_t i = 0; i < size_; ++i) {
      frames_[i].emplace(contacts[i], body);
      approach_[i] = frames_[i]->in_frame(before_.velocity_at(contacts[i].arm));
    }
  }

  [[nodiscard]] RigidBodyImpact with(Restitution restitution) const {
    constexpr double max_kept = 0.98;  // of a change by the next
    RigidBodyImpact result;
    Struck struck = before_;
    std::array<Vec3, ContactSet::most> impulses, changes;  // in the frames of the contacts; changes: of the last round
    Vec3 moment, last_moment_change;
    const bool is_single = size_ == 1 && rolling_.is_none();
    result.has_settled = is_single;
    const int sweeps = is_single ? 1 : tolerance::max_sweeps;
    for (int sweep = 0; sweep < sweeps; ++sweep) {
      double changed = 0, total = 0, squared_before = 0, product = 0;
      for (std::size_t i = 0; i < size_; ++i) {
        const ContactFrame& frame = *frames_[i];
        const Vec3& u = approach_[i];
        const Vec3 target(restitution.normal * std::max(-u.x(), 0.0), restitution.tangential * u.y(),
                          restitution.tangential * u.z());
        const Vec3 now = frame.in_frame(struck.velocity_at(frame.arm()));
        const Vec3 without = now - frame.response() * impulses[i];
        Vec3 impulse = impulse_for(frame, target - without, friction_, impulses[i]);
        // Contacts that drive each other from stick to slip and back settle by half steps.
        if (sweep >= tolerance::sweeps_in_full) impulse = 0.5 * (impulse + impulses[i]);
        const Vec3 change = impulse - impulses[i], before = std::exchange(changes[i], change);
        struck.add(frame.in_terrain(change), frame.arm(), body_);
        changed += change.norm();
        total += impulse.norm();
        squared_before += before.squared_norm();
        product += before.dot(change);
        impulses[i] = impulse;
      }
      Vec3 moment_change;
      if (!rolling_.is_none()) {
        double push = 0;
        for (std::size_t i = 0; i < size_; ++i) push += impulses[i].x();
        const Vec3 next = rolling_.ending(struck.spin, moment, push);
        moment_change = next - moment;
        struck.spin += body_.inverse_inertia * moment_change;
        moment = next;
        // In the unit of an impulse, at the arm of the first contact.
        const double arm = frames_[0]->arm().norm();
        const Vec3 now = moment_change / arm, before = std::exchange(last_moment_change, moment_change) / arm;
        changed += now.norm();
        squared_before += before.squared_norm();
        product += before.dot(now);
      }
      if (changed <= tolerance::settled_impulse * total) {
        result.has_settled = true;
        break;
      }
      // Changes that shrink by the same share each round, summed at once (A. Aitken's method).
      const bool is_extrapolated = sweep % 3 == 2 && sweep < tolerance::sweeps_in_full;
      if (!is_extrapolated || !(product > 0 && product < max_kept * squared_before)) continue;
      const double share = product / (squared_before - product);
      for (std::size_t i = 0; i < size_; ++i) {
        impulses[i] += share * changes[i];
        struck.add(frames_[i]->in_terrain(share * changes[i]), frames_[i]->arm(), body_);
      }
      moment += share * moment_change;
      struck.spin += share * (body_.inverse_inertia * moment_change);
    }
    result.moment = moment;
    for (std::size_t i = 0; i < size_; ++i) result.impulses[i] = frames_[i]->in_terrain(impulses[i]);
    result.rebound = {struck.velocity, struck.spin};
    return result;
  }
  /// The kinetic energy that impulses add: P (u + u') / 2 of each [J].
  [[nodiscard]] double work(const RigidBodyImpact& impact) const {
    const Struck after{impact.rebound.velocity, impact.rebound.spin};
    double sum = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      const Vec3& arm = frames_[i]->arm();
      sum += 0.5 * impact.impulses[i].dot(before_.velocity_at(arm) + after.velocity_at(arm));
    }
    return sum + 0.5 * impact.moment.dot(before_.spin + after.spin);
  }
  /// Impulses that have not settled, lowered by a common factor to where they take most energy.
  [[nodiscard]] RigidBodyImpact lowered(RigidBodyImpact impact) const {
    const Struck after{impact.rebound.velocity, impact.rebound.spin};
    double taken = 0, returned = 0;  // P u and P (u' - u)
    for (std::size_t i = 0; i < size_; ++i) {
      const Vec3& arm = frames_[i]->arm();
      taken -= impact.impulses[i].dot(before_.velocity_at(arm));
      returned += impact.impulses[i].dot(after.velocity_at(arm) - before_.velocity_at(arm));
    }
    taken -= impact.moment.dot(before_.spin);
    returned += impact.moment.dot(after.spin - before_.spin);
    const double factor = taken > 0 ? std::min(1.0, taken / returned) : 0;
    Struck struck = before_;
    for (std::size_t i = 0; i < size_; ++i) {
      impact.impulses[i] *= factor;
      struck.add(impact.impulses[i], frames_[i]->arm(), body_);
    }
    impact.moment *= factor;
    struck.spin += body_.inverse_inertia * impact.moment;
    impact.rebound = {struck.velocity, struck.spin};
    return impact;
  }
  /// The energy that the impulses turn over, against which rounding is measured [J].
  [[nodiscard]] double turnover(const RigidBodyImpact& impact) const {
    double sum = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      sum += impact.impulses[i].norm() * before_.velocity_at(frames_[i]->arm()).norm();
    }
    return sum;
  }

 private:
  Struck before_;
  const BodyInertia& body_;
  double friction_;
  std::size_t size_;
  RollingMoment rolling_;
  std::array<std::optional<ContactFrame>, ContactSet::most> frames_;
  std::array<Vec3, ContactSet::most> approach_;  // velocities before, in the frames
};

}  // namespace

RigidBodyImpact rigid_body_impact(const Vec3& velocity, const Vec3& spin, const BodyInertia& body,
                                  const ContactSet& contacts, Restitution restitution, double friction,
                                  double rolling_arm) {
  const Impulses impulses(velocity, spin, body, contacts, friction, rolling_arm);
  const auto gains = [&](const RigidBodyImpact& impact) {
    return impulses.work(impact) > tolerance::energy_by_rounding * impulses.turnover(impact);
  };
  RigidBodyImpact impact = impulses.with(restitution);
  if (!gains(impact)) return impact;
  double least = 0, most = 1;  // factors: with `least` energy does not grow, with `most` it does
  impact = impulses.with({});
  constexpr int halvings = 20;
  for (int i = 0; i < halvings; ++i) {
    const double factor = 0.5 * (least + most);
    const RigidBodyImpact lower = impulses.with({factor * restitution.normal, factor * restitution.tangential});
    (gains(lower) ? most : least) = factor;
    if (least == factor) impact = lower;
  }
  if (gains(impact)) impact = impulses.lowered(impact);
  impact.is_limited = true;
  return impact;
}

}  // namespace talus
