// The rough slope (rough_slope.hpp) as a raster: Talus beside a bare loop that does nothing but throw points on it
// (cell walk, two quadratics a cell, the CRSP impact; no distributions, no sliding, no recording), in one run. Usage:
// bench_raster [rocks] [nodes a side]

#include <cstdlib>

#include "common.hpp"
#include "rough_slope.hpp"
#include "talus/campaign/simulate.hpp"
#include "talus/impact/crsp.hpp"

using namespace talus;

namespace {

RasterGrid rough_grid(std::uint32_t nodes) {
  RasterGrid grid;
  grid.columns = grid.rows = nodes;
  grid.z.reserve(static_cast<std::size_t>(nodes) * nodes);
  for (std::uint32_t j = 0; j < nodes; ++j) {
    for (std::uint32_t i = 0; i < nodes; ++i) grid.z.push_back(static_cast<float>(bench::rough_height(i, j)));
  }
  return grid;
}

struct Count {
  std::uint64_t impacts = 0, cells = 0;
  double sum = 0;  // of the end points, so that nothing is left out
};

// One rock, as plainly as it can be written.
void bare_rock(const RasterGrid& grid, Vec3 p, Vec3 v, const Rock& rock, Count& count) {
  constexpr double g = standard_gravity;
  const auto z = [&](int i, int j) {
    return static_cast<double>(grid.z[static_cast<std::size_t>(j) * grid.columns + static_cast<std::size_t>(i)]);
  };
  const int last = static_cast<int>(grid.columns) - 2;
  Vec3 w = Vec3::Zero();
  int i = static_cast<int>(p.x()), j = static_cast<int>(p.y());
  for (int impact = 0; impact < 1000; ++impact) {
    // Walk the cells of this flight.
    double t0 = 0;
    bool hit = false;
    while (!hit) {
      ++count.cells;
      const double tx = v.x() > 0 ? (i + 1 - p.x()) / v.x() : v.x() < 0 ? (i - p.x()) / v.x() : 1e300;
      const double ty = v.y() > 0 ? (j + 1 - p.y()) / v.y() : v.y() < 0 ? (j - p.y()) / v.y() : 1e300;
      const double t1 = std::max(t0, std::min(tx, ty));
      const double a = z(i, j), b = z(i + 1, j), c = z(i + 1, j + 1), d = z(i, j + 1);
      double best = 1e300, sx_best = 0, sy_best = 0;
      for (int half = 0; half < 2; ++half) {
        const double sx = half == 0 ? b - a : c - d, sy = half == 0 ? c - b : d - a;
        const double h0 = p.z() - (a + sx * (p.x() - i) + sy * (p.y() - j));
        const double h1 = v.z() - sx * v.x() - sy * v.y();
        const double q = h1 * h1 + 2 * g * h0;
        if (q < 0) continue;
        const double t = (h1 + std::sqrt(q)) / g;
        if (t < t0 + 1e-12 || t > t1 || t >= best) continue;
        const double fx = p.x() + t * v.x() - i, fy = p.y() + t * v.y() - j;
        if ((half == 0) != (fx >= fy)) continue;
        best = t;
        sx_best = sx;
        sy_best = sy;
      }
      if (best < 1e300) {
        ++count.impacts;
        const Vec3 n = Vec3(-sx_best, -sy_best, 1).normalized();
        p += best * v - Vec3(0, 0, 0.5 * g * best * best);
        v.z() -= g * best;
        const Rebound rebound = crsp_rebound(v, w, n, rock, {0.35, 0.85});
        v = rebound.velocity;
        w = rebound.spin;
        hit = true;
        break;
      }
      if (t1 > 100) {
        count.sum += p.x();
        return;
      }
      (tx < ty ? i : j) += tx < ty ? (v.x() > 0 ? 1 : -1) : (v.y() > 0 ? 1 : -1);
      if (i < 0 || j < 0 || i > last || j > last) {
        count.sum += p.x() + t1 * v.x();
        return;
      }
      t0 = t1;
    }
    if (v.squaredNorm() < 0.01) break;
  }
  count.sum += p.x();
}

double bare_loop(const RasterGrid& grid, const RasterSurface& surface, std::uint64_t rocks, Count& count) {
  const Rock rock = sphere_of_mass(1000, 2700);
  return bench::seconds([&] {
    for (std::uint64_t k = 0; k < rocks; ++k) {
      const auto u = uniform_pair(1, k, Stream::release_position, 0);
      const double x = 5 + 5 * u[0], y = 100 + (grid.rows - 200) * u[1];
      bare_rock(grid, {x, y, *surface.elevation(x, y) + 6}, {1, 0, 0}, rock, count);
    }
  });
}

struct Speed {
  double rocks_per_second, seconds_per_impact;
};

Speed talus_run(const Model& model, const char* what, int threads) {
  bench::EndHash ends;
  Observer* const observers[] = {&ends};
  const CampaignOutcome outcome = run_campaign(model, observers, {threads, nullptr, {}});
  const double rate = static_cast<double>(outcome.done) / outcome.seconds, impacts = static_cast<double>(ends.events);
  fmt::print(
      "{}: {} rocks, {} threads, {:.2f} s, {:.0f} rocks/s, {:.1f} impacts a rock, {:.0f} ns an impact, hash {:016x}\n",
      what, outcome.done, threads, outcome.seconds, rate, impacts / static_cast<double>(outcome.done),
      outcome.seconds * threads * 1e9 / impacts, ends.hash());
  return {rate, outcome.seconds / impacts};
}

}  // namespace

int main(int argc, char** argv) {
  const std::uint64_t rocks = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 200'000;
  const auto nodes = static_cast<std::uint32_t>(argc > 2 ? std::atoi(argv[2]) : bench::side);
  const RasterGrid grid = rough_grid(nodes);
  RasterSurface surface(grid);
  fmt::print("rough slope: {} x {} nodes, {:.1f} bytes a cell\n", nodes, nodes,
             static_cast<double>(surface.bytes()) / static_cast<double>(surface.cell_count()));

  Count count;
  const double seconds = bare_loop(grid, surface, rocks, count);
  const double bare_rate = static_cast<double>(rocks) / seconds;
  fmt::print(
      "bare loop: {} rocks, {:.2f} s, {:.0f} rocks/s, {:.1f} impacts and {:.0f} cells a rock, {:.1f} ns a cell (sum "
      "{:.17g})\n",
      rocks, seconds, bare_rate, static_cast<double>(count.impacts) / static_cast<double>(rocks),
      static_cast<double>(count.cells) / static_cast<double>(rocks), seconds * 1e9 / static_cast<double>(count.cells),
      count.sum);

  Model model = bench::model_on(std::move(surface), rocks, RockModel::lumped_mass);
  const Speed one = talus_run(model, "lumped mass", 1);
  fmt::print("  {:.2f} of the bare loop\n", one.rocks_per_second / bare_rate);
  const Speed two = talus_run(model, "lumped mass", 2);
  fmt::print("  {:.2f} of one thread\n", two.rocks_per_second / one.rocks_per_second);
  Model spheres =
      bench::model_on(std::move(std::get<RasterSurface>(model.surface)), rocks / 20, RockModel::rigid_sphere);
  const Speed sphere = talus_run(spheres, "rigid sphere", 1);
  fmt::print("  {:.1f} times the lumped mass's time an impact\n", sphere.seconds_per_impact / one.seconds_per_impact);
}
