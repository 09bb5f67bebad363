#include "terrain_tiles.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "http/arrays.hpp"
#include "model_description.hpp"

namespace talus::server {

namespace {

/// Steps of a level along one side of the raster; the last may be shorter, so that every level ends where the raster
/// does.
std::uint32_t steps(std::uint32_t nodes, std::uint32_t stride) { return (nodes - 1 + stride - 1) / stride; }

std::uint32_t tiles(std::uint32_t nodes, std::uint32_t stride) {
  return (steps(nodes, stride) + TerrainTiles::side - 1) / TerrainTiles::side;
}

/// The nodes of the raster, along one side, that a tile has.
std::vector<std::uint32_t> nodes_of(std::uint32_t nodes, std::uint32_t stride, std::uint32_t tile) {
  const std::uint32_t first = tile * TerrainTiles::side;
  const std::uint32_t last = std::min(first + TerrainTiles::side, steps(nodes, stride));
  std::vector<std::uint32_t> list;
  for (std::uint32_t k = first; k <= last; ++k)
    list.push_back(static_cast<std::uint32_t>(std::min<std::uint64_t>(std::uint64_t{k} * stride, nodes - 1)));
  return list;
}

}  // namespace

TerrainTiles::TerrainTiles(const Model& model, const RasterSurface& raster) : model_(model), raster_(raster) {
  const RasterGrid& grid = raster.grid();
  for (std::uint32_t stride = 1;; stride *= 2) {
    levels_.push_back({stride, tiles(grid.columns, stride), tiles(grid.rows, stride)});
    if (levels_.back().columns == 1 && levels_.back().rows == 1) return;
  }
}

Json TerrainTiles::description() const {
  const RasterGrid& grid = raster_.grid();
  Json levels = Json::array();
  for (const Level& level : levels_)
    levels.push_back({{"stride", level.stride}, {"columns", level.columns}, {"rows", level.rows}});
  return {{"origin", as_json(model_.frame.origin)},
          {"corner", {grid.x0, grid.y0}},
          {"cell", {grid.dx, grid.dy}},
          {"columns", grid.columns},
          {"rows", grid.rows},
          {"tile", side},
          {"levels", std::move(levels)}};
}

Answer TerrainTiles::tile(std::size_t level, std::uint32_t column, std::uint32_t row) const {
  if (level >= levels_.size() || column >= levels_[level].columns || row >= levels_[level].rows)
    throw Refusal(404, fmt::format("tile {}/{}/{}", level, column, row), "there is no such tile");
  const RasterGrid& grid = raster_.grid();
  const std::uint32_t stride = levels_[level].stride;
  const auto columns = nodes_of(grid.columns, stride, column), rows = nodes_of(grid.rows, stride, row);

  std::vector<float> heights;
  heights.reserve(columns.size() * rows.size());
  for (const std::uint32_t j : rows)
    for (const std::uint32_t i : columns) heights.push_back(grid.z[grid.index(i, j)]);
  std::vector<std::uint32_t> materials;
  for (std::size_t b = 0; b + 1 < rows.size(); ++b) {
    for (std::size_t a = 0; a + 1 < columns.size(); ++a) {
      // Of a cell of several, the one in the middle.
      const std::uint32_t i = (columns[a] + columns[a + 1]) / 2, j = (rows[b] + rows[b + 1]) / 2;
      materials.push_back(model_.ground.material_of(j * (grid.columns - 1) + i).index);
    }
  }
  const auto place = [&](std::uint32_t i, std::uint32_t j) {
    return Json{grid.x0 + i * grid.dx, grid.y0 + j * grid.dy};
  };
  Arrays arrays(Json{{"origin", as_json(model_.frame.origin)},
                     {"corner", place(columns.front(), rows.front())},
                     {"cell", {stride * grid.dx, stride * grid.dy}},
                     {"end", place(columns.back(), rows.back())},
                     {"columns", columns.size()},
                     {"rows", rows.size()}});
  arrays.add("heights", std::span<const float>(heights));
  arrays.add_smallest("materials", materials, model_.ground.materials().size());
  return arrays.answer();
}

}  // namespace talus::server
