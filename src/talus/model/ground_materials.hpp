#pragma once
// The materials of the ground as the kernel takes them, from the settings of a project.

#include <span>
#include <vector>

#include "talus/ground/material.hpp"
#include "talus/project/project.hpp"

namespace talus::project {

/// The materials of a project, in its order, then one for each of `laid`: a material of the project with the forest
/// that lies over it in place of its own.
[[nodiscard]] std::vector<talus::Material> materials_of(const Project& project, std::span<const LaidForest> laid);

}  // namespace talus::project
