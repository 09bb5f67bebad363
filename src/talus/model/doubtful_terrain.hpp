#pragma once
// Terrains whose numbers are valid but probably wrong: in other units, with another axis pointing upwards, or
// with cells that are finer than the data.

#include <string>
#include <vector>

#include "talus/core/problems.hpp"
#include "talus/meshing/cleaning.hpp"
#include "talus/meshing/raw_mesh.hpp"
#include "talus/project/project.hpp"
#include "talus/terrain/raster_grid.hpp"

namespace talus::project {

/// Adds a warning if half of the cells are steeper than natural terrain, for example with elevations in centimetres.
void warn_of_steep_raster(const RasterGrid& grid, const Project& project, Problems& warnings);

/// Adds a warning if the elevations seem to be interpolated from larger cells, or if they are in steps so large that
/// the ground bends at every step.
void warn_of_coarse_raster(const RasterGrid& grid, const Project& project, Problems& warnings);

/// The names of the mesh files, for messages.
[[nodiscard]] std::vector<std::string> names_of_meshes(const MeshTerrain& meshes);

/// Adds a warning if a mesh as a whole is steeper than 60 degrees: it seems to lie on its side.
void warn_of_steep_mesh(const RawMesh& mesh, const Project& project, Problems& warnings);

/// Adds a warning if a section, a mesh or a survey is higher than any slope: its coordinates seem not to be metres.
/// `size`: its extent along x, y and z.
void warn_of_high_terrain(const Vec3& size, const Project& project, Problems& warnings);

/// Adds a warning if more than a third of the area of a mesh overhangs, and it is not closed: on its side, a slope that
/// faces along z has a mean slope of less than 60 degrees, but its benches become ceilings.
void warn_of_overhangs(const CleanMesh& mesh, const Project& project, Problems& warnings);

}  // namespace talus::project
