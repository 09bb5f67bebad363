#pragma once
// Lines along which rocks are released, with equal probability per metre.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "talus/core/id.hpp"
#include "talus/core/vec.hpp"

namespace talus {

class ReleaseLines {
 public:
  ReleaseLines() = default;
  /// One line, whose rocks have this source.
  explicit ReleaseLines(std::span<const Vec3> points, SourceId source = {}) { add(points, source); }

  /// Another line, through two or more points (local coordinates), whose rocks have this source.
  void add(std::span<const Vec3> points, SourceId source);

  struct Place {
    Vec3 point;
    SourceId source;
  };
  /// The place for the uniform number u on all lines. Expects at least one line.
  [[nodiscard]] Place at(double u) const;
  /// The place on one line.
  [[nodiscard]] Place at(std::size_t line, double u) const;
  /// All lines, one after the other, are divided into equal parts, one for each turn of releases. The line of a part is
  /// that at its share v: parts that contain several lines choose among them by length, and the line of a part is known
  /// before any rock is. Increases with the part.
  [[nodiscard]] std::size_t line_of(std::uint64_t part, std::uint64_t parts, double v) const;
  /// The place for the uniform number u on the stretch of its line that is in the part.
  [[nodiscard]] Place in_part(std::uint64_t part, std::uint64_t parts, double v, double u) const;
  [[nodiscard]] std::size_t count() const { return lines_.size(); }
  [[nodiscard]] SourceId source_of(std::size_t line) const { return lines_[line].source; }
  [[nodiscard]] std::span<const Vec3> points_of(std::size_t line) const {
    const std::size_t last = line + 1 < lines_.size() ? lines_[line + 1].first : points_.size();
    return std::span<const Vec3>(points_).subspan(lines_[line].first, last - lines_[line].first);
  }
  [[nodiscard]] double length() const { return way_.empty() ? 0 : way_.back(); }  // of all lines [m]
  [[nodiscard]] std::size_t bytes() const { return points_.size() * (sizeof(Vec3) + sizeof(double)); }

 private:
  /// Where it begins and ends along all lines [m].
  [[nodiscard]] std::array<double, 2> stretch_of(std::size_t line) const;

  struct Line {
    std::size_t first;  // of its points
    SourceId source;
  };
  std::vector<Vec3> points_;
  std::vector<double> way_;  // the length of the lines up to each point, gaps between lines not included [m]
  std::vector<Line> lines_;
};

}  // namespace talus
