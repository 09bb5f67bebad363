#include "talus/model/build_barrier.hpp"

#include <variant>

namespace talus::project {

bool has_ground_at(const Model& model, const Vec2& at) {
  return std::visit([&](const auto& surface) { return surface.elevation(at.x(), at.y()).has_value(); }, *model.surface);
}

BarrierFoot foot_of(const Model& model, std::span<const std::array<double, 2>> line) {
  BarrierFoot foot;
  if (const auto* profile = std::get_if<Profile>(&*model.surface)) {
    foot.in_section = true;
    const double x = line.front()[0] - model.frame.origin.x();
    if (const auto z = profile->elevation(x)) foot.points = {Vec3(x, 0, *z)};
    return foot;
  }
  const Vec2 origin(model.frame.origin.x(), model.frame.origin.y());
  const auto drape = [&](const Vec2& from, const Vec2& to) {
    if (const auto* raster = std::get_if<RasterSurface>(&*model.surface)) return raster->draped(from, to);
    return std::get<TriangleMesh>(*model.surface).draped(from, to);
  };
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    const Vec2 from = Vec2(line[k][0], line[k][1]) - origin;
    const Vec2 to = Vec2(line[k + 1][0], line[k + 1][1]) - origin;
    const std::vector<Vec3> draped = drape(from, to);
    for (std::size_t i = 0; i < draped.size(); ++i) {
      const Vec3& p = draped[i];
      // There is a point wherever the ground bends, so between two points there is either ground throughout or none.
      if (i > 0) {
        const Vec2 piece = (p - draped[i - 1]).xy();
        if (has_ground_at(model, draped[i - 1].xy() + 0.5 * piece)) foot.on_ground += piece.norm();
      }
      if (!foot.points.empty() && (p - foot.points.back()).squared_norm() < 1e-12) continue;
      foot.points.push_back(p);
      foot.stations.push_back(foot.given + (p.xy() - from).norm());
    }
    foot.given += (to - from).norm();
  }
  return foot;
}

std::vector<Panel> panels_along(const BarrierFoot& foot, double height, double inclination) {
  if (foot.in_section) {
    if (foot.points.empty()) return {};
    return {panel_in_section(foot.points.front(), height, inclination)};
  }
  std::vector<Panel> panels = panels_over(foot.points, height, inclination);
  for (std::size_t k = 0; k < panels.size() && k + 1 < foot.stations.size(); ++k) {
    panels[k].station = foot.stations[k];
    panels[k].plan_length = foot.stations[k + 1] - foot.stations[k];
  }
  return panels;
}

}  // namespace talus::project
