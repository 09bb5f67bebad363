#pragma once
// A line that is asked after a run: as a collector on the model's terrain, or as a barrier or collector of the run.

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "talus/core/problems.hpp"
#include "talus/model/build_barrier.hpp"

namespace talus {

/// A place on plan, in the user's coordinates; in 2D only x counts.
using PlanPlace = std::array<double, 2>;

struct AskedLine {
  Barrier barrier;                        // a collector, unless it is a barrier of the run
  std::optional<std::uint32_t> of_model;  // number of the model's barrier or collector
};

/// The height of the collector where none is given [m]. It makes no difference: rocks count above it, too.
inline constexpr double asked_height = 10;

/// The collector on a drawn line, `height` [m] high. Throws BadInput with all problems of the line, which `where`
/// names; parts off the terrain are added to `warnings`.
[[nodiscard]] AskedLine drawn_line(const Model& model, std::span<const PlanPlace> line, double height,
                                   std::string_view where, Problems& warnings);
/// The same without a word of parts off the terrain; nullopt if all of it is off.
[[nodiscard]] std::optional<AskedLine> line_on_ground(const Model& model, std::span<const PlanPlace> line,
                                                      double height);
/// The barrier or collector of this name. Throws BadInput if there is none.
[[nodiscard]] AskedLine line_of_barrier(const Model& model, std::string_view name, std::string_view where);

/// The corners of a line's foot; local.
[[nodiscard]] std::vector<Vec3> foot_of(const Barrier& barrier);

/// Adds a problem for each place that is not a number or too large.
void check_places(std::span<const PlanPlace> places, std::string_view where, Problems& problems);
/// Whether a corner lies on the terrain with x and y swapped.
[[nodiscard]] bool is_on_ground_swapped(const Model& model, std::span<const PlanPlace> places);

}  // namespace talus
