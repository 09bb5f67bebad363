#pragma once
// The materials of the ground, from a project.

#include "talus/core/problems.hpp"
#include "talus/ground/material.hpp"
#include "talus/model/build_terrain.hpp"
#include "talus/project/project.hpp"

namespace talus::project {

/// The materials are those of the project, in its order, and then those that lie in a [[forest]]. Errors that only the
/// terrain or a file of the ground reveals are added to `problems`, and the ground must then not be used; doubts are
/// added to `warnings`.
[[nodiscard]] talus::Ground build_ground(const Project& project, const BuiltTerrain& terrain, Problems& problems,
                                         Problems& warnings);

}  // namespace talus::project
