#pragma once
// Which part of the terrain is made of which material, from polygons on plan with an attribute.

#include <cstdint>
#include <vector>

#include "talus/core/problems.hpp"
#include "talus/model/build_terrain.hpp"
#include "talus/project/project.hpp"

namespace talus::project {

/// The number of the material of each cell or facet of the terrain, as its surface numbers their sources: that of the
/// last polygon in the file that holds its middle, the default where there is none. Overlaps and gaps are reported in
/// `warnings`, with their areas on plan. Throws BadInput for what is wrong with the file, and for values without a
/// material; expects fewer than 256 materials.
[[nodiscard]] std::vector<std::uint8_t> materials_of_polygons(const Project& project, const BuiltTerrain& terrain,
                                                              Problems& warnings);

}  // namespace talus::project
