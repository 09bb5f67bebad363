#pragma once
// Terrains whose numbers can be read and are probably not what was meant: in other units, or with another axis up.

#include "talus/core/problems.hpp"
#include "talus/meshing/raw_mesh.hpp"
#include "talus/project/project.hpp"
#include "talus/terrain/raster_grid.hpp"

namespace talus::project {

/// Adds a warning where half of the cells are steeper than any natural terrain is: elevations in centimetres, say.
void warn_of_steep_raster(const RasterGrid& grid, const Project& project, Problems& warnings);

/// Adds a warning where a mesh as a whole is steeper than 60 degrees: it seems to lie on its side.
void warn_of_steep_mesh(const RawMesh& mesh, const Project& project, Problems& warnings);

}  // namespace talus::project
