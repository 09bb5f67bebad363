#pragma once
// The terrain of a project, in its local frame.

#include <string>
#include <vector>

#include "talus/campaign/model.hpp"
#include "talus/core/problems.hpp"
#include "talus/core/shared.hpp"
#include "talus/project/project.hpp"

namespace talus::project {

struct BuiltTerrain {
  Shared<ModelSurface> surface;
  std::optional<VaryingSection> varying;
  LocalFrame frame;
  std::size_t parts = 0;                             // segments of a section, triangles of a mesh, cells of a raster
  std::string crs_wkt;                               // of the user's coordinates; empty: unknown
  std::string report;                                // the results of cleaning a mesh, or the description of a raster
  Shared<std::vector<std::uint32_t>> part_of_facet;  // by the facet's source number
  std::vector<Vec2> facet_centres;                   // on plan, the user's; for grounds from GIS and areas
  std::vector<double> facet_areas;                   // on plan [m2]; for grounds from polygons
};

/// The hint for a place that is off the terrain, but on it with x and y swapped.
inline constexpr const char* swapped_hint = "With x and y swapped it would lie on the terrain";

[[nodiscard]] BuiltTerrain build_terrain(const Project& project, Problems& warnings);

}  // namespace talus::project
