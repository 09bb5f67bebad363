#pragma once
// Makes the plan of a design from [design]: lines by number, with lengths and sections, and factors of the standard.

#include <cstdint>
#include <optional>
#include <vector>

#include "talus/campaign/model.hpp"
#include "talus/project/factor_set.hpp"
#include "talus/project/project.hpp"
#include "talus/results/design_plan.hpp"

namespace talus::project {

/// Expects a checked project with a [design], and its model. Throws BadInput if its set of factors cannot be read.
[[nodiscard]] DesignPlan design_plan(const Project& project, const Model& model);

/// What the design of barriers takes from a project, beside their lines.
struct DesignBasis {
  Design design;
  std::optional<FactorSet> factors;
  std::vector<Kit> kits;
};
/// With the usual [design] if the project has none. Throws as design_plan does.
[[nodiscard]] DesignBasis design_basis(const Project& project);

/// The plan without lines: percentiles, check and kits.
[[nodiscard]] DesignPlan design_check(const DesignBasis& basis);

/// The line of a barrier or collector, cut into sections; `number`: of the barrier.
[[nodiscard]] DesignLine line_along(const talus::Barrier& barrier, std::uint32_t number, double section_m,
                                    bool in_section);

}  // namespace talus::project
