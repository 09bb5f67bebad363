#include "talus/seeding/release_lines.hpp"

#include <algorithm>

namespace talus {

void ReleaseLines::add(std::span<const Vec3> points, SourceId source) {
  lines_.push_back({points_.size(), source});
  double way = length();
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (k > 0) way += (points[k] - points[k - 1]).norm();
    points_.push_back(points[k]);
    way_.push_back(way);
  }
}

ReleaseLines::Place ReleaseLines::at(double u) const {
  const double way = u * length();
  // The first point further along: the one before it is on the same line, since a new line begins where the last ended.
  const auto after = std::upper_bound(way_.begin(), way_.end(), way);
  const auto k = static_cast<std::size_t>(after - way_.begin());
  Vec3 point = points_.back();
  if (k > 0 && k < points_.size()) {
    point = points_[k - 1] + (way - way_[k - 1]) / (way_[k] - way_[k - 1]) * (points_[k] - points_[k - 1]);
  }
  const auto line = std::upper_bound(lines_.begin(), lines_.end(), std::min(k, points_.size() - 1),
                                     [](std::size_t at, const Line& l) { return at < l.first; });
  return {point, std::prev(line)->source};
}

}  // namespace talus
