#include "talus/results/design_plan.hpp"

#include <algorithm>
#include <cmath>

namespace talus {

std::uint32_t DesignLine::section_at(double station) const {
  const double along = station - start;
  if (sections == 1 || !(along > 0)) return 0;
  return static_cast<std::uint32_t>(std::min(along / section_length, static_cast<double>(sections - 1)));
}

double DesignLine::section_begin(std::uint32_t section) const {
  return start + (section >= sections ? length : section * section_length);
}

bool DesignLine::is_at_free_end(double station, double free_end) const {
  if (length == 0 || free_end == 0) return false;
  return station < start + free_end || station > start + length - free_end;
}

double DesignLine::lateral_of(double station, const Vec3& velocity) const {
  if (pieces.empty()) return 0;
  const auto after = std::ranges::upper_bound(pieces, station, {}, &LinePiece::station);
  const LinePiece& piece = after == pieces.begin() ? pieces.front() : *(after - 1);
  constexpr double most = 1e6;  // of a rock that moves along the line, or up and down
  const double along = std::abs(velocity.x() * piece.along_x + velocity.y() * piece.along_y);
  const double across = std::abs(velocity.y() * piece.along_x - velocity.x() * piece.along_y);
  return along < most * across ? along / across : most;
}

std::optional<double> DesignLine::least_clearance() const {
  if (clearances.empty()) return std::nullopt;
  return std::ranges::min(clearances);
}

double CostIndex::of(double length, double height, double maximum_energy) const {
  const double metres = length > 0 ? length : 1;
  return metres * std::pow(height, height_exponent) * std::pow(maximum_energy / 1000, energy_exponent);
}

}  // namespace talus
