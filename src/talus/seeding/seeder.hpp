#pragma once
// Where rocks come from: how many, where, how large, how fast.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "talus/sampling/distribution.hpp"
#include "talus/sampling/draws.hpp"
#include "talus/seeding/release.hpp"

namespace talus {

enum class SizeOf { mass, volume, diameter };

struct Seeder {
  std::string name;
  std::uint64_t first_rock = 0;
  std::uint64_t rocks = 1;
  /// One point, or a line along which rocks start with equal chance per metre. Local coordinates.
  std::vector<Vec3> points;
  /// Where rocks start this far above the surface [m] instead of at the points' own z.
  std::optional<double> above_surface;
  SizeOf size_of = SizeOf::mass;
  Sampler size;     // of the mass [kg], the volume [m3] or the diameter [m]
  Sampler density;  // [kg/m3]
  /// With `speed`, along `direction` as it is; otherwise `horizontal` along its part on plan and `vertical` upwards.
  Vec3 direction = Vec3::UnitX();  // unit
  std::optional<Sampler> speed;    // [m/s]
  Sampler horizontal, vertical;    // [m/s]
  Sampler spin;                    // [rad/s], about up x direction: positive rolls forwards
};

/// The place on the seeder that belongs to the uniform number u, before any lifting to the surface.
[[nodiscard]] Vec3 place_on(const Seeder& seeder, double u);

/// The rock and its motion, at `place`.
[[nodiscard]] Release release_at(const Seeder& seeder, const Vec3& place, const Draws& draws);

}  // namespace talus
