#include "talus/impact/rigid_body.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "talus/impact/contact_equations.hpp"
#include "talus/impact/contact_frame.hpp"

namespace talus {

namespace {

/// The body while impulses are sought.
struct Struck {
  Vec3 velocity, spin;
  void add(const Vec3& impulse, const Vec3& arm, const BodyInertia& body) {
    velocity += impulse / body.mass;
    spin += body.inverse_inertia * arm.cross(impulse);
  }
  [[nodiscard]] Vec3 velocity_at(const Vec3& arm) const { return velocity + spin.cross(arm); }
};

/// The moment that resists rolling and pivoting on ground of a normal, for as large a push as there is.
class ResistingMoment {
 public:
  ResistingMoment(const Vec3& n, const BodyInertia& body, MomentArms arms)
      : n_(n), inverse_inertia_(body.inverse_inertia), arms_(arms) {
    if (is_none()) return;
    inertia_ = inverse_inertia_.inverse();
    // Of the inverse inertia about axes across the normal, the principal values and directions.
    const Tangent t(n);
    const Vec3 a = inverse_inertia_ * t.a;
    const double aa = a.dot(t.a), ab = a.dot(t.b), bb = t.b.dot(inverse_inertia_ * t.b);
    const double middle = 0.5 * (aa + bb), aside = 0.5 * (aa - bb), apart = std::hypot(aside, ab);
    const Vec2 first = apart <= tolerance::energy_by_rounding * middle ? Vec2(1, 0)
                       : aside > 0                                     ? Vec2(apart + aside, ab).normalized()
                                                                       : Vec2(ab, apart - aside).normalized();
    values_ = {middle + apart, middle - apart};
    first_ = first.x() * t.a + first.y() * t.b;
    second_ = n.cross(first_);
  }
  [[nodiscard]] bool is_none() const { return arms_.rolling == 0 && arms_.pivot == 0; }
  /// A moment within the limits for a push.
  [[nodiscard]] Vec3 within(const Vec3& moment, double push) const {
    const double pivoting = moment.dot(n_), most_pivot = arms_.pivot * push, most_rolling = arms_.rolling * push;
    Vec3 rolling = moment - pivoting * n_;
    if (const double size = rolling.norm(); size > most_rolling) rolling = most_rolling / size * rolling;
    return rolling + std::clamp(pivoting, -most_pivot, most_pivot) * n_;
  }
  /// The moment impulse that ends the rolling and the pivoting of a spin to which `moment` has been added, or, as large
  /// as `push` allows, is against what is left of them.
  [[nodiscard]] Vec3 ending(const Vec3& spin, const Vec3& moment, double push) const {
    const double most_rolling = arms_.rolling * push, most_pivot = arms_.pivot * push;
    const Vec3 both = moment - inertia_ * spin;
    const double about = both.dot(n_);
    if (std::abs(about) <= most_pivot && (both - about * n_).norm() <= most_rolling) return both;
    const double pivoting = moment.dot(n_);
    const Vec3 rolling = against(spin - inverse_inertia_ * (moment - pivoting * n_), most_rolling);
    if (arms_.pivot == 0) return rolling;
    const double left = (spin + inverse_inertia_ * (rolling + pivoting * n_ - moment)).dot(n_);
    return rolling + std::clamp(pivoting - left / n_.dot(inverse_inertia_ * n_), -most_pivot, most_pivot) * n_;
  }

 private:
  /// What ends the rolling of a spin; or, of the size `most`, is against what is then left: m = -w' / k. By Newton's
  /// method for k, which comes to it from below (J. More and D. Sorensen, 1983).
  [[nodiscard]] Vec3 against(const Vec3& spin, double most) const {
    constexpr int max_steps = 20;
    constexpr double settled = 1e-13;
    if (most <= 0) return {};
    const Vec2 rate(spin.dot(first_), spin.dot(second_));
    double k = 0;
    Vec2 m;
    for (int step = 0; step < max_steps; ++step) {
      const Vec2 sum(values_.x() + k, values_.y() + k);
      m = {-rate.x() / sum.x(), -rate.y() / sum.y()};
      const double size = m.norm();
      if (size - most <= settled * most) break;
      k += (size - most) / most * size * size / (m.x() * m.x() / sum.x() + m.y() * m.y() / sum.y());
    }
    const double size = m.norm();
    if (size > most) m = most / size * m;
    return m.x() * first_ + m.y() * second_;
  }

  Vec3 n_;
  const Mat3& inverse_inertia_;
  MomentArms arms_;
  Mat3 inertia_;
  Vec3 first_, second_;  // principal directions across the normal, unit
  Vec2 values_;
};

class Impulses {
 public:
  Impulses(const Vec3& velocity, const Vec3& spin, const BodyInertia& body, const ContactSet& contacts, double friction,
           MomentArms arms)
      : before_{velocity, spin},
        body_(body),
        friction_(friction),
        arms_(arms),
        size_(contacts.size()),
        resistance_(contacts[0].normal, body, arms) {
    for (std::size_t i = 0; i < size_; ++i) {
      frames_[i].emplace(contacts[i], body);
      approach_[i] = frames_[i]->in_frame(before_.velocity_at(contacts[i].arm));
    }
  }

  /// Contacts may close their gaps in a duration.
  void let_close(const ContactSet& contacts, double duration) {
    for (std::size_t i = 0; i < size_; ++i) closing_[i] = std::max(contacts[i].gap, 0.0) / duration;
  }
  /// `near`: the impulses to begin with; null: none.
  [[nodiscard]] RigidBodyImpact with(Restitution restitution, const ContactImpulses* near = nullptr) const {
    std::array<Vec3, ContactSet::most> targets;
    for (std::size_t i = 0; i < size_; ++i) {
      const Vec3& u = approach_[i];
      targets[i] = {restitution.normal * std::max(-u.x(), 0.0) - closing_[i], restitution.tangential * u.y(),
                    restitution.tangential * u.z()};
    }
    Sought sought{before_, {}, {}};
    if (near != nullptr) {
      for (std::size_t i = 0; i < size_; ++i) sought.impulses[i] = frames_[i]->in_frame(near->at[i]);
      if (!resistance_.is_none()) sought.moment = near->moment;
      sought.struck = struck_by(sought);
    }
    RigidBodyImpact result;
    const bool is_single = size_ == 1 && resistance_.is_none();
    // One contact near to how it is held needs no round before the equations; more settle sooner after one.
    const bool starts_near = !is_single && size_ == 1 && sought.impulses[0] != Vec3{};
    const double settled = near != nullptr ? tolerance::settled_step : tolerance::settled_impact;
    std::optional<ContactEquations> equations;
    for (int round = starts_near ? 0 : 1; round <= tolerance::max_sweeps && !result.has_settled; ++round) {
      if (round > 0) {
        // Contacts that drive each other from stick to slip and back settle by half steps.
        const bool has_settled = take_turns(sought, targets, settled, round > tolerance::sweeps_in_full ? 0.5 : 1);
        result.has_settled = is_single || has_settled;
      }
      const bool is_power_of_two = (round & (round - 1)) == 0;  // or 0
      if (result.has_settled || !is_power_of_two) continue;
      if (!equations) set_equations(equations.emplace(body_, friction_, arms_), targets);
      result.has_settled = solve(*equations, settled, sought);
    }
    result.by.moment = sought.moment;
    for (std::size_t i = 0; i < size_; ++i) result.by.at[i] = frames_[i]->in_terrain(sought.impulses[i]);
    result.rebound = {sought.struck.velocity, sought.struck.spin};
    return result;
  }
  /// The kinetic energy that impulses add: P (u + u') / 2 of each [J].
  [[nodiscard]] double work(const RigidBodyImpact& impact) const {
    const Struck after{impact.rebound.velocity, impact.rebound.spin};
    double sum = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      const Vec3& arm = frames_[i]->arm();
      sum += 0.5 * impact.by.at[i].dot(before_.velocity_at(arm) + after.velocity_at(arm));
    }
    return sum + 0.5 * impact.by.moment.dot(before_.spin + after.spin);
  }
  [[nodiscard]] bool gains(const RigidBodyImpact& impact) const {
    return work(impact) > tolerance::energy_by_rounding * turnover(impact);
  }
  /// Impulses that have not settled, lowered by a common factor to where they take most energy.
  [[nodiscard]] RigidBodyImpact lowered(RigidBodyImpact impact) const {
    const Struck after{impact.rebound.velocity, impact.rebound.spin};
    double taken = 0, returned = 0;  // P u and P (u' - u)
    for (std::size_t i = 0; i < size_; ++i) {
      const Vec3& arm = frames_[i]->arm();
      taken -= impact.by.at[i].dot(before_.velocity_at(arm));
      returned += impact.by.at[i].dot(after.velocity_at(arm) - before_.velocity_at(arm));
    }
    taken -= impact.by.moment.dot(before_.spin);
    returned += impact.by.moment.dot(after.spin - before_.spin);
    const double factor = taken > 0 ? std::min(1.0, taken / returned) : 0;
    Struck struck = before_;
    for (std::size_t i = 0; i < size_; ++i) {
      impact.by.at[i] *= factor;
      struck.add(impact.by.at[i], frames_[i]->arm(), body_);
    }
    impact.by.moment *= factor;
    struck.spin += body_.inverse_inertia * impact.by.moment;
    impact.rebound = {struck.velocity, struck.spin};
    return impact;
  }
  /// The energy that the impulses turn over, against which rounding is measured [J].
  [[nodiscard]] double turnover(const RigidBodyImpact& impact) const {
    double sum = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      sum += impact.by.at[i].norm() * before_.velocity_at(frames_[i]->arm()).norm();
    }
    return sum;
  }

 private:
  /// Impulses in the frames of the contacts, and the body after them.
  struct Sought {
    Struck struck;
    std::array<Vec3, ContactSet::most> impulses;
    Vec3 moment;
  };

  [[nodiscard]] Struck struck_by(const Sought& sought) const {
    Struck struck = before_;
    for (std::size_t i = 0; i < size_; ++i) {
      if (sought.impulses[i] == Vec3{}) continue;
      struck.add(frames_[i]->in_terrain(sought.impulses[i]), frames_[i]->arm(), body_);
    }
    struck.spin += body_.inverse_inertia * sought.moment;
    return struck;
  }
  /// Solves each contact once, and then the moment. Whether that changes next to no velocity. `share`: of the changes
  /// made.
  [[nodiscard]] bool take_turns(Sought& sought, const std::array<Vec3, ContactSet::most>& targets, double settled,
                                double share) const {
    double changed = 0, total = 0, push = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      const ContactFrame& frame = *frames_[i];
      Vec3& impulse = sought.impulses[i];
      const Vec3 now = frame.in_frame(sought.struck.velocity_at(frame.arm()));
      const Vec3 without = now - frame.response() * impulse;
      Vec3 next = impulse_for(frame, targets[i] - without, friction_, impulse);
      if (share != 1) next = impulse + share * (next - impulse);
      const Vec3 change = next - impulse;
      if (change != Vec3{}) sought.struck.add(frame.in_terrain(change), frame.arm(), body_);
      changed += (frame.response() * change).norm();
      total += (frame.response() * next).norm();
      push += next.x();
      impulse = next;
    }
    if (!resistance_.is_none()) {
      const Vec3 change = resistance_.ending(sought.struck.spin, sought.moment, push) - sought.moment;
      sought.struck.spin += body_.inverse_inertia * change;
      sought.moment += change;
      changed += (body_.inverse_inertia * change).norm() * frames_[0]->arm().norm();
    }
    return changed <= settled * total;
  }
  void set_equations(ContactEquations& equations, const std::array<Vec3, ContactSet::most>& targets) const {
    for (std::size_t i = 0; i < size_; ++i) equations.add(*frames_[i], approach_[i] - targets[i]);
    if (!resistance_.is_none()) equations.add_moment(frames_[0]->axes(), frames_[0]->arm().norm(), before_.spin);
    equations.prepare();
  }
  /// Impulses found are off by rounding and what is settled: the limits of friction are kept exactly.
  [[nodiscard]] bool solve(const ContactEquations& equations, double settled, Sought& sought) const {
    const double scale = frames_[0]->arm().norm();
    ContactEquations::Unknowns z{};
    for (std::size_t i = 0; i < size_; ++i) {
      for (std::size_t k = 0; k < 3; ++k) z[3 * i + k] = sought.impulses[i][k];
    }
    const Vec3 moment = frames_[0]->in_frame(sought.moment) / scale;
    for (std::size_t k = 0; k < 3; ++k) z[3 * size_ + k] = moment[k];
    if (!equations.solve(z, settled)) return false;
    double push = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      const double normal = std::max(z[3 * i], 0.0), along = std::hypot(z[3 * i + 1], z[3 * i + 2]);
      const double kept = along > friction_ * normal ? friction_ * normal / along : 1;
      sought.impulses[i] = {normal, kept * z[3 * i + 1], kept * z[3 * i + 2]};
      push += normal;
    }
    if (!resistance_.is_none()) {
      const Vec3 found = scale * frames_[0]->in_terrain({z[3 * size_], z[3 * size_ + 1], z[3 * size_ + 2]});
      sought.moment = resistance_.within(found, push);
    }
    sought.struck = struck_by(sought);
    return true;
  }

  Struck before_;
  const BodyInertia& body_;
  double friction_;
  MomentArms arms_;
  std::size_t size_;
  ResistingMoment resistance_;
  std::array<std::optional<ContactFrame>, ContactSet::most> frames_;
  std::array<Vec3, ContactSet::most> approach_;     // velocities before, in the frames
  std::array<double, ContactSet::most> closing_{};  // how fast they may approach the ground [m/s]
};

}  // namespace

RigidBodyImpact rigid_body_impact(const Vec3& velocity, const Vec3& spin, const BodyInertia& body,
                                  const ContactSet& contacts, Restitution restitution, double friction,
                                  MomentArms arms) {
  const Impulses impulses(velocity, spin, body, contacts, friction, arms);
  RigidBodyImpact impact = impulses.with(restitution);
  if (!impulses.gains(impact)) return impact;
  double least = 0, most = 1;  // factors: with `least` energy does not grow, with `most` it does
  impact = impulses.with({});
  constexpr int halvings = 20;
  for (int i = 0; i < halvings; ++i) {
    const double factor = 0.5 * (least + most);
    const RigidBodyImpact lower = impulses.with({factor * restitution.normal, factor * restitution.tangential});
    (impulses.gains(lower) ? most : least) = factor;
    if (least == factor) impact = lower;
  }
  if (impulses.gains(impact)) impact = impulses.lowered(impact);
  impact.is_limited = true;
  return impact;
}

RigidBodyImpact held_by_contacts(const Vec3& velocity, const Vec3& spin, const BodyInertia& body,
                                 const ContactSet& contacts, double duration, double friction, MomentArms arms,
                                 const ContactImpulses& near) {
  Impulses impulses(velocity, spin, body, contacts, friction, arms);
  impulses.let_close(contacts, duration);
  const RigidBodyImpact impact = impulses.with({}, &near);
  return impulses.gains(impact) ? impulses.lowered(impact) : impact;
}

}  // namespace talus
