#include "map_array.hpp"

#include <algorithm>
#include <limits>

namespace talus::python {

namespace {

void read_tile(const Maps::Tile& tile, const Maps::Extent& extent, const MapGroup& group, std::size_t place,
               MapCells& cells, MapArray& map) {
  cells.enter(tile);
  std::vector<double> values(group.kinds.size());
  const std::int32_t first_column = std::max(tile.first().column, extent.first.column);
  const std::int32_t last_column = std::min(tile.first().column + Maps::tile_side - 1, extent.last.column);
  const std::int32_t first_row = std::max(tile.first().row, extent.first.row);
  const std::int32_t last_row = std::min(tile.first().row + Maps::tile_side - 1, extent.last.row);
  for (std::int32_t row = first_row; row <= last_row; ++row) {
    for (std::int32_t column = first_column; column <= last_column; ++column) {
      const auto cell = cells.find(column - tile.first().column, row - tile.first().row);
      if (!cell) continue;
      group.values(*cell, values);
      // A count of 0 is a cell without data, as in the files.
      if (map.is_count && values[place] == 0) continue;
      const auto line = static_cast<std::size_t>(extent.last.row - row);
      map.values[line * static_cast<std::size_t>(map.columns) +
                 static_cast<std::size_t>(column - extent.first.column)] = static_cast<float>(values[place]);
    }
  }
}

}  // namespace

std::optional<MapArray> map_array(const MapsOfRun& maps, const MapSelection& selection, std::string_view name) {
  const auto extent = maps.all.extent();
  if (!extent) return std::nullopt;
  for (const MapGroup& group : map_groups(selection)) {
    const auto kind = std::ranges::find(group.kinds, name, &MapKind::name);
    if (kind == group.kinds.end()) continue;
    const MapGrid& grid = maps.all.grid();
    MapArray map{.unit = kind->unit, .meaning = kind->meaning, .is_count = kind->is_count, .limits = kind->limits};
    map.columns = extent->last.column - extent->first.column + 1;
    map.rows = extent->last.row - extent->first.row + 1;
    map.cell = {grid.cell().x(), grid.cell().y()};
    map.corner = {grid.origin().x() + extent->first.column * grid.cell().x(),
                  grid.origin().y() + (extent->last.row + 1) * grid.cell().y()};
    map.values.assign(static_cast<std::size_t>(map.columns) * static_cast<std::size_t>(map.rows),
                      std::numeric_limits<float>::quiet_NaN());
    MapCells cells(maps, group.needs_ensembles);
    for (const Maps::Tile* tile : maps.all.tiles())
      read_tile(*tile, *extent, group, static_cast<std::size_t>(kind - group.kinds.begin()), cells, map);
    return map;
  }
  return std::nullopt;
}

}  // namespace talus::python
