#pragma once
// What the effects of a study do not tell, and how many runs or rocks would.

#include "talus/core/problems.hpp"
#include "talus/sensitivity/analysis.hpp"

namespace talus::sensitivity {

/// Warnings: results that are undefined or never vary, inputs that no result depends on, wide intervals, and too few
/// rocks.
[[nodiscard]] Problems doubts_about(const Study& study, const Analysis& analysis);

}  // namespace talus::sensitivity
