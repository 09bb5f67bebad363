#pragma once
// Parts of the ground that are painted with a material of their own: the [[area]] of a project.

#include <cstdint>
#include <vector>

#include "talus/core/problems.hpp"
#include "talus/model/build_terrain.hpp"
#include "talus/project/project.hpp"

namespace talus::project {

/// Gives each cell or facet whose middle an area holds the material of that area, of several that of the last.
/// `of_part` are the numbers of the materials, as the terrain's surface numbers the sources of its cells or facets. An
/// area that holds no middle is warned of. Expects fewer than 256 materials.
void paint_areas(const Project& project, const BuiltTerrain& terrain, std::vector<std::uint8_t>& of_part,
                 Problems& warnings);

}  // namespace talus::project
