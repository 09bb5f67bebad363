#pragma once
// The seeders of a project, on its terrain.

#include "talus/campaign/model.hpp"
#include "talus/core/problems.hpp"
#include "talus/project/project.hpp"

namespace talus::project {

/// Adds the seeders and their sources to a model that has its surface, frame and coordinate system. Errors that only
/// the terrain or a file reveals are added to `problems`, doubts to `warnings`.
void add_seeders(const Project& project, Model& model, Problems& problems, Problems& warnings);

/// Sets what a seeder of a model takes from numbers of the project alone.
void set_sizes_and_velocities(const Seeder& given, talus::Seeder& seeder);

}  // namespace talus::project
