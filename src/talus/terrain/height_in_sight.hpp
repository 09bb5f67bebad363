#pragma once
// The height of a flight over one plane of ground that other ground may hide from it, as an overhang hides the ground
// under it.

#include <algorithm>
#include <limits>
#include <vector>

#include "talus/rocks/parabola.hpp"
#include "talus/rocks/touch.hpp"

namespace talus {

/// A flight over a plane: its height is h0 + h1 t + half_a t^2 [m] while it is over the ground in that plane.
struct OverPlane {
  TimeWindow window;
  double h0, h1;
};

/// The maximum height of a flight over a plane. Its vertical acceleration is 2 half_a [m/s2], not positive.
[[nodiscard]] inline double max_height_over(const OverPlane& ground, double half_a) {
  const auto [enter, leave] = ground.window;
  const double t = std::clamp(half_a < 0 ? -ground.h1 / (2 * half_a) : enter, enter, leave);
  const auto height = [&](double at) { return ground.h0 + at * (ground.h1 + half_a * at); };
  return std::max(height(t), height(leave));
}

/// The parts of a flight in which it can see one plane of ground. All planes are below one flight, so the difference of
/// their heights is linear in time.
class HeightInSight {
 public:
  /// `flight`: the duration of the whole flight [s].
  HeightInSight(const OverPlane& ground, double half_a, double flight)
      : ground_(ground), half_a_(half_a), is_instant_(flight <= tolerance::no_time) {
    // Ground that the flight is over only for an instant continues next to it, or ends.
    if (is_instant_ || !lasts_an_instant(ground.window)) seen_.push_back(ground.window);
  }

  /// Other ground hides this while it is below the flight and nearer to it.
  void hide(const OverPlane& other) {
    TimeWindow nearer{std::max(ground_.window.enter, other.window.enter),
                      std::min(ground_.window.leave, other.window.leave)};
    const double d0 = ground_.h0 - other.h0 - contact_slack, d1 = ground_.h1 - other.h1;
    if (d1 > 0) {
      nearer.enter = std::max(nearer.enter, -d0 / d1);
    } else if (d1 < 0) {
      nearer.leave = std::min(nearer.leave, -d0 / d1);
    } else if (d0 <= 0) {
      return;
    }
    // Ground that is nearer only for an instant, where one ends and the other begins, does not hide the other.
    if (is_instant_ ? nearer.is_empty() : lasts_an_instant(nearer)) return;
    const double middle = 0.5 * (nearer.enter + nearer.leave);
    if (other.h0 + middle * (other.h1 + half_a_ * middle) < -contact_slack) return;
    if (is_instant_) {
      seen_.clear();
    } else {
      take_away(nearer);
    }
  }

  /// The maximum height; -infinity if the ground is hidden all the time.
  [[nodiscard]] double maximum() const {
    double maximum = -std::numeric_limits<double>::infinity();
    for (const TimeWindow& seen : seen_) {
      maximum = std::max(maximum, max_height_over({seen, ground_.h0, ground_.h1}, half_a_));
    }
    return maximum;
  }

 private:
  [[nodiscard]] static bool lasts_an_instant(const TimeWindow& window) {
    return window.leave - window.enter <= tolerance::no_time;
  }

  void take_away(const TimeWindow& hidden) {
    std::vector<TimeWindow> left;
    for (const TimeWindow& seen : seen_) {
      const TimeWindow before{seen.enter, std::min(seen.leave, hidden.enter)};
      const TimeWindow after{std::max(seen.enter, hidden.leave), seen.leave};
      for (const TimeWindow& part : {before, after}) {
        if (!lasts_an_instant(part)) left.push_back(part);
      }
    }
    seen_ = std::move(left);
  }

  OverPlane ground_;
  double half_a_;
  bool is_instant_;
  std::vector<TimeWindow> seen_;
};

}  // namespace talus
