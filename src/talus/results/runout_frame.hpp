#pragma once
// From where and in which direction runout is counted: from the release of each rock, from a point, or along a line.

#include <optional>
#include <vector>

#include "talus/core/vec.hpp"

namespace talus {

/// Where a rock is in a RunoutFrame, on plan [m].
struct RunoutPlace {
  double runout = 0;
  std::optional<double> lateral{};  // only along a line
};

/// On plan, in any coordinates that are the same for all its points [m].
///
/// Along a line, runout is the distance along it from its first point to the point of it that is nearest to the rock;
/// lateral is the distance from that point to the rock, positive to the left of the line's direction. The line goes on
/// straight beyond its ends, so that runout can be negative, or longer than the line.
class RunoutFrame {
 public:
  /// The distance from each rock's release.
  RunoutFrame() = default;
  /// The distance from a point.
  [[nodiscard]] static RunoutFrame from(const Vec2& origin);
  /// Expects two or more points, of which no two in succession are equal.
  [[nodiscard]] static RunoutFrame along(std::vector<Vec2> line);

  [[nodiscard]] RunoutPlace of(const Vec2& release, const Vec2& place) const;
  [[nodiscard]] bool is_from_release() const { return points_.empty(); }
  [[nodiscard]] bool is_along_line() const { return points_.size() > 1; }

 private:
  std::vector<Vec2> points_;       // none: from the release; one: the origin; else the line
  std::vector<double> chainages_;  // of the points of the line
};

}  // namespace talus
