#pragma once
// Makes the plan of a design from [design]: lines by number, with lengths and sections, and factors of the standard.

#include "talus/campaign/model.hpp"
#include "talus/project/project.hpp"
#include "talus/results/design_plan.hpp"

namespace talus::project {

/// Expects the [design] of a checked project, and its model.
[[nodiscard]] DesignPlan design_plan(const Design& design, const Model& model);

/// The factors of the standard's check with these settings.
[[nodiscard]] CheckFactors check_factors(const Design& design);

}  // namespace talus::project
