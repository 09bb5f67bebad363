#pragma once
// Makes the plan of a design from [design]: lines by number, with lengths and sections, and factors of the standard.

#include "talus/campaign/model.hpp"
#include "talus/project/project.hpp"
#include "talus/results/design_plan.hpp"

namespace talus::project {

/// Expects a checked project with a [design], and its model. Throws BadInput if its set of factors cannot be read.
[[nodiscard]] DesignPlan design_plan(const Project& project, const Model& model);

}  // namespace talus::project
