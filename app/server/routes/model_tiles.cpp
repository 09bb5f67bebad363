#include <algorithm>
#include <deque>
#include <memory>
#include <mutex>
#include <utility>

#include "mesh_tiles.hpp"
#include "model_shelf.hpp"
#include "routes/routes.hpp"
#include "terrain_tiles.hpp"

namespace talus::server {

namespace {

/// The tiles of the last meshes, as long as the shelf keeps their models. Thread-safe.
class MeshTileShelf {
 public:
  std::shared_ptr<MeshTiles> of(const ModelShelf::Held& held, const TriangleMesh& mesh) {
    const std::lock_guard lock(mutex_);
    std::erase_if(kept_, [](const Kept& kept) { return kept.model.expired(); });
    for (const Kept& kept : kept_)
      if (kept.model.lock() == held) return kept.tiles;
    kept_.push_front({held, std::make_shared<MeshTiles>(held->model, mesh)});
    if (kept_.size() > most_kept) kept_.pop_back();
    return kept_.front().tiles;
  }

 private:
  static constexpr std::size_t most_kept = 2;
  struct Kept {
    std::weak_ptr<const ShelvedModel> model;
    std::shared_ptr<MeshTiles> tiles;
  };
  std::mutex mutex_;
  std::deque<Kept> kept_;
};

[[noreturn]] void refuse_section() {
  throw Refusal(404, "tiles", "this model is a section", "", "Request its profile");
}

}  // namespace

void add_model_tile_routes(Router& router, const ModelShelf& shelf) {
  const auto meshes = std::make_shared<MeshTileShelf>();
  router.get("/api/models/([0-9a-f]+)/tiles", [&shelf, meshes](const Call& call) {
    const ModelShelf::Held held = shelf.find(call.part(1));
    const auto& surface = *held->model.surface;
    if (const auto* raster = std::get_if<RasterSurface>(&surface))
      return json_answer(TerrainTiles(held->model, *raster).description());
    if (const auto* mesh = std::get_if<TriangleMesh>(&surface))
      return json_answer(meshes->of(held, *mesh)->description());
    refuse_section();
  });
  // The number of digits is limited so that no number overflows.
  router.get("/api/models/([0-9a-f]+)/tiles/([0-9]{1,2})/([0-9]{1,9})/([0-9]{1,9})",
             [&shelf, meshes](const Call& call) {
               const ModelShelf::Held held = shelf.find(call.part(1));
               const auto number = [&](std::size_t k) { return static_cast<std::uint32_t>(std::stoul(call.part(k))); };
               const auto& surface = *held->model.surface;
               if (const auto* raster = std::get_if<RasterSurface>(&surface))
                 return TerrainTiles(held->model, *raster).tile(number(2), number(3), number(4));
               if (const auto* mesh = std::get_if<TriangleMesh>(&surface))
                 return meshes->of(held, *mesh)->tile(number(2), number(3), number(4));
               refuse_section();
             });
}

}  // namespace talus::server
