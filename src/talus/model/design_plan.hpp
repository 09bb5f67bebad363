#pragma once
// From [design] to the plan of a design: lines by their numbers, lengths and sections, factors of the standard.

#include "talus/campaign/model.hpp"
#include "talus/project/project.hpp"
#include "talus/results/design_plan.hpp"

namespace talus::project {

/// Expects a project that was checked, and its model.
[[nodiscard]] DesignPlan design_plan(const Design& design, const Model& model);

/// The factors that the standard's check has with these settings.
[[nodiscard]] CheckFactors check_factors(const Design& design);

}  // namespace talus::project
