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
  std::variant<Profile, TriangleMesh> surface;
  std::optional<VaryingSection> varying;
  LocalFrame frame;
  std::size_t parts = 0;                     // segments of a section, triangles of a mesh: what [ground] speaks of
  std::string report;                        // what mending a mesh found and did
  std::vector<std::uint32_t> part_of_facet;  // for each facet as the surface's source numbers it
};

[[nodiscard]] BuiltTerrain build_terrain(const Project& project, Problems& warnings);

}  // namespace talus::project
