// The rough slope (rough_slope.hpp) as a raster, compared to a bare loop (bare_loop.hpp) in the same run: the cost of
// sampling and sliding, of maps with percentiles, a second core, a raster sixteen times as large, the same ground as a
// mesh, a sphere; and a slope of waves, where rocks run far. Usage: bench_raster [rocks] [sphere]; with `sphere`, only
// the lumped mass and the sphere.
//
// The bare loop has no sliding: a rock whose bounces die away falls through the ground, and nine in ten of the cells
// that it counts on the rough slope are crossed below the ground.

#include <cstdlib>
#include <cstring>

#include "bare_loop.hpp"
#include "common.hpp"
#include "rough_slope.hpp"
#include "talus/results/map_observer.hpp"

using namespace talus;

namespace {

template <class Height>
RasterGrid grid_of(std::uint32_t nodes, Height&& height) {
  RasterGrid grid;
  grid.columns = grid.rows = nodes;
  grid.z.reserve(static_cast<std::size_t>(nodes) * nodes);
  for (std::uint32_t j = 0; j < nodes; ++j) {
    for (std::uint32_t i = 0; i < nodes; ++i) grid.z.push_back(static_cast<float>(height(i, j)));
  }
  return grid;
}

RasterGrid rough_grid(std::uint32_t nodes) {
  const bench::RoughSlope slope(nodes);
  return grid_of(nodes, [&](double x, double y) { return slope.height(x, y); });
}

/// The raster's triangles as a mesh.
TriangleMesh mesh_of(const RasterSurface& raster) {
  const RasterGrid& grid = raster.grid();
  std::vector<Vec3> vertices;
  for (std::uint32_t j = 0; j < grid.rows; ++j) {
    for (std::uint32_t i = 0; i < grid.columns; ++i) {
      vertices.emplace_back(i, j, grid.z[static_cast<std::size_t>(j) * grid.columns + i]);
    }
  }
  std::vector<TriangleMesh::Corners> triangles, neighbours;
  for (std::uint32_t facet = 0; facet < raster.facet_count(); ++facet) {
    TriangleMesh::Corners corners, beyond;
    const Triangle triangle = raster.triangle(FacetId{facet});
    const Outline outline = raster.outline(FacetId{facet});
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] =
          static_cast<std::uint32_t>(triangle[k].y()) * grid.columns + static_cast<std::uint32_t>(triangle[k].x());
      beyond[k] = outline.edges[k].beyond ? outline.edges[k].beyond->index : TriangleMesh::no_neighbour;
    }
    triangles.push_back(corners);
    neighbours.push_back(beyond);
  }
  return TriangleMesh(vertices, triangles, neighbours);
}

/// Counts the cells of 1 m over which rocks pass; consecutive pieces in one cell count once.
class CellCount : public Observer {
 public:
  std::uint64_t cells = 0;
  [[nodiscard]] bool wants_rows(std::uint64_t) const override { return false; }
  [[nodiscard]] bool wants_pieces() const override { return true; }
  [[nodiscard]] std::unique_ptr<ObserverPart> new_part() const override { return std::make_unique<Part>(); }
  void commit(ObserverPart& part) override { cells += static_cast<Part&>(part).cells; }

 private:
  struct Part : ObserverPart {
    void see(const RockRecord&, const RockLog& log) override {
      std::optional<MapCell> last;
      log.for_each_piece([&](const PathPiece& piece) {
        walk(grid, piece, [&](MapCell cell, double, double) {
          cells += last != cell ? 1 : 0;
          last = cell;
        });
      });
    }
    MapGrid grid{{0, 0}, 1, {}};
    std::uint64_t cells = 0;
  };
};

struct Speed {
  double rocks_per_second, seconds_per_impact;
};

Speed talus_run(const Model& model, const char* what, int threads, MapObserver* maps = nullptr) {
  bench::EndHash ends;
  std::vector<Observer*> observers{&ends};
  if (maps != nullptr) observers.push_back(maps);
  const double seconds = bench::seconds([&] {
    (void)run_campaign(model, observers, {threads, nullptr, {}});
    if (maps != nullptr) (void)maps->maps();
  });
  const auto rocks = static_cast<double>(ends.rocks), impacts = static_cast<double>(ends.events);
  fmt::print(
      "{}: {} rocks, {} threads, {:.2f} s, {:.0f} rocks/s, {:.1f} impacts per rock, {:.0f} ns per impact, hash "
      "{:016x}\n",
      what, ends.rocks, threads, seconds, rocks / seconds, impacts / rocks, seconds * threads * 1e9 / impacts,
      ends.hash());
  return {rocks / seconds, seconds / impacts};
}

Speed mapped_run(const Model& model, const RasterSurface& surface, const char* what) {
  MapObserver maps(MapGrid({0, 0}, 1, {}), max_height_over(surface, RockModel::lumped_mass));
  const Speed speed = talus_run(model, what, 1, &maps);
  const auto cells = static_cast<double>(maps.maps().touched_cells());
  fmt::print("  {:.0f} cells touched, {:.0f} bytes each\n", cells, static_cast<double>(maps.maps().bytes()) / cells);
  return speed;
}

double bare_run(const RasterGrid& grid, const RasterSurface& surface, std::uint64_t rocks) {
  bench::BareCount count;
  const double seconds = bench::bare_loop(grid, surface, rocks, count);
  const auto number = static_cast<double>(rocks);
  fmt::print(
      "bare loop: {} rocks, {:.2f} s, {:.0f} rocks/s, {:.1f} impacts and {:.0f} cells per rock, {:.1f} ns per cell "
      "(sum "
      "{:.17g})\n",
      rocks, seconds, number / seconds, static_cast<double>(count.impacts) / number,
      static_cast<double>(count.cells) / number, seconds * 1e9 / static_cast<double>(count.cells), count.sum);
  return number / seconds;
}

double cells_per_rock(const Model& model) {
  CellCount count;
  Observer* const observers[] = {&count};
  const CampaignOutcome outcome = run_campaign(model, observers, {1, nullptr, {}, RockRange{0, 2000}});
  return static_cast<double>(count.cells) / static_cast<double>(outcome.done);
}

Model slope_model(RasterSurface surface, std::uint64_t rocks) {
  const double width = surface.grid().rows;
  return bench::model_on(std::move(surface), rocks, RockModel::lumped_mass, width);
}

void sphere_run(const RasterGrid& grid, std::uint64_t rocks, const Speed& lumped_mass) {
  const Model model = bench::model_on(RasterSurface(grid), rocks, RockModel::rigid_sphere, bench::side);
  const Speed sphere = talus_run(model, "rigid sphere", 1);
  fmt::print("  {:.1f} times the lumped mass's time per impact (target: at most 4)\n",
             sphere.seconds_per_impact / lumped_mass.seconds_per_impact);
}

}  // namespace

int main(int argc, char** argv) {
  const std::uint64_t rocks = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 200'000;
  const bool spheres_only = argc > 2 && std::strcmp(argv[2], "sphere") == 0;
  const RasterGrid grid = rough_grid(bench::side);
  Model model = slope_model(RasterSurface(grid), rocks);
  const auto& surface = std::get<RasterSurface>(*model.surface);
  fmt::print("rough slope: {} x {} nodes, {:.1f} bytes per cell\n", grid.columns, grid.rows,
             static_cast<double>(surface.bytes()) / static_cast<double>(surface.cell_count()));

  if (spheres_only) {
    sphere_run(grid, rocks / 20, talus_run(model, "lumped mass", 1));
    return 0;
  }
  const double bare_rate = bare_run(grid, surface, rocks);
  const Speed one = talus_run(model, "lumped mass", 1);
  fmt::print("  {:.2f} of the bare loop (target: 1)\n", one.rocks_per_second / bare_rate);
  const Speed mapped = mapped_run(model, surface, "with all maps and percentiles");
  fmt::print("  {:.2f} of the bare loop (target: 0.4)\n", mapped.rocks_per_second / bare_rate);
  const Speed two = talus_run(model, "lumped mass", 2);
  fmt::print("  {:.2f} of one thread (target: 1.9)\n", two.rocks_per_second / one.rocks_per_second);

  const double cells = cells_per_rock(model);
  const Model large = slope_model(RasterSurface(rough_grid(4 * bench::side - 3)), rocks);
  const Speed far = talus_run(large, "4097 x 4097 nodes", 1);
  const double far_cells = cells_per_rock(large);
  fmt::print("  {:.2f} times the cost per cell (target: at most 1.5; {:.0f} and {:.0f} cells per rock)\n",
             one.rocks_per_second * cells / (far.rocks_per_second * far_cells), far_cells, cells);

  const Model mesh = bench::model_on(mesh_of(surface), rocks / 2, RockModel::lumped_mass, bench::side);
  const Speed meshed = talus_run(mesh, "the same as a mesh", 1);
  fmt::print("  {:.1f} times the raster's time (target: at most 3)\n", one.rocks_per_second / meshed.rocks_per_second);
  sphere_run(grid, rocks / 20, one);

  const RasterGrid wavy = grid_of(bench::side, bench::waves);
  const Model running = slope_model(RasterSurface(wavy), rocks / 4);
  const auto& waves = std::get<RasterSurface>(*running.surface);
  const double bare_running = bare_run(wavy, waves, rocks / 4);
  const Speed run = talus_run(running, "on waves", 1);
  fmt::print("  {:.2f} of the bare loop; {:.0f} cells per rock\n", run.rocks_per_second / bare_running,
             cells_per_rock(running));
  const Speed running_mapped = mapped_run(running, waves, "on waves, with all maps and percentiles");
  fmt::print("  {:.2f} of the bare loop\n", running_mapped.rocks_per_second / bare_running);
}
