// Rocks with a shape on the rough slope (rough_slope.hpp) as a raster: rocks of 24 points - equant, flat, long - and
// cubes, each turned at random, and the sphere. Rn = 0.35, dynamic friction 0.5. Usage:
// bench_shapes [rocks] [shape, or all] [rolling friction]

#include <cstdlib>
#include <numbers>
#include <string_view>

#include "common.hpp"
#include "rough_slope.hpp"
#include "talus/meshing/rock_shape.hpp"
#include "talus/trajectory/rock_run.hpp"

using namespace talus;

namespace {

RasterSurface rough_slope() {
  const bench::RoughSlope slope(bench::side);
  RasterGrid grid;
  grid.columns = grid.rows = bench::side;
  for (std::uint32_t j = 0; j < grid.rows; ++j) {
    for (std::uint32_t i = 0; i < grid.columns; ++i) grid.z.push_back(static_cast<float>(slope.height(i, j)));
  }
  return RasterSurface(std::move(grid));
}

Ground ground(double rolling_friction) {
  Material material;
  material.normal_restitution = Sampler(0.35);
  material.tangential_restitution = Sampler(0.85);
  material.dynamic_friction = Sampler(0.5);
  material.rolling_friction = Sampler(rolling_friction);
  return Ground(material);
}

/// Uniform over all orientations (K. Shoemake, "Uniform random rotations", Graphics Gems III, 1992).
Orientation any_orientation(std::uint64_t rock) {
  const auto [a, b] = uniform_pair(1, rock, Stream::release_position, 1);
  const auto [c, d] = uniform_pair(1, rock, Stream::release_position, 2);
  const double first = 2 * std::numbers::pi * b, second = 2 * std::numbers::pi * c;
  return {std::sqrt(1 - a) * std::sin(first), std::sqrt(1 - a) * std::cos(first), std::sqrt(a) * std::sin(second),
          std::sqrt(a) * std::cos(second)};
}

/// 1 t, released along x = 5 to 10 m, 6 m above the ground.
Release release_of(const RasterSurface& surface, const RockShape* shape, std::uint64_t rock) {
  const auto [along, across] = uniform_pair(1, rock, Stream::release_position, 0);
  const double x = 5 + 5 * along, y = 100 + (bench::side - 200) * across;
  Release release;
  release.rock = sphere_of_mass(1000, 2700);
  release.shape = shape;
  release.orientation = any_orientation(rock);
  release.motion.position = {x, y, *surface.elevation(x, y) + 6};
  release.motion.velocity = {1, 0, 0};
  return release;
}

/// Counts what a run does.
struct Count {
  std::uint64_t flights = 0, legs = 0;
  void operator()(const event::Flight&) { ++flights; }
  void operator()(const event::Leg&) { ++legs; }
};

void follow(const RasterSurface& surface, const char* name, const RockShape* shape, std::uint64_t rocks,
            double rolling_friction) {
  const Ground soil = ground(rolling_friction);
  Laws laws;
  laws.model = RockModel::rigid_sphere;
  laws.impact = RigidSphereImpact{};
  const Scene<RasterSurface> scene{surface, soil, {}, laws};
  Count count;
  std::uint64_t hash = 0xcbf29ce484222325, resting = 0;
  double sum = 0, squares = 0;
  const double seconds = bench::seconds([&] {
    for (std::uint64_t rock = 0; rock < rocks; ++rock) {
      const Release release = release_of(surface, shape, rock);
      const Draws draws(SamplingPlan{}, rock);
      RockRun<RasterSurface, Count> run(scene, release, draws, count);
      const RockOutcome outcome = run.follow();
      for (const double x : coordinates(outcome.end.position)) {
        hash = (hash ^ std::bit_cast<std::uint64_t>(x)) * 0x100000001b3;
      }
      resting += outcome.reason == EndReason::at_rest ? 1 : 0;
      const double way = (outcome.end.position - outcome.start.position).xy().norm();
      sum += way;
      squares += way * way;
    }
  });
  const auto n = static_cast<double>(rocks);
  const double mean = sum / n;
  fmt::print(
      "{}: {} rocks, {:.2f} s, {:.0f} rocks/s, {:.1f} flights and {:.0f} legs on the ground per rock, runout {:.1f} +- "
      "{:.1f} m, {} at rest, hash {:016x}\n",
      name, rocks, seconds, n / seconds, static_cast<double>(count.flights) / n, static_cast<double>(count.legs) / n,
      mean, std::sqrt((squares / n - mean * mean) / n), resting, hash);
}

}  // namespace

int main(int argc, char** argv) {
  const std::uint64_t rocks = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 10'000;
  const std::string_view only = argc > 2 ? argv[2] : "all";
  const double rolling_friction = argc > 3 ? std::atof(argv[3]) : 0;
  const RasterSurface surface = rough_slope();
  fmt::print("rough slope: {} x {} nodes\n", surface.grid().columns, surface.grid().rows);
  const auto run = [&](const char* name, const RockShape* shape) {
    if (only == "all" || only == name) follow(surface, name, shape, rocks, rolling_friction);
  };
  const RockShape equant = ellipsoid_shape({1, 0.9, 0.81}), flat = ellipsoid_shape({1, 0.95, 0.475}),
                  elongated = ellipsoid_shape({1, 0.55, 0.495}), cube = regular_shape(RegularSolid::cube);
  run("equant", &equant);
  run("flat", &flat);
  run("long", &elongated);
  run("cube", &cube);
  run("sphere", nullptr);
}
