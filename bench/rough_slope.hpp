#pragma once
// The slope of the benchmarks on rough terrain, as a formula: z = s(x) + b(x, y) on 1025 x 1025 points 1 m apart, s =
// 0.84 (820 - x) for x < 820, else 0; b = six octaves of value noise, amplitude 3 m * 0.5^k, wavelength 80 m / 2.03^k.
// Rocks of 1 t are released along x = 5 to 10 m, 6 m above the ground; Rn = 0.35, Rt = 0.85, standard deviation 0.03
// each.

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "talus/campaign/model.hpp"
#include "talus/core/random.hpp"

namespace talus::bench {

constexpr int side = 1025;

inline double smooth(double t) { return t * t * (3 - 2 * t); }

/// A slope of waves instead of noise: sines of x times sines of y with the same amplitudes and wavelengths. It is steep
/// in many places, and rocks run down it for 300 m.
inline double waves(double x, double y) {
  double sum = 0, amplitude = 3, wave_number = 2 * std::numbers::pi / 80;
  for (int k = 0; k < 6; ++k) {
    sum += amplitude * std::sin(wave_number * x + 1.3 * k) * std::sin(wave_number * y + 2.1 * k);
    amplitude *= 0.5;
    wave_number *= 2.03;
  }
  return 0.84 * std::max(820 - x, 0.0) + sum;
}

class RoughSlope {
 public:
  /// For x and y in [0, nodes).
  explicit RoughSlope(std::uint32_t nodes) {
    double amplitude = 3, wavelength = 80;
    for (std::uint32_t k = 0; k < 6; ++k) {
      Octave octave{amplitude, wavelength, static_cast<std::int64_t>(shift / wavelength), 0, {}};
      octave.width = static_cast<std::int64_t>((shift + nodes) / wavelength) + 2 - octave.first;
      for (std::int64_t j = 0; j < octave.width; ++j) {
        for (std::int64_t i = 0; i < octave.width; ++i) {
          const auto key =
              static_cast<std::uint64_t>(octave.first + i) << 32 | static_cast<std::uint32_t>(octave.first + j);
          octave.lattice.push_back(2 * uniform_pair(7, key, Stream::slope_vertex, k)[0] - 1);
        }
      }
      octaves_.push_back(std::move(octave));
      amplitude *= 0.5;
      wavelength /= 2.03;
    }
  }
  [[nodiscard]] double height(double x, double y) const {
    double sum = 0;
    for (const Octave& octave : octaves_) sum += octave.amplitude * octave.noise(x + shift, y + shift);
    return 0.84 * std::max(820 - x, 0.0) + sum;
  }

 private:
  static constexpr double shift = 1000;  // of the noise, so that its cells have no negative numbers
  struct Octave {
    double amplitude, wavelength;
    std::int64_t first, width;  // of the lattice
    std::vector<double> lattice;
    [[nodiscard]] double at(std::int64_t i, std::int64_t j) const {
      return lattice[static_cast<std::size_t>((j - first) * width + (i - first))];
    }
    [[nodiscard]] double noise(double x, double y) const {
      const double u = x / wavelength, v = y / wavelength;
      const auto i = static_cast<std::int64_t>(std::floor(u)), j = static_cast<std::int64_t>(std::floor(v));
      const double a = smooth(u - static_cast<double>(i)), b = smooth(v - static_cast<double>(j));
      return (at(i, j) * (1 - a) + at(i + 1, j) * a) * (1 - b) + (at(i, j + 1) * (1 - a) + at(i + 1, j + 1) * a) * b;
    }
  };
  std::vector<Octave> octaves_;
};

/// `width`: of the terrain along y [m]. Rocks are released at least 100 m from its sides.
template <class Surface>
[[nodiscard]] Model model_on(Surface surface, std::uint64_t rocks, RockModel rock_model, double width) {
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
  if (rock_model == RockModel::rigid_sphere) model.laws.impact = RigidSphereImpact{};
  Seeder seeder;
  seeder.name = "crest";
  seeder.rocks = rocks;
  const double third = (width - 200) / 3;
  const Vec3 crest[] = {{5, 100, 0}, {10, 100 + third, 0}, {5, 100 + 2 * third, 0}, {10, width - 100, 0}};
  seeder.where = ReleaseLines(crest);
  seeder.step = even_step(count_places(seeder));
  seeder.above_surface = 6;
  seeder.size = Sampler(1000.0);
  seeder.density = Sampler(2700.0);
  seeder.horizontal = Sampler(1.0);
  model.seeders.push_back(seeder);
  return model;
}

}  // namespace talus::bench
