#pragma once
// The contour of the terrain through a place: a line at one elevation.

#include <optional>
#include <vector>

#include "talus/layers/terrain_on_plan.hpp"

namespace talus {

struct ContourLine {
  double elevation = 0;      // [m], in the project's coordinates, as the points
  std::vector<Vec2> points;  // from border to border, or ends where it begins
};

/// The line along which the triangles of the terrain have the elevation of its surface at `place`, or `elevation` if it
/// is given; of several the one nearest to the place. It is exact on every triangle; with more than `most` points it is
/// simplified. nullopt if there is no terrain at the place, or nowhere this elevation. Expects a model in 3D.
[[nodiscard]] std::optional<ContourLine> contour_through(const Model& model, const Vec2& place,
                                                         std::optional<double> elevation, std::size_t most);

}  // namespace talus
