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

double CostIndex::of(double length, double height, double maximum_energy) const {
  const double metres = length > 0 ? length : 1;
  return metres * std::pow(height, height_exponent) * std::pow(maximum_energy / 1000, energy_exponent);
}

}  // namespace talus
