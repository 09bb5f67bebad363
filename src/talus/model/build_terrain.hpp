#pragma once
// The terrain of a project, in its local frame.

#include <string>
#include <variant>
#include <vector>

#include "talus/campaign/model.hpp"
#include "talus/core/problems.hpp"
#include "talus/project/project.hpp"

namespace talus::project {

struct BuiltTerrain {
  std::variant<Profile, TriangleMesh, RasterSurface> surface;
  std::optional<VaryingSection> varying;
  LocalFrame frame;
  std::size_t parts = 0;                     // segments of a section, triangles of a mesh, cells of a raster
  std::string crs_wkt;                       // of the user's coordinates; empty: not known
  std::string report;                        // what cleaning a mesh found and did; what a raster is
  std::vector<std::uint32_t> part_of_facet;  // for each facet as the surface's source numbers it
  std::vector<Vec2>
      facet_centres;  // the same facets on plan, the user's; where a ground from GIS or an area needs them
  std::vector<double> facet_areas;  // and their areas on plan [m2]; where a ground from polygons needs them
};

/// A hint where a place is off the terrain, and on it with its coordinates the other way round.
inline constexpr const char* exchanged_hint = "With x and y exchanged it would lie on the terrain";

[[nodiscard]] BuiltTerrain build_terrain(const Project& project, Problems& warnings);

}  // namespace talus::project
