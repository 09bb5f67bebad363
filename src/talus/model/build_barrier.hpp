#pragma once
// Barriers, collectors and lines that are asked after a run: a line on plan, draped over a model's terrain, with panels
// on it.

#include <array>
#include <span>
#include <vector>

#include "talus/campaign/model.hpp"

namespace talus::project {

/// A line on plan, projected onto the ground; local coordinates. In 2D it is a point of the section.
struct BarrierFoot {
  bool in_section = false;
  std::vector<Vec3> points;         // empty: the line does not touch the terrain
  std::vector<double> stations;     // of each point along the given line, on plan [m]; empty in 2D
  double given = 0, on_ground = 0;  // lengths of the line and of its part over ground, on plan [m]; 0 in 2D
};

/// A shorter line has no direction [m].
inline constexpr double shortest_line = 1e-5;

/// `line`: on plan, in the user's coordinates; in 2D the x of its first point counts.
[[nodiscard]] BarrierFoot foot_of(const Model& model, std::span<const std::array<double, 2>> line);

/// Whether there is ground at a place on plan; local coordinates.
[[nodiscard]] bool has_ground_at(const Model& model, const Vec2& at);

/// Panels over a foot, with stations along the given line (including parts off the terrain).
[[nodiscard]] std::vector<Panel> panels_along(const BarrierFoot& foot, double height, double inclination);

}  // namespace talus::project
