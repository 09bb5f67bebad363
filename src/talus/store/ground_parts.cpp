#include "talus/store/ground_parts.hpp"

#include <algorithm>

namespace talus {

namespace {

/// The parabola of a part; its duration is more than 0.
Parabola parabola_between(const Motion& from, const Motion& to, double duration) {
  const Vec3 acceleration = (to.velocity - from.velocity) / duration;
  return {from.position, (to.position - from.position) / duration - 0.5 * duration * acceleration, acceleration};
}

/// One part between two motions of a list, held against the motions between.
class Trial {
 public:
  Trial(const std::vector<Motion>& motions, std::size_t first, std::size_t last)
      : motions_(motions), first_(first), last_(last) {
    const Motion &from = motions[first], &to = motions[last];
    duration_ = to.time - from.time;
    if (!(duration_ > 0)) return;
    path_ = parabola_between(from, to, duration_);
    spin_rate_ = (to.spin - from.spin) / duration_;
    constexpr double share = StoreTolerance::velocity * StoreTolerance::velocity;
    most_velocity_ = share * std::max(from.velocity.squared_norm(), to.velocity.squared_norm());
    most_spin_ = share * std::max(from.spin.squared_norm(), to.spin.squared_norm());
  }

  [[nodiscard]] bool is_near_all() const {
    if (!(duration_ > 0)) return last_ == first_ + 1;
    for (std::size_t k = first_ + 1; k < last_; ++k) {
      if (!is_near(k)) return false;
    }
    return true;
  }
  /// Where a part of a smooth motion is farthest from it: halfway, or not far from there.
  [[nodiscard]] bool is_near_some() const {
    if (!(duration_ > 0)) return last_ == first_ + 1;
    const std::size_t between = last_ - first_;
    return is_near(first_ + between / 2) && is_near(first_ + between / 4) && is_near(last_ - between / 4);
  }

 private:
  [[nodiscard]] bool is_near(std::size_t k) const {
    constexpr double nearest = StoreTolerance::position - 2 * StoreStep::place;  // its ends are rounded
    const Motion &from = motions_[first_], &motion = motions_[k];
    const double s = motion.time - from.time;
    return (from.velocity + s * path_.a - motion.velocity).squared_norm() <= most_velocity_ &&
           (path_.at(s) - motion.position).squared_norm() <= nearest * nearest &&
           (from.spin + s * spin_rate_ - motion.spin).squared_norm() <= most_spin_;
  }

  const std::vector<Motion>& motions_;
  std::size_t first_, last_;
  double duration_, most_velocity_ = 0, most_spin_ = 0;
  Parabola path_;  // if there is a duration
  Vec3 spin_rate_;
};

/// The largest number from `good` on, below `bad`, that passes; between two that pass all others do.
template <class Passes>
std::size_t last_that(const Passes& passes, std::size_t good, std::size_t bad) {
  while (bad - good > 1) {
    const std::size_t middle = good + (bad - good) / 2;
    (passes(middle) ? good : bad) = middle;
  }
  return good;
}

/// The last motion that a part from `first` may end at. A few motions between tell where that is: sought in strides
/// that double, then by bisection. Then all are looked at.
std::size_t end_of_part(const std::vector<Motion>& motions, std::size_t first) {
  const auto some = [&](std::size_t last) { return Trial(motions, first, last).is_near_some(); };
  const auto all = [&](std::size_t last) { return Trial(motions, first, last).is_near_all(); };
  std::size_t good = first + 1, bad = motions.size();
  for (std::size_t stride = 1; good + stride < motions.size(); stride *= 2) {
    if (!some(good + stride)) {
      bad = good + stride;
      break;
    }
    good += stride;
  }
  const std::size_t end = last_that(some, good, bad);
  return all(end) ? end : last_that(all, first + 1, end);
}

}  // namespace

PathPiece ground_part(const Motion& from, const Motion& to) {
  PathPiece part;
  part.duration = to.time - from.time;
  part.start_time = from.time;
  part.spin = from.spin;
  part.on_ground = true;
  part.ends = {from.velocity, to.velocity, to.spin};
  part.path = part.duration > 0 ? parabola_between(from, to, part.duration) : Parabola{from.position, Vec3{}, Vec3{}};
  return part;
}

void divide_into_parts(const std::vector<Motion>& motions, std::vector<std::size_t>& ends) {
  for (std::size_t first = 0; first + 1 < motions.size(); first = ends.back()) {
    ends.push_back(end_of_part(motions, first));
  }
}

}  // namespace talus
