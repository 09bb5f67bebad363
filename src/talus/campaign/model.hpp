#pragma once
// Everything that a campaign needs: terrain, ground, barriers, laws and seeders, in the local frame.

#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "talus/core/shared.hpp"
#include "talus/results/ensemble.hpp"
#include "talus/results/runout_frame.hpp"
#include "talus/seeding/seeder.hpp"
#include "talus/terrain/local_frame.hpp"
#include "talus/terrain/profile.hpp"
#include "talus/terrain/raster_surface.hpp"
#include "talus/terrain/triangle_mesh.hpp"
#include "talus/trajectory/scene.hpp"

namespace talus {

/// A section whose vertices vary from rock to rock: normally distributed about their given positions, within three
/// standard deviations.
struct VaryingSection {
  std::vector<Vec2> vertices;                  // local
  std::vector<std::array<Sampler, 2>> shifts;  // of x and z [m]
};

/// The parts of a terrain as the project numbers them: the segments of a section, extruded or not, the triangles of a
/// mesh before cleaning, the cells of a raster.
struct TerrainParts {
  std::size_t count = 0;
  Shared<std::vector<std::uint32_t>> of_source;  // by the surface's source(); empty: the same numbers

  [[nodiscard]] std::uint32_t of(std::uint32_t source) const {
    return of_source->empty() ? source : (*of_source)[source];
  }
};

using ModelSurface = std::variant<Profile, TriangleMesh, RasterSurface>;

struct Model {
  Shared<ModelSurface> surface;           // copies of a model refer to the same
  std::optional<VaryingSection> varying;  // only with a Profile
  LocalFrame frame;
  TerrainParts parts;
  std::string crs_wkt;         // of the user's coordinates; empty: unknown
  std::string terrain_report;  // for the user: what cleaning the mesh found and changed
  std::string seeder_report;   // for the user: where seeders on lines and cells release rocks, a line each
  Ground ground;
  std::vector<Barrier> barriers;
  Laws laws;
  std::uint64_t seed = 1;
  SamplingMethod sampling = SamplingMethod::monte_carlo;
  std::vector<Seeder> seeders;
  std::vector<std::string> sources;  // names, by SourceId
  double energy_datum = 0;           // elevation of zero potential energy, in the user's coordinates [m]
  RunoutFrame runout_frame;          // from where runout is counted; local

  /// Variants of this model with other materials, laws, capacities, sizes and velocities, for uncertain parameters;
  /// without a surface, since all have the same. None: all rocks have the properties of this model.
  std::vector<Model> ensembles;
  std::vector<std::string> uncertain;                 // the paths of the parameters that differ between ensembles
  std::vector<std::vector<double>> drawn_parameters;  // their values, by ensemble

  [[nodiscard]] const Model& of_rock(std::uint64_t rock) const {
    return ensembles.empty() ? *this : ensembles[ensemble_of(rock, ensembles.size())];
  }
  /// A copy of what trajectories depend on, but for the surface. Lists that grow with the terrain are shared.
  [[nodiscard]] Model without_surface() const;

  [[nodiscard]] std::uint64_t rocks() const {
    return seeders.empty() ? 0 : seeders.back().first_rock + seeders.back().rocks;
  }
};

}  // namespace talus
