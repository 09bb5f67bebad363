#pragma once
// Which part of the terrain is made of which material.

#include <vector>

#include "talus/core/problems.hpp"
#include "talus/ground/material.hpp"
#include "talus/model/build_terrain.hpp"
#include "talus/project/project.hpp"

namespace talus::project {

/// `materials` are those of the project, in its order. What only the terrain or a file of the ground shows to be wrong
/// is added to `problems`, and the ground is then not to be used; doubts are added to `warnings`.
[[nodiscard]] talus::Ground build_ground(const Project& project, std::vector<talus::Material> materials,
                                         const BuiltTerrain& terrain, Problems& problems, Problems& warnings);

}  // namespace talus::project
