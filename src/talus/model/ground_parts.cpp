#include "talus/model/ground_parts.hpp"

#include <fmt/format.h>

#include <string_view>
#include <vector>

namespace talus::project {

PlanPolygon plan_polygon(std::span<const std::array<double, 2>> corners) {
  std::vector<Vec3> ring;
  for (const auto& [x, y] : corners) ring.emplace_back(x, y, 0);
  return PlanPolygon({&ring, 1});
}

Problem about_no_effect(Problem about, const GroundParts& parts, const Vec2& low, const Vec2& high) {
  about.severity = Severity::warning;
  about.what = "has no effect";
  const BuiltTerrain& terrain = parts.terrain();
  const Box box = std::visit([](const auto& surface) { return surface.bounds(); }, *terrain.surface);
  const Vec2 south_west = terrain.frame.global_from_local(box.low).xy();
  const Vec2 north_east = terrain.frame.global_from_local(box.high).xy();
  if (!low.is_at_most(north_east) || !south_west.is_at_most(high)) {
    about.why = fmt::format(
        "its polygon lies outside the terrain, which extends over x = {:.10g} to {:.10g}, y = {:.10g} to {:.10g}",
        south_west.x(), north_east.x(), south_west.y(), north_east.y());
    return about;
  }
  const std::string_view several = parts.name(), one = several.substr(0, several.size() - 1);
  about.why = fmt::format("its polygon contains the centre of no {} of the terrain", one);
  about.hint = fmt::format("A {} counts by its centre: draw the polygon around that", one);
  return about;
}

}  // namespace talus::project
