#pragma once
// The materials of the ground, from polygons on plan with an attribute.

#include <cstdint>
#include <vector>

#include "talus/core/problems.hpp"
#include "talus/model/build_terrain.hpp"
#include "talus/project/project.hpp"

namespace talus::project {

/// The material number of each cell or facet, by its source number in the terrain's surface: that of the last polygon
/// in the file that contains its centre, or the default if there is none. Overlaps and gaps are reported in `warnings`,
/// with their areas on plan. Throws BadInput if the file is wrong or a value has no material. Expects fewer than 256
/// materials.
[[nodiscard]] std::vector<std::uint8_t> materials_of_polygons(const Project& project, const BuiltTerrain& terrain,
                                                              Problems& warnings);

}  // namespace talus::project
