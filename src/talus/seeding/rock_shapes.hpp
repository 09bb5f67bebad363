#pragma once
// The shapes of a seeder's rocks, and how they are turned at release.

#include <optional>
#include <vector>

#include "talus/rocks/shape.hpp"
#include "talus/sampling/distribution.hpp"
#include "talus/sampling/draws.hpp"

namespace talus {

/// The ratios of a block's axes a >= b >= c.
struct AxisRatios {
  Sampler b_over_a, c_over_b;
};

/// Rocks of one kind.
struct RockKind {
  double share = 1;                   // of the rocks of all kinds
  std::vector<RockShape> hulls;       // one is drawn for each rock; none: spheres
  std::optional<AxisRatios> stretch;  // of the hulls, which are balls then: drawn for each rock
};

/// `kinds` is empty if all rocks are spheres. The shares add up to 1.
struct RockShapes {
  std::vector<RockKind> kinds;

  /// The shape of one rock: one of those kept here or, made for this rock, `own`; null for a sphere. `axes`: of the
  /// block, descending, instead of drawn ratios.
  [[nodiscard]] const RockShape* draw(const Draws& draws, const std::optional<Vec3>& axes, RockShape& own) const;
};

enum class InitialTurn {
  any,         // every orientation is equally likely
  in_section,  // about y only, every angle is equally likely
  given
};

/// How rocks with a shape are turned at release.
struct ReleaseTurn {
  InitialTurn kind = InitialTurn::any;
  Orientation given;  // of the shape as it was given

  [[nodiscard]] Orientation draw(const Draws& draws, const RockShape& shape) const;
};

}  // namespace talus
