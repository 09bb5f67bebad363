#pragma once
// The ground along a line on plan, as drawn in a section: a point at each bend, two at each step, none over holes.

#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "talus/core/vec.hpp"

namespace talus {

struct SectionPoint {
  double distance = 0;      // along the line, on plan [m]
  Vec2 place;               // on plan
  std::optional<double> z;  // the highest ground there; nullopt: no ground from here to the next point
};

/// Along a line through two or more points on plan. Has at most `most` points: if the ground bends more often, they are
/// evenly spaced, in addition to the points of the line.
template <class Surface>
[[nodiscard]] std::vector<SectionPoint> section_along(const Surface& surface, std::span<const Vec2> line,
                                                      std::size_t most) {
  // The elevations at the ends of a straight piece are taken this far inside it, as a share of its length: the ground
  // may step at its ends.
  constexpr double inside = 1e-6;
  constexpr double same_height = 1e-6;  // [m]
  std::vector<SectionPoint> section;
  const auto put = [&](double distance, const Vec2& place, std::optional<double> z) {
    if (!section.empty()) {
      const SectionPoint& last = section.back();
      const bool repeats = last.distance == distance && last.z.has_value() == z.has_value() &&
                           (!z || std::abs(*last.z - *z) < same_height);
      if (repeats || (!z && !last.z)) return;
    }
    section.push_back({distance, place, z});
  };
  const auto elevation = [&](const Vec2& p) { return surface.elevation(p.x(), p.y()); };

  double way = 0;
  for (std::size_t k = 0; k + 1 < line.size() && section.size() <= most; ++k) {
    const Vec2 from = line[k], d = line[k + 1] - from;
    const double length = d.norm();
    if (length == 0) continue;
    std::vector<double> bends{0};
    for (const Vec3& p : surface.draped(from, line[k + 1])) {
      const double s = (p.xy() - from).dot(d) / (length * length);
      if (s > bends.back() && s < 1) bends.push_back(s);
    }
    bends.push_back(1);
    for (std::size_t i = 0; i + 1 < bends.size() && section.size() <= most; ++i) {
      const double begin = bends[i], end = bends[i + 1], span = end - begin;
      const auto z0 = elevation(from + (begin + inside * span) * d), z1 = elevation(from + (end - inside * span) * d);
      const bool is_ground = z0 && z1 && elevation(from + (begin + 0.5 * span) * d);
      // To the ends, along the straight.
      const double rise = is_ground ? (*z1 - *z0) * inside / (1 - 2 * inside) : 0;
      put(way + begin * length, from + begin * d, is_ground ? std::optional(*z0 - rise) : std::nullopt);
      if (is_ground) put(way + end * length, from + end * d, *z1 + rise);
    }
    way += length;
  }
  if (section.size() <= most) return section;

  double whole = 0;
  for (std::size_t k = 0; k + 1 < line.size(); ++k) whole += (line[k + 1] - line[k]).norm();
  const double step = whole / static_cast<double>(most > 2 * line.size() ? most - line.size() : 1);
  section.clear();
  way = 0;
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    const Vec2 from = line[k], d = line[k + 1] - from;
    const double length = d.norm();
    const auto steps = static_cast<std::size_t>(std::floor(length / step)) + (length > 0 ? 1 : 0);
    for (std::size_t i = 0; i < steps; ++i) {
      const double s = static_cast<double>(i) / static_cast<double>(steps);
      section.push_back({way + s * length, from + s * d, elevation(from + s * d)});
    }
    way += length;
  }
  section.push_back({way, line.back(), elevation(line.back())});
  return section;
}

}  // namespace talus
