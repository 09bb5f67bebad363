#pragma once
// Builds a model from a project: reads and cleans the terrain, moves it to its local frame and places everything on it.

#include "talus/campaign/model.hpp"
#include "talus/core/problems.hpp"
#include "talus/model/build_terrain.hpp"
#include "talus/project/project.hpp"

namespace talus::project {

/// Builds the model of a checked project. Throws BadInput with all problems that only the terrain reveals (a seeder or
/// a barrier off the terrain, a wrong number of materials); doubts are added to `warnings`.
[[nodiscard]] Model build_model(const Project& project, Problems& warnings);

/// The terrain of a checked project, for several models on it. Throws BadInput.
[[nodiscard]] BuiltTerrain read_terrain(const Project& project, Problems& warnings);
/// The model of a project with this terrain, which it shares with all other models on it: as build_model(), for
/// projects that agree in [terrain], [ground], [[area]] and the places of [[forest]].
[[nodiscard]] Model build_model(const Project& project, const BuiltTerrain& terrain, Problems& warnings);

/// Gives a model that was built from a project of the same terrain, places and names the materials, the laws, the
/// barriers' capacities, and the sizes, shapes and velocities of releases of this one. What needs the terrain does not
/// change. Throws BadInput for a shape that cannot be built.
void set_properties(const Project& project, Model& model);

}  // namespace talus::project
