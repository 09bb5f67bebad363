#include "model_shelf.hpp"
#include "routes/routes.hpp"
#include "terrain_tiles.hpp"

namespace talus::server {

namespace {

TerrainTiles tiles_of(const ShelvedModel& shelved) {
  const auto* raster = std::get_if<RasterSurface>(&shelved.model.surface);
  if (raster == nullptr) throw Refusal(404, "tiles", "this model is not a raster", "", "Request its mesh or profile");
  return {shelved.model, *raster};
}

}  // namespace

void add_model_tile_routes(Router& router, const ModelShelf& shelf) {
  router.get("/api/models/([0-9a-f]+)/tiles",
             [&](const Call& call) { return json_answer(tiles_of(*shelf.find(call.part(1))).description()); });
  // The number of digits is limited so that no number overflows.
  router.get("/api/models/([0-9a-f]+)/tiles/([0-9]{1,2})/([0-9]{1,9})/([0-9]{1,9})", [&](const Call& call) {
    const ModelShelf::Held held = shelf.find(call.part(1));
    const auto number = [&](std::size_t k) { return static_cast<std::uint32_t>(std::stoul(call.part(k))); };
    return tiles_of(*held).tile(number(2), number(3), number(4));
  });
}

}  // namespace talus::server
