#include "talus/store/ground_parts.hpp"

#include <algorithm>

namespace talus {

namespace {

/// Whether one part from motion `first` to `last` is near all motions between.
bool fits(const std::vector<Motion>& motions, std::size_t first, std::size_t last) {
  const Motion &from = motions[first], &to = motions[last];
  if (!(to.time > from.time)) return last == first + 1;
  const PathPiece part = ground_part(from, to);
  constexpr double nearest = StoreTolerance::position - 2 * StoreStep::place;  // its ends are rounded
  constexpr double place = nearest * nearest;
  constexpr double share = StoreTolerance::velocity * StoreTolerance::velocity;
  const double speed = share * std::max(from.velocity.squaredNorm(), to.velocity.squaredNorm());
  const double spin = share * std::max(from.spin.squaredNorm(), to.spin.squaredNorm());
  for (std::size_t k = first + 1; k < last; ++k) {
    const double s = motions[k].time - from.time;
    if ((part.velocity(s) - motions[k].velocity).squaredNorm() > speed) return false;
    if ((part.path.at(s) - motions[k].position).squaredNorm() > place) return false;
    if ((part.spin_at(s) - motions[k].spin).squaredNorm() > spin) return false;
  }
  return true;
}

/// The last motion that a part from `first` may end at: sought in strides that double, then by bisection.
std::size_t end_of_part(const std::vector<Motion>& motions, std::size_t first) {
  const std::size_t last = motions.size() - 1;
  std::size_t good = first + 1, stride = 1;
  while (good < last) {
    const std::size_t next = std::min(last, good + stride);
    if (!fits(motions, first, next)) {
      for (std::size_t bad = next; bad - good > 1;) {
        const std::size_t middle = good + (bad - good) / 2;
        (fits(motions, first, middle) ? good : bad) = middle;
      }
      return good;
    }
    good = next;
    stride *= 2;
  }
  return good;
}

}  // namespace

PathPiece ground_part(const Motion& from, const Motion& to) {
  PathPiece part;
  part.duration = to.time - from.time;
  part.start_time = from.time;
  part.spin = from.spin;
  part.on_ground = true;
  part.ends = {from.velocity, to.velocity, to.spin};
  part.path = {from.position, Vec3::Zero(), Vec3::Zero()};
  if (part.duration > 0) {
    part.path.a = (to.velocity - from.velocity) / part.duration;
    part.path.v = (to.position - from.position) / part.duration - 0.5 * part.duration * part.path.a;
  }
  return part;
}

void divide_into_parts(const std::vector<Motion>& motions, std::vector<std::size_t>& ends) {
  for (std::size_t first = 0; first + 1 < motions.size(); first = ends.back()) {
    ends.push_back(end_of_part(motions, first));
  }
}

}  // namespace talus
