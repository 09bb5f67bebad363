#pragma once
// Stretches of a barrier's foot, and places along it, on plan.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace talus::io {

/// The part of a line in space between two distances along it, on plan [m]; two points at the least, unless the line
/// has fewer.
[[nodiscard]] inline std::vector<std::array<double, 3>> stretch_of(const std::vector<std::array<double, 3>>& line,
                                                                   double from, double to) {
  if (line.size() < 2) return line;
  const auto between = [](const std::array<double, 3>& a, const std::array<double, 3>& b, double part) {
    std::array<double, 3> p;
    for (std::size_t k = 0; k < p.size(); ++k) p[k] = a[k] + part * (b[k] - a[k]);
    return p;
  };
  std::vector<std::array<double, 3>> stretch;
  double station = 0;
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    const auto& a = line[k];
    const auto& b = line[k + 1];
    const double length = std::hypot(b[0] - a[0], b[1] - a[1]), end = station + length;
    if (length > 0 && end > from && station < to) {
      if (stretch.empty()) stretch.push_back(between(a, b, std::max(0.0, (from - station) / length)));
      stretch.push_back(end <= to ? b : between(a, b, (to - station) / length));
    }
    station = end;
  }
  return stretch.empty() ? std::vector{line[line.size() - 2], line.back()} : stretch;
}

/// How far along the line its point lies that is nearest to a place, on plan [m].
[[nodiscard]] inline double station_of(const std::vector<std::array<double, 3>>& line, double x, double y) {
  double station = 0, nearest = std::numeric_limits<double>::infinity(), begin = 0;
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    const double dx = line[k + 1][0] - line[k][0], dy = line[k + 1][1] - line[k][1];
    const double length = std::hypot(dx, dy);
    if (length == 0) continue;
    const double px = x - line[k][0], py = y - line[k][1];
    const double along = std::clamp((px * dx + py * dy) / length, 0.0, length);
    const double distance = std::hypot(px - along * dx / length, py - along * dy / length);
    if (distance < nearest) {
      nearest = distance;
      station = begin + along;
    }
    begin += length;
  }
  return station;
}

}  // namespace talus::io
