#pragma once
// The terrain of a model on plan, as reference layers need it.

#include <optional>
#include <string>
#include <vector>

#include "talus/campaign/model.hpp"
#include "talus/core/vec.hpp"

namespace talus {

/// A rectangle on plan, in the project's coordinates [m].
struct PlanArea {
  Vec2 low{0, 0}, high{0, 0};

  [[nodiscard]] Vec2 size() const { return high - low; }
  [[nodiscard]] bool is_empty() const { return !(low.x() < high.x() && low.y() < high.y()); }
  [[nodiscard]] PlanArea common(const PlanArea& other) const { return {low.max(other.low), high.min(other.high)}; }
  [[nodiscard]] bool touches(const PlanArea& other) const {
    return low.is_at_most(other.high) && other.low.is_at_most(high);
  }
};

struct TerrainOnPlan {
  PlanArea area;
  std::string crs_wkt;  // empty: unknown
};

/// Expects a model in 3D.
[[nodiscard]] TerrainOnPlan terrain_on_plan(const Model& model);

/// For messages: "x 651000 to 652000, y 5234000 to 5235000".
[[nodiscard]] std::string in_words(const PlanArea& area);

/// Lines on plan laid on the terrain, in the project's coordinates: at their points, and in between every `spacing`
/// metres. A line ends where there is no terrain and another one begins behind it, so that each may become several.
[[nodiscard]] std::vector<std::vector<Vec3>> on_terrain(const Model& model, const std::vector<Vec2>& line,
                                                        double spacing);

/// The distance between points [m] at which `length` metres of lines follow the cells or triangles of the terrain, or a
/// larger one, so that there are at most `most` points.
[[nodiscard]] double spacing_on_terrain(const Model& model, double length, std::size_t most);

}  // namespace talus
