#include "talus/model/ground_areas.hpp"

#include <fmt/format.h>

namespace talus::project {

void paint_areas(const Project& project, const GroundParts& parts, std::vector<std::uint8_t>& of_part,
                 Problems& warnings) {
  for (const Area& area : project.areas) {
    const PlanPolygon polygon = plan_polygon(area.polygon);
    const auto material = static_cast<std::uint8_t>(*project.number_of_material(area.material));
    bool has_effect = false;
    parts.visit_within(polygon, [&](std::size_t part) {
      of_part[part] = material;
      has_effect = has_effect || parts.is_ground(part);
    });
    if (has_effect) continue;
    warnings.add(about_no_effect(
        {.file = project.file.string(), .line = area.line, .where = fmt::format("area \"{}\"", area.name)}, parts,
        polygon.low(), polygon.high()));
  }
}

}  // namespace talus::project
