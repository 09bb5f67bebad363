#pragma once
// From a project to a model: terrain read, cleaned and moved to its local frame, everything placed on it.

#include "talus/campaign/model.hpp"
#include "talus/core/problems.hpp"
#include "talus/project/project.hpp"

namespace talus::project {

/// Builds the model of a checked project. Throws BadInput with all problems that only the terrain shows (a seeder off
/// it, a barrier that does not stand on it, wrong numbers of materials); doubts are added to `warnings`.
[[nodiscard]] Model build_model(const Project& project, Problems& warnings);

}  // namespace talus::project
