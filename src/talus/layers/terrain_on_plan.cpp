#include "talus/layers/terrain_on_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace talus {

TerrainOnPlan terrain_on_plan(const Model& model) {
  const Box box = std::visit([](const auto& surface) { return surface.bounds(); }, *model.surface);
  const Vec2 origin = model.frame.origin.xy();
  return {{box.low.xy() + origin, box.high.xy() + origin}, model.crs_wkt};
}

std::string in_words(const PlanArea& area) {
  return fmt::format("x {:.10g} to {:.10g}, y {:.10g} to {:.10g}", area.low.x(), area.high.x(), area.low.y(),
                     area.high.y());
}

std::vector<std::vector<Vec3>> on_terrain(const Model& model, const std::vector<Vec2>& line, double spacing) {
  std::vector<std::vector<Vec3>> parts;
  bool is_on_ground = false;
  const auto add = [&](const Vec2& place) {
    const Vec2 local = place - model.frame.origin.xy();
    const auto z =
        std::visit([&](const auto& surface) { return surface.elevation(local.x(), local.y()); }, *model.surface);
    if (z && !is_on_ground) parts.emplace_back();
    is_on_ground = z.has_value();
    if (z) parts.back().emplace_back(place.x(), place.y(), *z + model.frame.origin.z());
  };
  for (std::size_t k = 0; k < line.size(); ++k) {
    if (k > 0) {
      const Vec2 way = line[k] - line[k - 1];
      const auto steps = static_cast<std::size_t>(std::ceil(std::max(1.0, way.norm() / spacing)));
      for (std::size_t i = 1; i < steps; ++i)
        add(line[k - 1] + way * (static_cast<double>(i) / static_cast<double>(steps)));
    }
    add(line[k]);
  }
  return parts;
}

double spacing_on_terrain(const Model& model, double length, std::size_t most) {
  double cell = 0;
  if (const auto* raster = std::get_if<RasterSurface>(&*model.surface)) {
    cell = std::min(raster->grid().dx, raster->grid().dy);
  } else {
    const Vec2 size = terrain_on_plan(model).area.size();
    const auto facets = std::visit([](const auto& surface) { return surface.facet_count(); }, *model.surface);
    cell = std::sqrt(size.x() * size.y() / static_cast<double>(std::max<std::size_t>(1, facets)));
  }
  return std::max({cell, length / static_cast<double>(most), 1e-3});
}

}  // namespace talus
