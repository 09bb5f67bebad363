// The cost of maps when rocks run far: the slope of waves (rough_slope.hpp), on ground so slippery that rocks run down
// all of it, without maps and with the default maps of a project, files included. Usage: bench_maps [rocks] [threads]

#include <tbb/global_control.h>

#include <cstdlib>
#include <filesystem>

#include "common.hpp"
#include "rough_slope.hpp"
#include "talus/maps/map_files.hpp"
#include "talus/results/map_observer.hpp"

using namespace talus;

namespace {

Model slope_of_waves(std::uint64_t rocks) {
  RasterGrid grid;
  grid.columns = grid.rows = bench::side;
  for (std::uint32_t j = 0; j < grid.rows; ++j) {
    for (std::uint32_t i = 0; i < grid.columns; ++i) grid.z.push_back(static_cast<float>(bench::waves(i, j)));
  }
  Model model = bench::model_on(RasterSurface(std::move(grid)), rocks, RockModel::lumped_mass, bench::side);
  Material slippery = model.ground.materials().front();
  slippery.friction_angle = Sampler(30 * std::numbers::pi / 180);
  model.ground = Ground(slippery);
  return model;
}

std::uint64_t hash_of(MapObserver& maps) {
  std::uint64_t hash = 0xcbf29ce484222325;
  ByteWriter out([&](std::string_view bytes) {
    for (const char byte : bytes) hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3;
  });
  maps.save(out);
  out.flush();
  return hash;
}

std::uint64_t visits_of(const Maps& maps) {
  std::uint64_t visits = 0;
  for (const Maps::Tile* tile : maps.tiles()) {
    for (std::int32_t k = 0; k < Maps::tile_side * Maps::tile_side; ++k) {
      if (const auto tally = tile->find(k % Maps::tile_side, k / Maps::tile_side)) visits += tally->passages();
    }
  }
  return visits;
}

}  // namespace

int main(int argc, char** argv) {
  const std::uint64_t rocks = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 200'000;
  const int threads = argc > 2 ? std::atoi(argv[2]) : 1;
  const Model model = slope_of_waves(rocks);
  const auto& surface = std::get<RasterSurface>(*model.surface);

  bench::EndHash ends;
  Observer* const without[] = {&ends};
  const double bare = bench::seconds([&] { (void)run_campaign(model, without, {threads, nullptr, {}}); });
  fmt::print("on waves: {} rocks, {} threads, {:.2f} s without maps, hash {:016x}\n", rocks, threads, bare,
             ends.hash());

  const MapSelection selection{.percentiles = {95}, .means = false};
  MapObserver maps(MapGrid::around_nodes({0, 0}, {1, 1}, {}), max_height_over(surface, RockModel::lumped_mass),
                   std::nullopt, contents_of(selection));
  Observer* const with[] = {&maps};
  const double mapped = bench::seconds([&] {
    (void)run_campaign(model, with, {threads, nullptr, {}});
    (void)maps.maps();
  });
  const Maps& made = maps.maps();
  const auto cells = static_cast<double>(made.touched_cells()), visits = static_cast<double>(visits_of(made));
  fmt::print(
      "with maps: {:.2f} s, {:.0f} ns more per visit; {:.0f} cells touched, {:.1f} visits and {:.0f} bytes each\n",
      mapped, (mapped - bare) * threads * 1e9 / visits, cells, visits / cells,
      static_cast<double>(made.bytes()) / cells);
  fmt::print("  hash {:016x}\n", hash_of(maps));

  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "talus-bench-maps";
  std::size_t files = 0;
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  const double writing = bench::seconds([&] { files = write_maps(made, selection, "", folder).size(); });
  std::filesystem::remove_all(folder);
  fmt::print("writing {} maps: {:.2f} s\n", files, writing);
  fmt::print("  in total {:.2f} times the time without maps (target: at most 2)\n", (mapped + writing) / bare);
}
