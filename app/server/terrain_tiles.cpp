#include "terrain_tiles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>

#include "http/arrays.hpp"
#include "model_description.hpp"
#include "talus/terrain/cell_diagonal.hpp"

namespace talus::server {

namespace {

/// The stride of a level along one side, which may be shorter than the stride.
std::uint32_t spacing(std::uint32_t nodes, std::uint32_t stride) { return std::min(stride, nodes - 1); }

std::uint32_t steps(std::uint32_t nodes, std::uint32_t stride) { return (nodes - 1) / spacing(nodes, stride); }

std::uint32_t tiles(std::uint32_t nodes, std::uint32_t stride) {
  return (steps(nodes, stride) + TerrainTiles::side - 1) / TerrainTiles::side;
}

/// The raster's nodes in a tile, along one side.
std::vector<std::uint32_t> nodes_of(std::uint32_t nodes, std::uint32_t stride, std::uint32_t tile) {
  const std::uint32_t first = tile * TerrainTiles::side;
  const std::uint32_t last = std::min(first + TerrainTiles::side, steps(nodes, stride));
  std::vector<std::uint32_t> list;
  for (std::uint32_t k = first; k <= last; ++k) list.push_back(k * spacing(nodes, stride));
  return list;
}

/// The node before the first or after the last of a tile's nodes, at the distance of its level; nullopt: none.
std::optional<std::uint32_t> node_before(const std::vector<std::uint32_t>& list) {
  const std::uint32_t step = list[1] - list[0];
  return list.front() >= step ? std::optional(list.front() - step) : std::nullopt;
}
std::optional<std::uint32_t> node_after(const std::vector<std::uint32_t>& list, std::uint32_t nodes) {
  const std::uint32_t next = list.back() + list[1] - list[0];
  return next < nodes ? std::optional(next) : std::nullopt;
}

}  // namespace

TerrainTiles::TerrainTiles(const Model& model, const RasterSurface& raster) : model_(model), raster_(raster) {
  const RasterGrid& grid = raster.grid();
  for (std::uint32_t stride = 1;; stride *= 2) {
    levels_.push_back({stride, tiles(grid.columns, stride), tiles(grid.rows, stride)});
    if (levels_.back().columns == 1 && levels_.back().rows == 1) return;
  }
}

Json TerrainTiles::place(std::uint32_t column, std::uint32_t row) const {
  const RasterGrid& grid = raster_.grid();
  // With z = 0, so that heights of tiles are those of the grid, bit by bit.
  return as_json(model_.frame.global_from_local({grid.x0 + column * grid.dx, grid.y0 + row * grid.dy, 0}));
}

Json TerrainTiles::description() const {
  const RasterGrid& grid = raster_.grid();
  Json levels = Json::array();
  for (const Level& level : levels_)
    levels.push_back({{"stride", level.stride}, {"columns", level.columns}, {"rows", level.rows}});
  return {{"origin", place(0, 0)}, {"cell", {grid.dx, grid.dy}}, {"columns", grid.columns}, {"rows", grid.rows},
          {"tile", side},          {"levels", std::move(levels)}};
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
  // The nodes around the tile, so that its slope at the border is that of the whole terrain.
  std::vector<float> around;
  const auto add = [&](std::optional<std::uint32_t> i, std::optional<std::uint32_t> j) {
    around.push_back(i && j ? grid.z[grid.index(*i, *j)] : std::numeric_limits<float>::quiet_NaN());
  };
  for (const auto j : {node_before(rows), node_after(rows, grid.rows)})
    for (const std::uint32_t i : columns) add(i, j);
  for (const auto i : {node_before(columns), node_after(columns, grid.columns)})
    for (const std::uint32_t j : rows) add(i, j);
  // Cells are cut by the rule of the surface, those of a coarse level as if it were one.
  const auto level_height = [&, dx = spacing(grid.columns, stride), dy = spacing(grid.rows, stride)](std::uint32_t i,
                                                                                                     std::uint32_t j) {
    return double{grid.z[grid.index(i * dx, j * dy)]};
  };
  std::vector<std::uint8_t> diagonals;
  std::vector<std::uint32_t> materials;
  for (std::size_t b = 0; b + 1 < rows.size(); ++b) {
    for (std::size_t a = 0; a + 1 < columns.size(); ++a) {
      diagonals.push_back(
          is_edge_north_east(level_height, steps(grid.columns, stride) + 1, steps(grid.rows, stride) + 1,
                             column * side + static_cast<std::uint32_t>(a), row * side + static_cast<std::uint32_t>(b))
              ? 1
              : 0);
      // A coarse cell shows the material of the raster cell in its middle.
      const std::uint32_t i = (columns[a] + columns[a + 1]) / 2, j = (rows[b] + rows[b + 1]) / 2;
      materials.push_back(model_.ground.material_of(j * (grid.columns - 1) + i).index);
    }
  }
  Arrays arrays(Json{{"origin", place(columns.front(), rows.front())},
                     {"cell", {spacing(grid.columns, stride) * grid.dx, spacing(grid.rows, stride) * grid.dy}},
                     {"columns", columns.size()},
                     {"rows", rows.size()}});
  arrays.add("heights", std::span<const float>(heights));
  arrays.add("around", std::span<const float>(around));
  arrays.add("diagonals", std::span<const std::uint8_t>(diagonals));
  arrays.add_smallest("materials", materials, model_.ground.materials().size());
  return arrays.answer();
}

}  // namespace talus::server
