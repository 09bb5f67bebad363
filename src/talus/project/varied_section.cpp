#include "talus/project/varied_section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace talus::project {

CertainStretch certain_stretch(const SectionTerrain& section) {
  // Each vertex may lie within [x - moved, x + moved]. Wherever they are, one is left of the smallest right end of
  // these ranges and one is right of the largest left end; the slope connects them.
  CertainStretch stretch{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (std::size_t k = 0; k < section.vertices.size(); ++k) {
    const double x = section.vertices[k][0];
    const double moved = section.std_dev_m.empty() ? 0 : most_deviations_of_vertex * section.std_dev_m[k][0];
    stretch.from = std::min(stretch.from, x + moved);
    stretch.to = std::max(stretch.to, x - moved);
  }
  return stretch;
}

std::string why_uncertain(const CertainStretch& stretch) {
  return fmt::format(
      "if section_std_dev_m moves its ends by {:g} standard deviations, the section extends from x = {:.10g} to "
      "{:.10g}",
      most_deviations_of_vertex, stretch.from, stretch.to);
}

}  // namespace talus::project
