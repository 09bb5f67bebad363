#pragma once
// The parts of a terrain, each with its own material, and their selection by polygons on plan.

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "talus/core/problems.hpp"
#include "talus/meshing/plan_polygon.hpp"
#include "talus/meshing/point_buckets.hpp"
#include "talus/model/build_terrain.hpp"

namespace talus::project {

/// A part has one byte for its material; the last number means none.
inline constexpr std::size_t max_materials_of_parts = 255;

/// The centres of the terrain's cells or facets, in the user's coordinates, and their areas on plan. Keeps a reference
/// to `terrain`, which must have facet centres.
class GroundParts {
 public:
  explicit GroundParts(const BuiltTerrain& terrain) : terrain_(terrain) {
    if (const auto* raster = std::get_if<RasterSurface>(&*terrain.surface)) {
      raster_ = raster;
      const RasterGrid& grid = raster->grid();
      const Vec2 first(grid.x0 + 0.5 * grid.dx, grid.y0 + 0.5 * grid.dy);
      grid_ = {first + Vec2(terrain.frame.origin.xy()), grid.dx, grid.dy, grid.columns - 1, grid.rows - 1};
    } else {
      buckets_.emplace(terrain.facet_centres);
    }
  }

  [[nodiscard]] const BuiltTerrain& terrain() const { return terrain_; }
  [[nodiscard]] std::size_t count() const { return raster_ ? raster_->cell_count() : terrain_.facet_centres.size(); }
  [[nodiscard]] const char* name() const { return raster_ ? "cells" : "triangles"; }
  /// The area on plan [m2]; for facets, only if the terrain has facet areas.
  [[nodiscard]] double area(std::size_t part) const {
    return raster_ ? grid_.dx * grid_.dy : terrain_.facet_areas[part];
  }
  /// False for holes of a raster.
  [[nodiscard]] bool is_ground(std::size_t part) const {
    return !raster_ || raster_->has_data(part % grid_.columns, part / grid_.columns);
  }
  [[nodiscard]] Vec2 centre(std::size_t part) const {
    if (!raster_) return terrain_.facet_centres[part];
    return {grid_.x(static_cast<std::uint32_t>(part % grid_.columns)),
            grid_.y(static_cast<std::uint32_t>(part / grid_.columns))};
  }

  /// Calls visit(part) for each part whose centre is within the polygon.
  template <class Visit>
  void visit_within(const PlanPolygon& polygon, Visit&& visit) const {
    if (raster_) {
      visit_points_within(polygon, grid_, [&](std::uint32_t row, std::uint32_t from, std::uint32_t to) {
        for (std::uint32_t column = from; column < to; ++column) {
          visit(static_cast<std::size_t>(row) * grid_.columns + column);
        }
      });
    } else {
      buckets_->visit_near(polygon.low(), polygon.high(), [&](std::uint32_t part) {
        if (polygon.contains(terrain_.facet_centres[part])) visit(std::size_t{part});
      });
    }
  }

 private:
  const BuiltTerrain& terrain_;
  const RasterSurface* raster_ = nullptr;
  PlanGrid grid_;
  std::optional<PointBuckets> buckets_;
};

/// A polygon of a project, in the user's coordinates.
[[nodiscard]] PlanPolygon plan_polygon(std::span<const std::array<double, 2>> corners);

/// A warning that polygons within this rectangle contain the centre of no part, and why, in the place that `about`
/// names.
[[nodiscard]] Problem about_no_effect(Problem about, const GroundParts& parts, const Vec2& low, const Vec2& high);

}  // namespace talus::project
