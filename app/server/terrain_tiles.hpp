#pragma once
// A raster in tiles and levels of detail, for a page that draws what it looks at: level 0 has every node, each further
// one every second node of the one before it, and the last is one tile. Nodes are evenly spaced, so that a coarse level
// may end short of the raster by less than its spacing.

#include <cstdint>
#include <vector>

#include "http/answer.hpp"
#include "talus/campaign/model.hpp"

namespace talus::server {

class TerrainTiles {
 public:
  static constexpr std::uint32_t side = 256;  // cells of a tile; neighbours share the nodes of an edge

  struct Level {
    std::uint32_t stride;         // nodes of the raster from one to the next
    std::uint32_t columns, rows;  // of tiles
  };

  /// Of a raster; the model must outlive this.
  TerrainTiles(const Model& model, const RasterSurface& raster);

  [[nodiscard]] const std::vector<Level>& levels() const { return levels_; }
  [[nodiscard]] Json description() const;
  /// Refuses (404) what is not there.
  [[nodiscard]] Answer tile(std::size_t level, std::uint32_t column, std::uint32_t row) const;

 private:
  /// Of a node, and the height from which heights count.
  [[nodiscard]] Json place(std::uint32_t column, std::uint32_t row) const;

  const Model& model_;
  const RasterSurface& raster_;
  std::vector<Level> levels_;
};

}  // namespace talus::server
