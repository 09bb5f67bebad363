#pragma once
// Areas of the ground with their own material: the [[area]] of a project.

#include <cstdint>
#include <vector>

#include "talus/core/problems.hpp"
#include "talus/model/ground_parts.hpp"
#include "talus/project/project.hpp"

namespace talus::project {

/// Assigns to each cell or facet whose centre is in an area the material of that area, the last one if there are
/// several. `of_part` holds the material numbers, by the source numbers of cells or facets in the terrain's surface.
/// Warns of areas that contain no centre. Expects fewer than 256 materials.
void paint_areas(const Project& project, const GroundParts& parts, std::vector<std::uint8_t>& of_part,
                 Problems& warnings);

}  // namespace talus::project
