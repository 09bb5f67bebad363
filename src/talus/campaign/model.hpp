#pragma once
// All that a campaign needs: the terrain, the ground, the barriers, the laws and the seeders, in the local frame.

#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "talus/seeding/seeder.hpp"
#include "talus/terrain/local_frame.hpp"
#include "talus/terrain/profile.hpp"
#include "talus/terrain/raster_surface.hpp"
#include "talus/terrain/triangle_mesh.hpp"
#include "talus/trajectory/scene.hpp"

namespace talus {

/// A section whose vertices stand elsewhere for every rock: normal about their given places, within three standard
/// deviations.
struct VaryingSection {
  std::vector<Vec2> vertices;                  // local
  std::vector<std::array<Sampler, 2>> shifts;  // of x and z [m]
};

/// How a project counts what its terrain is made of: the segments of a section, extruded or not, the triangles of a
/// mesh before it was cleaned, the cells of a raster.
struct TerrainParts {
  std::size_t count = 0;
  std::vector<std::uint32_t> of_source;  // for each number that a surface's source() gives; empty: the same number

  [[nodiscard]] std::uint32_t of(std::uint32_t source) const { return of_source.empty() ? source : of_source[source]; }
};

struct Model {
  std::variant<Profile, TriangleMesh, RasterSurface> surface;
  std::optional<VaryingSection> varying;  // only with a Profile
  LocalFrame frame;
  TerrainParts parts;
  std::string crs_wkt;         // of the user's coordinates; empty: not known
  std::string terrain_report;  // what cleaning the mesh found and did, for the user
  std::string seeder_report;   // from where seeders on lines and cells start rocks, a line each, for the user
  Ground ground;
  std::vector<Barrier> barriers;
  Laws laws;
  std::uint64_t seed = 1;
  SamplingMethod sampling = SamplingMethod::monte_carlo;
  std::vector<Seeder> seeders;
  std::vector<std::string> sources;  // the names that a SourceId stands for, each once
  double energy_datum = 0;           // z at which potential energy is zero, the user's [m]

  [[nodiscard]] std::uint64_t rocks() const {
    return seeders.empty() ? 0 : seeders.back().first_rock + seeders.back().rocks;
  }
};

}  // namespace talus
