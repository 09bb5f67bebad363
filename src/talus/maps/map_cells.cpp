#include "talus/maps/map_cells.hpp"

namespace talus {

MapCells::MapCells(const MapsOfRun& maps, bool with_ensembles)
    : rocks_(maps.all.rocks()), ensembles_(with_ensembles ? maps.ensembles : std::span<const Maps>()) {
  for (const Maps& ensemble : ensembles_) rocks_of_ensembles_.push_back(ensemble.rocks());
}

void MapCells::enter(const MapTile& tile) {
  tile_ = &tile;
  of_ensembles_.clear();
  for (const Maps& ensemble : ensembles_) of_ensembles_.push_back(ensemble.find_tile(tile.first()));
}

std::optional<MapCellTallies> MapCells::find(std::int32_t column, std::int32_t row) {
  const auto all = tile_->find(column, row);
  if (!all) return std::nullopt;
  here_.clear();
  for (const MapTile* tile : of_ensembles_)
    here_.push_back(tile != nullptr ? tile->find(column, row) : std::optional<MapTally>());
  return MapCellTallies{*all, rocks_, here_, rocks_of_ensembles_};
}

}  // namespace talus
