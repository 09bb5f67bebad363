#pragma once
// The equations of several contacts of a rigid body and of the moment that resists its rolling, all at once. Private to
// impact/; rigid_body.hpp has the equations.
//
// Each unknown z - impulses in the frames of their contacts, moments over an arm - has a rate U = U0 + G z. A contact
// is open, sticks or slips by y = z - rho U (P. Alart and A. Curnier, Comput. Methods Appl. Mech. Eng. 92, 1991, doi
// 10.1016/0045-7825(91)90022-X): open if yn <= 0, with z = 0; sticking if |yt| <= mu yn, with U = 0; else slipping,
// with Un = 0 and zt = mu zn yt / |yt|. The same holds for the moment, with the sum of all zn. Newton's method in these
// pieces takes two to five steps, where taking contacts by turns takes tens to thousands: contacts that hold a body
// together with a moment work against each other.

#include <algorithm>
#include <array>

#include "talus/impact/contact_frame.hpp"

namespace talus {

class ContactEquations {
 public:
  static constexpr std::size_t most = 3 * ContactSet::most + 3;
  using Unknowns = std::array<double, most>;

  ContactEquations(const BodyInertia& body, double friction, MomentArms arms)
      : body_(body), friction_(friction), arms_(arms) {}

  /// `rate`: the contact's velocity without impulses, over that wanted of it, in its frame.
  void add(const ContactFrame& frame, const Vec3& rate) {
    for (const Vec3& axis : frame.axes()) rows_[size_++] = {axis, frame.arm().cross(axis)};
    set(size_ - 3, rate);
    ++contacts_;
  }
  /// After the contacts. `scale`: the arm over which moments count as impulses [m].
  void add_moment(const std::array<Vec3, 3>& axes, double scale, const Vec3& spin) {
    for (const Vec3& axis : axes) rows_[size_++] = {{}, scale * axis};
    set(size_ - 3, scale * Vec3(spin.dot(axes[0]), spin.dot(axes[1]), spin.dot(axes[2])));
    scale_ = scale;
    has_moment_ = true;
  }
  /// Computes what an impulse changes; before solve().
  void prepare() {
    for (std::size_t i = 0; i < size_; ++i) {
      const Vec3 turning = body_.inverse_inertia * rows_[i].turn, moving = rows_[i].way / body_.mass;
      for (std::size_t j = i; j < size_; ++j) {
        response_[i][j] = response_[j][i] = moving.dot(rows_[j].way) + turning.dot(rows_[j].turn);
      }
    }
  }
  [[nodiscard]] std::size_t size() const { return size_; }

  /// Moves unknowns to a solution, if one is near; false if none was found. `settled`: the share of the approach by
  /// which rates may be off. Impulses of redundant contacts may go on changing against each other: what counts are
  /// rates.
  [[nodiscard]] bool solve(Unknowns& z, double settled) const {
    constexpr int max_steps = 8;
    double approach = 0;
    for (std::size_t i = 0; i < size_; ++i) approach += std::abs(rate_[i]);
    for (int step = 0;; ++step) {
      System system;
      fill(system, z);
      double off = 0;
      for (std::size_t i = 0; i < size_; ++i) off += response_[i][i] * std::abs(system.a[i][size_]);
      if (off <= settled * approach) return true;
      if (step == max_steps || !std::isfinite(off) || !system.eliminate(size_)) return false;
      for (std::size_t i = 0; i < size_; ++i) z[i] += system.a[i][size_];
    }
  }

 private:
  struct Row {
    Vec3 way, turn;  // the rate of a motion (v, w): way v + turn w
  };
  /// Linear equations, the right side in the column after the last.
  struct System {
    std::array<std::array<double, most + 1>, most> a;

    /// Gauss and Jordan's elimination with pivots by column; the solution replaces the right side.
    [[nodiscard]] bool eliminate(std::size_t size) {
      for (std::size_t k = 0; k < size; ++k) {
        std::size_t best = k;
        for (std::size_t i = k + 1; i < size; ++i) {
          if (std::abs(a[i][k]) > std::abs(a[best][k])) best = i;
        }
        if (!(std::abs(a[best][k]) > 0)) return false;
        if (best != k) std::swap(a[best], a[k]);
        const double inverse = 1 / a[k][k];
        for (std::size_t i = k + 1; i < size; ++i) {
          const double factor = a[i][k] * inverse;
          if (factor == 0) continue;
          for (std::size_t j = k + 1; j <= size; ++j) a[i][j] -= factor * a[k][j];
        }
      }
      for (std::size_t k = size; k-- > 0;) {
        double sum = a[k][size];
        for (std::size_t j = k + 1; j < size; ++j) sum -= a[k][j] * a[j][size];
        a[k][size] = sum / a[k][k];
      }
      return true;
    }
  };

  void set(std::size_t at, const Vec3& rate) {
    for (std::size_t k = 0; k < 3; ++k) rate_[at + k] = rate[k];
  }

  // Of redundant contacts, the impulses that change least: more than rounding, too little to be felt.
  static constexpr double redundant = 1e-5;

  void fill(System& system, const Unknowns& z) const {
    const std::size_t equations = std::min(size_, most);  // which the compiler does not see
    Unknowns rate = rate_;
    for (std::size_t i = 0; i < equations; ++i) {
      for (std::size_t j = 0; j < equations; ++j) rate[i] += response_[i][j] * z[j];
    }
    const auto clear = [&](std::size_t i) { std::fill_n(system.a[i].begin(), equations + 1, 0.0); };
    const auto vanish = [&](std::size_t i) {  // the unknown
      clear(i);
      system.a[i][i] = 1;
      system.a[i][equations] = -z[i];
    };
    const auto stop = [&](std::size_t i) {  // its rate
      const double scale = 1 / response_[i][i];
      for (std::size_t j = 0; j < equations; ++j) system.a[i][j] = scale * response_[i][j];
      system.a[i][i] += redundant;
      system.a[i][equations] = -scale * rate[i];
    };
    double push = 0, pushed = 0;  // now, and as far as the modes need it
    // Two unknowns from i on, of size `limit` at most, which is `share` of the pushes of `from` to `to`.
    const auto resist = [&](std::size_t i, double share, double limit, double now, std::size_t from, std::size_t to) {
      const double rho = 2 / (response_[i][i] + response_[i + 1][i + 1]);
      const Vec2 y(z[i] - rho * rate[i], z[i + 1] - rho * rate[i + 1]);
      const double size = y.norm();
      if (size <= limit) {
        stop(i);
        stop(i + 1);
        return;
      }
      const Vec2 d = y / size;
      const double turning = limit / size;
      for (std::size_t k = 0; k < 2; ++k) {
        auto& row = system.a[i + k];
        clear(i + k);
        row[i + k] = 1;
        for (std::size_t n = from; n < to; n += 3) row[n] -= share * d[k];
        row[equations] = share * now * d[k] - z[i + k];
        for (std::size_t l = 0; l < 2; ++l) {
          const double across = turning * ((k == l ? 1 : 0) - d[k] * d[l]);
          row[i + l] -= across;
          for (std::size_t j = 0; j < equations; ++j) row[j] += across * rho * response_[i + l][j];
        }
      }
    };
    for (std::size_t i = 0; i < 3 * contacts_; i += 3) {
      const double normal = z[i] - rate[i] / response_[i][i];
      if (normal <= 0) {
        for (std::size_t k = 0; k < 3; ++k) vanish(i + k);
        continue;
      }
      push += z[i];
      pushed += normal;
      stop(i);
      resist(i + 1, friction_, friction_ * normal, z[i], i, i + 1);
    }
    if (!has_moment_) return;
    const std::size_t i = 3 * contacts_;
    const double pivot = arms_.pivot / scale_, rolling = arms_.rolling / scale_;
    const double y = z[i] - rate[i] / response_[i][i];
    if (std::abs(y) <= pivot * pushed && pivot > 0) {
      stop(i);
    } else {
      vanish(i);
      const double share = std::copysign(pivot, y);
      for (std::size_t n = 0; n < i; n += 3) system.a[i][n] -= share;
      system.a[i][equations] += share * push;
    }
    if (rolling > 0) {
      resist(i + 1, rolling, rolling * pushed, push, 0, i);
    } else {
      vanish(i + 1);
      vanish(i + 2);
    }
  }

  const BodyInertia& body_;
  double friction_;
  MomentArms arms_;
  double scale_ = 1;
  bool has_moment_ = false;
  std::size_t contacts_ = 0, size_ = 0;
  std::array<Row, most> rows_;
  Unknowns rate_{};
  std::array<Unknowns, most> response_;
};

}  // namespace talus
