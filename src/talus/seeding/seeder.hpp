#pragma once
// Where rocks come from: how many, where, how large, how fast.

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "talus/core/id.hpp"
#include "talus/sampling/distribution.hpp"
#include "talus/sampling/draws.hpp"
#include "talus/seeding/release.hpp"
#include "talus/seeding/release_cells.hpp"
#include "talus/seeding/release_lines.hpp"

namespace talus {

enum class SizeOf { mass, volume, diameter };

struct Seeder {
  std::string name;
  SourceId source;  // by which results tell the rocks of a point apart; lines and cells have their own
  std::uint64_t first_rock = 0;
  std::uint64_t rocks = 1;
  std::variant<Vec3, ReleaseLines, ReleaseCells> where = Vec3(0, 0, 0);  // a point, lines or cells; local coordinates
  /// Where rocks start this far above the surface [m] instead of at the places' own z; always, with cells.
  std::optional<double> above_surface;
  SizeOf size_of = SizeOf::mass;
  Sampler size;     // of the mass [kg], the volume [m3] or the diameter [m]
  Sampler density;  // [kg/m3]
  /// With `speed`, along `direction` as it is; otherwise `horizontal` along its part on plan and `vertical` upwards.
  /// Unit; nothing: that of the fall line (fall_line.hpp) where a rock starts.
  std::optional<Vec3> direction = Vec3::UnitX();
  std::optional<Sampler> speed;  // [m/s]
  Sampler horizontal, vertical;  // [m/s]
  Sampler spin;                  // [rad/s], about up x direction: positive rolls forwards
};

/// Where one rock starts, before any lifting to the surface.
struct ReleasePlace {
  Vec3 point;
  SourceId source;
  /// The middle of its cell, which is known to be on the terrain: `point` may lie over a small hole.
  std::optional<Vec2> middle;
};

/// Rocks one after the other that come from one source.
struct SourceRun {
  std::uint64_t first_rock, rocks;
  SourceId source;
};

/// Of all rocks of a seeder, in their order; rocks have these sources when they start (ReleasePlace::source).
[[nodiscard]] std::vector<SourceRun> source_runs(const Seeder& seeder, std::uint64_t seed, SamplingMethod method);

[[nodiscard]] ReleasePlace place_of(const Seeder& seeder, const Draws& draws);

/// The rock and its motion, at `place`; `direction`: the seeder's, or the fall line there.
[[nodiscard]] Release release_at(const Seeder& seeder, const Vec3& place, const Vec3& direction, const Draws& draws);

}  // namespace talus
