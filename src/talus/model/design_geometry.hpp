#pragma once
// Distances on plan between the lines of a design.

#include <optional>

#include "talus/campaign/model.hpp"
#include "talus/results/design_plan.hpp"

namespace talus::project {

/// The pieces of a line in 3D, by its panels.
[[nodiscard]] std::vector<LinePiece> pieces_of(const talus::Barrier& barrier);

/// The distance on plan [m] from the part of a line between two stations to another line. Expects panels.
[[nodiscard]] double distance_between(const talus::Barrier& line, double from, double to, const talus::Barrier& other);

/// Two lines that stand side by side across the slope but for a part where one is behind the other, seen along the
/// first one's direction from end to end.
struct Stagger {
  double overlap = 0;   // of the two on plan; negative: a gap [m]
  double distance = 0;  // between them in the middle of the overlap or gap [m]
};
/// nullopt if one line covers the whole other one.
[[nodiscard]] std::optional<Stagger> stagger_of(const talus::Barrier& one, const talus::Barrier& other);

}  // namespace talus::project
