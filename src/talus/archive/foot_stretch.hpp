#pragma once
// Parts of a barrier's foot, and stations along it on plan.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace talus {

using FootLine = std::vector<std::array<double, 3>>;

/// The station of each point of a line: its distance from the first along the line on plan [m].
[[nodiscard]] inline std::vector<double> stations_along(const FootLine& line) {
  std::vector<double> stations;
  for (std::size_t k = 0; k < line.size(); ++k) {
    stations.push_back(k == 0 ? 0
                              : stations.back() + std::hypot(line[k][0] - line[k - 1][0], line[k][1] - line[k - 1][1]));
  }
  return stations;
}

/// The part of a line in space between two stations [m], given the stations of its points. It has at least two points,
/// unless the line has fewer.
[[nodiscard]] inline FootLine stretch_of(const FootLine& line, const std::vector<double>& stations, double from,
                                         double to) {
  if (line.size() < 2) return line;
  const auto between = [](const std::array<double, 3>& a, const std::array<double, 3>& b, double part) {
    std::array<double, 3> p;
    for (std::size_t k = 0; k < p.size(); ++k) p[k] = a[k] + part * (b[k] - a[k]);
    return p;
  };
  FootLine stretch;
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    const auto& a = line[k];
    const auto& b = line[k + 1];
    const double station = stations[k], end = stations[k + 1], length = end - station;
    if (!(length > 0 && end > from && station < to)) continue;
    if (stretch.empty()) stretch.push_back(between(a, b, std::max(0.0, (from - station) / length)));
    stretch.push_back(end <= to ? b : between(a, b, (to - station) / length));
  }
  return stretch.empty() ? FootLine{line[line.size() - 2], line.back()} : stretch;
}

/// The station of the point of the line nearest to a place [m], given the stations of its points.
[[nodiscard]] inline double station_of(const FootLine& line, const std::vector<double>& stations, double x, double y) {
  double station = stations.empty() ? 0 : stations.front(), nearest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    const double dx = line[k + 1][0] - line[k][0], dy = line[k + 1][1] - line[k][1];
    const double length = std::hypot(dx, dy);
    if (length == 0) continue;
    const double px = x - line[k][0], py = y - line[k][1];
    const double along = std::clamp((px * dx + py * dy) / length, 0.0, length);
    const double distance = std::hypot(px - along * dx / length, py - along * dy / length);
    if (distance < nearest) {
      nearest = distance;
      station = stations[k] + along / length * (stations[k + 1] - stations[k]);
    }
  }
  return station;
}

}  // namespace talus
