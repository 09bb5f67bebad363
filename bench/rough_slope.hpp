#pragma once
// The slope of the benchmarks on rough terrain, as a formula: z = s(x) + b(x, y) on 1025 x 1025 points 1 m apart, s =
// 0.84 (820 - x) for x < 820, else 0; b = six octaves of value noise, amplitude 3 m * 0.5^k, wavelength 80 m / 2.03^k.
// Rocks of 1 t start along x = 5 to 10 m, 6 m above ground; Rn = 0.35, Rt = 0.85, standard deviation 0.03 each.

#include <cmath>
#include <cstdint>
#include <numbers>

#include "talus/campaign/model.hpp"
#include "talus/core/random.hpp"

namespace talus::bench {

constexpr int side = 1025;

inline double lattice(int octave, std::int64_t i, std::int64_t j) {
  return 2 * uniform_pair(7, static_cast<std::uint64_t>(i) << 32 | static_cast<std::uint32_t>(j), Stream::slope_vertex,
                          static_cast<std::uint32_t>(octave))[0] -
         1;
}

inline double smooth(double t) { return t * t * (3 - 2 * t); }

inline double noise(double x, double y) {
  double sum = 0, amplitude = 3, wavelength = 80;
  for (int octave = 0; octave < 6; ++octave) {
    const double u = x / wavelength, v = y / wavelength;
    const auto i = static_cast<std::int64_t>(std::floor(u)), j = static_cast<std::int64_t>(std::floor(v));
    const double a = smooth(u - static_cast<double>(i)), b = smooth(v - static_cast<double>(j));
    sum += amplitude * ((lattice(octave, i, j) * (1 - a) + lattice(octave, i + 1, j) * a) * (1 - b) +
                        (lattice(octave, i, j + 1) * (1 - a) + lattice(octave, i + 1, j + 1) * a) * b);
    amplitude *= 0.5;
    wavelength /= 2.03;
  }
  return sum;
}

inline double rough_height(double x, double y) { return 0.84 * std::max(820 - x, 0.0) + noise(x + 1000, y + 1000); }

template <class Surface>
[[nodiscard]] Model model_on(Surface surface, std::uint64_t rocks, RockModel rock_model) {
  Model model;
  model.surface = std::move(surface);
  Material material;
  const auto spread = [](double mean) {
    return Sampler(Distribution{mean, DistributionKind::normal, 0.03, 0.09, 0.09}, Bounds{0, 1});
  };
  material.normal_restitution = spread(0.35);
  material.tangential_restitution = spread(0.85);
  material.friction_angle = Sampler(46 * std::numbers::pi / 180);
  material.dynamic_friction = Sampler(0.5);
  material.rolling_friction = Sampler(0.2);
  model.ground = Ground(material);
  model.laws.model = rock_model;
  Seeder seeder;
  seeder.name = "crest";
  seeder.rocks = rocks;
  const Vec3 crest[] = {{5, 100, 0}, {10, 400, 0}, {5, 700, 0}, {10, 925, 0}};
  seeder.where = ReleaseLines(crest);
  seeder.above_surface = 6;
  seeder.size = Sampler(1000.0);
  seeder.density = Sampler(2700.0);
  seeder.horizontal = Sampler(1.0);
  model.seeders.push_back(seeder);
  return model;
}

}  // namespace talus::bench
