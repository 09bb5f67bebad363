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
  // The first point further along. The one before it is on the same line, since a new line begins at the length at
  // which the last one ended.
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

std::size_t ReleaseLines::line_of(std::uint64_t part, std::uint64_t parts, double v) const {
  const double way = (static_cast<double>(part) + v) / static_cast<double>(parts) * length();
  const auto next = std::upper_bound(lines_.begin() + 1, lines_.end(), way,
                                     [&](double w, const Line& line) { return w < way_[line.first]; });
  return static_cast<std::size_t>(next - lines_.begin()) - 1;
}

ReleaseLines::Place ReleaseLines::at(std::size_t line, double u) const {
  const auto [begin, end] = stretch_of(line);
  return {at((begin + u * (end - begin)) / length()).point, lines_[line].source};
}

ReleaseLines::Place ReleaseLines::in_part(std::uint64_t part, std::uint64_t parts, double v, double u) const {
  const std::size_t line = line_of(part, parts, v);
  const auto [first, last] = stretch_of(line);
  const double share = length() / static_cast<double>(parts);
  const double begin = std::max(first, static_cast<double>(part) * share);
  const double end = std::min(last, static_cast<double>(part + 1) * share);
  return {at((begin + u * std::max(end - begin, 0.0)) / length()).point, lines_[line].source};
}

std::array<double, 2> ReleaseLines::stretch_of(std::size_t line) const {
  return {way_[lines_[line].first], line + 1 < lines_.size() ? way_[lines_[line + 1].first] : length()};
}

}  // namespace talus
