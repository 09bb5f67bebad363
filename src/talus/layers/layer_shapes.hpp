#pragma once
// A vector file as lines, outlines and points over the terrain.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "talus/core/problems.hpp"
#include "talus/import/vector_file.hpp"
#include "talus/layers/terrain_on_plan.hpp"

namespace talus {

struct LayerShape {
  ShapeKind kind = ShapeKind::line;
  std::uint32_t name = 0;    // index into LayerShapes::names
  std::vector<Vec2> points;  // in the project's coordinates; an outline or the border of a hole ends where it begins

  /// To the line, on plan; infinite for a point.
  [[nodiscard]] double distance_to(const Vec2& place) const;
};

struct LayerShapes {
  std::vector<std::string> names;  // each once; the first is empty: of shapes without one
  std::vector<LayerShape> shapes;

  [[nodiscard]] std::size_t points() const;
  /// The shape that is nearest to a place on plan, if one is at most `reach` metres away. Points are not searched.
  [[nodiscard]] const LayerShape* nearest(const Vec2& place, double reach) const;
};

/// What is drawn of a vector file.
struct LayerRequest {
  std::string layer;           // as VectorRequest::layer
  std::string name_attribute;  // empty: `name`, if there is one
  std::size_t most_points = 200'000;
};

/// The shapes of a vector file that touch the terrain's rectangle, with the coordinate systems of read_vector_file.
/// Shapes with more points in all than the request allows are simplified (Douglas and Peucker 1973), by at most a
/// five-hundredth of the terrain's size; if that is not enough, the first ones are kept. Both are reported in
/// `warnings`.
///
/// Throws BadInput as read_vector_file does, and if no shape touches the terrain.
[[nodiscard]] LayerShapes shapes_of_layer(const std::filesystem::path& file, const LayerRequest& request,
                                          const TerrainOnPlan& terrain, Problems& warnings);

/// A line with at most `most` points (at least 2), simplified as little as that takes.
[[nodiscard]] std::vector<Vec2> simplified_to(std::vector<Vec2> line, std::size_t most);

}  // namespace talus
