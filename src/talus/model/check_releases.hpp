#pragma once
// Warnings about releases that only the terrain reveals.

#include "talus/campaign/model.hpp"
#include "talus/core/problems.hpp"

namespace talus::project {

/// Adds a warning if a rock of a sample starts more than highest_release_m above the ground.
void warn_of_high_releases(const Model& model, Problems& warnings);

/// Adds a warning for each seeder with rocks of a sample that start in the ground: their number, and their rows of a
/// table. (The summary of a run counts all.)
void warn_of_buried_releases(const Model& model, Problems& warnings);

/// Adds a warning for each seeder with rocks that are larger than the cells of a raster: one in twenty or more of a
/// sample.
void warn_of_rocks_larger_than_cells(const Model& model, Problems& warnings);

}  // namespace talus::project
