#pragma once
// The shapes of a project's rocks.

#include <string>

#include "talus/core/problems.hpp"
#include "talus/project/project.hpp"
#include "talus/seeding/rock_shapes.hpp"

namespace talus::project {

/// Of the shape of this name, on a section or not. Reads scans. Throws BadInput for a shape without a volume.
/// `report`: a line about each scan is added.
[[nodiscard]] RockShapes build_shapes(const Project& project, const std::string& name, std::string& report,
                                      Problems& warnings);

/// `shapes`, built for the same shape, with the ratios of axes that the project gives now.
[[nodiscard]] RockShapes with_ratios(const Project& project, const std::string& name, RockShapes shapes);

[[nodiscard]] ReleaseTurn release_turn(const Project& project, const Seeder& seeder);

}  // namespace talus::project
