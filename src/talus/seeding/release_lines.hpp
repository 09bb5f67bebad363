#pragma once
// Lines along which rocks start with equal chance per metre, all lines together.

#include <span>
#include <vector>

#include "talus/core/id.hpp"
#include "talus/core/vec.hpp"

namespace talus {

class ReleaseLines {
 public:
  ReleaseLines() = default;
  /// One line, whose rocks have the seeder's source.
  explicit ReleaseLines(std::span<const Vec3> points, SourceId source = {}) { add(points, source); }

  /// Another line, through two or more points (local coordinates), whose rocks are of this source.
  void add(std::span<const Vec3> points, SourceId source);

  struct Place {
    Vec3 point;
    SourceId source;
  };
  /// What belongs to the uniform number u. Expects a line.
  [[nodiscard]] Place at(double u) const;
  [[nodiscard]] double length() const { return way_.empty() ? 0 : way_.back(); }  // of all lines [m]
  [[nodiscard]] std::size_t bytes() const { return points_.size() * (sizeof(Vec3) + sizeof(double)); }

 private:
  struct Line {
    std::size_t first;  // of its points
    SourceId source;
  };
  std::vector<Vec3> points_;
  std::vector<double> way_;  // from the first point of all to each, along the lines and not between them [m]
  std::vector<Line> lines_;
};

}  // namespace talus
