#pragma once
// Forests over the ground: the [[forest]] of a project.

#include <cstdint>
#include <vector>

#include "talus/core/problems.hpp"
#include "talus/ground/material.hpp"
#include "talus/model/ground_parts.hpp"
#include "talus/project/project.hpp"

namespace talus::project {

/// Lays the forests over the ground. `of_part` holds the material numbers, as in paint_areas(); those of cells or
/// facets whose centre is in a forest, the last one if there are several, become numbers from that of materials on. The
/// first of these is that of the first entry of the list returned, and so on. Warns of forests that contain no centre
/// and of values that no polygon has. Throws BadInput if a file is wrong, or if there would be more than 255 materials.
[[nodiscard]] std::vector<LaidForest> lay_forests(const Project& project, const GroundParts& parts,
                                                  std::vector<std::uint8_t>& of_part, Problems& warnings);

}  // namespace talus::project
