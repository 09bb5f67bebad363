#include "talus/model/ground_areas.hpp"

#include <fmt/format.h>

#include "talus/model/ground_parts.hpp"

namespace talus::project {

namespace {

Problem without_effect(const Project& project, const Area& area, const BuiltTerrain& terrain, const GroundParts& parts,
                       const PlanPolygon& polygon) {
  Problem problem{.severity = Severity::warning,
                  .file = project.file.string(),
                  .line = area.line,
                  .where = fmt::format("area \"{}\"", area.name),
                  .what = "has no effect"};
  const Box box = std::visit([](const auto& surface) { return surface.bounds(); }, *terrain.surface);
  const Vec3 low = terrain.frame.global_from_local(box.low), high = terrain.frame.global_from_local(box.high);
  const bool is_beyond = !polygon.low().is_at_most(high.xy()) || !low.xy().is_at_most(polygon.high());
  if (is_beyond) {
    problem.why = fmt::format(
        "its polygon lies outside the terrain, which extends over x = {:.10g} to {:.10g}, y = {:.10g} "
        "to {:.10g}",
        low.x(), high.x(), low.y(), high.y());
    return problem;
  }
  const std::string_view several = parts.name(), one = several.substr(0, several.size() - 1);
  problem.why = fmt::format("its polygon contains the centre of no {} of the terrain", one);
  problem.hint = fmt::format("A {} has the material at its centre: draw the polygon around that", one);
  return problem;
}

}  // namespace

void paint_areas(const Project& project, const BuiltTerrain& terrain, std::vector<std::uint8_t>& of_part,
                 Problems& warnings) {
  const GroundParts parts(terrain);
  for (const Area& area : project.areas) {
    std::vector<Vec3> ring;
    for (const auto& [x, y] : area.polygon) ring.emplace_back(x, y, 0);
    const PlanPolygon polygon({&ring, 1});
    const auto material = static_cast<std::uint8_t>(*project.number_of_material(area.material));
    bool has_effect = false;
    parts.visit_within(polygon, [&](std::size_t part) {
      of_part[part] = material;
      has_effect = has_effect || parts.is_ground(part);
    });
    if (!has_effect) warnings.add(without_effect(project, area, terrain, parts, polygon));
  }
}

}  // namespace talus::project
