#include "talus/results/runout_frame.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "talus/core/check.hpp"

namespace talus {

RunoutFrame RunoutFrame::from(const Vec2& origin) {
  RunoutFrame frame;
  frame.points_ = {origin};
  return frame;
}

RunoutFrame RunoutFrame::along(std::vector<Vec2> line) {
  TALUS_PROMISE(line.size() > 1, "a line has two points");
  RunoutFrame frame;
  frame.points_ = std::move(line);
  frame.chainages_ = {0};
  for (std::size_t k = 1; k < frame.points_.size(); ++k)
    frame.chainages_.push_back(frame.chainages_.back() + (frame.points_[k] - frame.points_[k - 1]).norm());
  return frame;
}

RunoutPlace RunoutFrame::of(const Vec2& release, const Vec2& place) const {
  if (!is_along_line()) {
    const Vec2 d = place - (points_.empty() ? release : points_.front());
    return {std::hypot(d.x(), d.y())};
  }
  constexpr double same = 1e-9;  // distances that differ by less are equal [m]
  const double infinity = std::numeric_limits<double>::infinity();
  RunoutPlace nearest;
  double least = infinity, most_aside = 0;
  const std::size_t segments = points_.size() - 1;
  for (std::size_t k = 0; k < segments; ++k) {
    const Vec2 d = points_[k + 1] - points_[k];
    const double length = d.norm();
    const Vec2 ahead = d / length, from = place - points_[k];
    const double at = std::clamp(from.dot(ahead), k == 0 ? -infinity : 0.0, k + 1 == segments ? infinity : length);
    const double aside = ahead.x() * from.y() - ahead.y() * from.x(), distance = (from - at * ahead).norm();
    // At a bend two segments are equally near. The one that the place is further aside of says on which side it is.
    const bool is_nearer = distance < least - same;
    if (!is_nearer && (distance > least + same || std::abs(aside) <= most_aside)) continue;
    least = std::min(least, distance);
    most_aside = std::abs(aside);
    nearest = {chainages_[k] + at, std::copysign(distance, aside)};
  }
  return nearest;
}

}  // namespace talus
