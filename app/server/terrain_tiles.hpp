#pragma once
// A raster in tiles and levels of detail, for drawing the visible part. Level 0 has every node, each further level
// every second node of the one before it, and the last level is one tile. Nodes are evenly spaced, so that a coarse
// level may end up to one spacing short of the raster's edge.

#include <cstdint>
#include <vector>

#include "http/answer.hpp"
#include "talus/campaign/model.hpp"

namespace talus::server {

class TerrainTiles {
 public:
  static constexpr std::uint32_t side = 256;  // cells of a tile; neighbours share the nodes of an edge

  struct Level {
    std::uint32_t stride;         // in nodes of the raster
    std::uint32_t columns, rows;  // of tiles
  };

  /// `raster` is the model's surface. The model must outlive this.
  TerrainTiles(const Model& model, const RasterSurface& raster);

  [[nodiscard]] const std::vector<Level>& levels() const { return levels_; }
  [[nodiscard]] Json description() const;
  /// Refuses (404) a tile that does not exist.
  [[nodiscard]] Answer tile(std::size_t level, std::uint32_t column, std::uint32_t row) const;

 private:
  /// A node's place on plan, at the datum of the heights.
  [[nodiscard]] Json place(std::uint32_t column, std::uint32_t row) const;

  const Model& model_;
  const RasterSurface& raster_;
  std::vector<Level> levels_;
};

}  // namespace talus::server
