#pragma once
// Warnings about results that should not be trusted as they are, for runs and for questions to them. When they are
// given, and what they mean: docs/outputs.md.

#include <string>

#include "talus/archive/run_summary.hpp"
#include "talus/core/problems.hpp"
#include "talus/results/design_result.hpp"

namespace talus {

/// More of the way slid or rolled than this share is doubtful.
inline constexpr double doubtful_share_on_ground = 0.5;

/// Warns if most of the way of all rocks was along the ground.
void doubt_ways(const WaysSummary& ways, Problems& warnings);

/// Warns if the height that the check asks for is less than the diameter of the largest rock that crosses. `where`: the
/// line.
void doubt_needed_height(const std::string& where, const DesignFigures& figures, Problems& warnings);
/// Warns of a kit of this height that is lower than that diameter.
void doubt_kit_height(const std::string& where, double height, const DesignFigures& figures, Problems& warnings);

}  // namespace talus
