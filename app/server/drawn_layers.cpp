#include "drawn_layers.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "file_state.hpp"
#include "http/answer.hpp"
#include "run_model.hpp"
#include "talus/files/checksum.hpp"
#include "talus/layers/terrain_on_plan.hpp"

namespace talus::server {

namespace {

/// Changes with everything that a picture or lines depend on. A file whose changes cannot be detected is read again
/// whenever the project changes.
std::string key_of(const ShelvedModel& model, const project::Layer& layer, const TerrainOnPlan& terrain) {
  const std::filesystem::path file = model.project.file.parent_path() / layer.file;
  return text_of(checksum_of(fmt::format("{}\n{}\n{}\n{}\n{}", state_of_file(file).value_or(model.id), layer.layer,
                                         layer.name_attribute, in_words(terrain.area), terrain.crs_wkt)));
}

DrawnLayer draw(const ShelvedModel& model, std::size_t number, const TerrainOnPlan& terrain, std::string key) {
  DrawnLayer drawn{.key = std::move(key)};
  const project::Layer& layer = model.project.layers[number];
  project::with_layer(model.project, number, drawn.warnings, [&](const std::filesystem::path& file, Problems& doubts) {
    drawn.kind = kind_of_layer(file);
    if (drawn.kind == LayerKind::raster) {
      drawn.picture = picture_of_raster(file, terrain, doubts);
    } else {
      drawn.shapes = shapes_of_layer(file, {layer.layer, layer.name_attribute}, terrain, doubts);
    }
  });
  drawn.bytes = drawn.picture.bytes.size() + drawn.shapes.points() * sizeof(Vec2);
  return drawn;
}

}  // namespace

DrawnLayers::Held DrawnLayers::of(const ModelShelf::Held& model, std::size_t layer) {
  if (layer >= model->project.layers.size() || model->project.is_2d())
    throw Refusal(404, fmt::format("layer {}", layer), "there is no such layer");
  const TerrainOnPlan terrain = terrain_on_plan(model->model);
  const std::string key = key_of(*model, model->project.layers[layer], terrain);
  Held held;
  {
    const std::lock_guard lock(mutex_);
    const auto found = std::ranges::find_if(kept_, [&](const Held& each) { return each->key == key; });
    if (found != kept_.end()) held = *found;
  }
  if (!held) {
    held = reading_.read<DrawnLayer>("layer " + key,
                                     [model, layer, terrain, key] { return draw(*model, layer, terrain, key); });
  }
  const std::lock_guard lock(mutex_);
  std::erase(kept_, held);
  kept_.push_front(held);
  kept_.resize(count_within(kept_, most_bytes_));
  return held;
}

}  // namespace talus::server
