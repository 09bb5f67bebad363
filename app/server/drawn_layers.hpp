#pragma once
// Reference layers of models as they are drawn: read once for as long as the file and the terrain stay the same.

#include <deque>
#include <memory>
#include <mutex>
#include <string>

#include "model_reading.hpp"
#include "model_shelf.hpp"
#include "talus/core/problems.hpp"
#include "talus/layers/check_layers.hpp"
#include "talus/layers/layer_picture.hpp"
#include "talus/layers/layer_shapes.hpp"

namespace talus::server {

struct DrawnLayer {
  std::string key;  // changes with what is drawn
  LayerKind kind = LayerKind::raster;
  LayerPicture picture{};  // of a raster
  LayerShapes shapes{};    // of a vector file
  Problems warnings{};
  std::size_t bytes = 0;
};

/// Thread-safe.
class DrawnLayers {
 public:
  using Held = std::shared_ptr<const DrawnLayer>;

  /// Keeps layers of `most_bytes` in total, or a single larger one.
  DrawnLayers(ModelReading& reading, std::size_t most_bytes) : reading_(reading), most_bytes_(most_bytes) {}

  /// The layer of this number of a model in 3D. Refuses (404) a number that the project does not have. Throws BadInput
  /// if it cannot be drawn, and as ModelReading::read().
  [[nodiscard]] Held of(const ModelShelf::Held& model, std::size_t layer);

 private:
  ModelReading& reading_;
  std::size_t most_bytes_;
  std::mutex mutex_;
  std::deque<Held> kept_;  // most recently used first
};

}  // namespace talus::server
