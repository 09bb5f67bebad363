#pragma once
// What is doubtful about where rocks start, and shows on the terrain only.

#include "talus/campaign/model.hpp"
#include "talus/core/problems.hpp"

namespace talus::project {

/// Adds a warning where a rock starts higher than that. Looks at a sample of rocks.
void warn_of_high_releases(const Model& model, Problems& warnings);

/// Adds how many of a sample of rocks were to start in the ground. (After a run, its summary counts all of them.)
void warn_of_buried_releases(const Model& model, Problems& warnings);

}  // namespace talus::project
