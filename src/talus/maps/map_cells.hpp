#pragma once
// The cells of a run's maps: of all rocks, and of each ensemble.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "talus/results/maps.hpp"

namespace talus {

/// The maps of a run. Those of the ensembles are empty unless their ranges are mapped.
struct MapsOfRun {
  MapsOfRun(const Maps& of_all, std::span<const Maps> of_ensembles = {})  // NOLINT(google-explicit-constructor)
      : all(of_all), ensembles(of_ensembles) {}
  const Maps& all;
  std::span<const Maps> ensembles;
};

/// A cell that rocks touched.
struct MapCellTallies {
  MapTally all;
  std::uint64_t rocks;                                    // of the run
  std::span<const std::optional<MapTally>> of_ensembles;  // nullopt: none of its rocks was here
  std::span<const std::uint64_t> rocks_of_ensembles;      // all of each
};

/// Finds the cells of one tile after the other.
class MapCells {
 public:
  /// Without `with_ensembles` the cells have none. The maps must outlive it.
  MapCells(const MapsOfRun& maps, bool with_ensembles);
  /// `tile` is one of the maps of all rocks.
  void enter(const MapTile& tile);
  /// The cell at an offset in columns and rows from the tile's first, valid until the next call; nullopt if no rock was
  /// there.
  [[nodiscard]] std::optional<MapCellTallies> find(std::int32_t column, std::int32_t row);

 private:
  std::uint64_t rocks_;
  std::span<const Maps> ensembles_;
  std::vector<std::uint64_t> rocks_of_ensembles_;
  const MapTile* tile_ = nullptr;
  std::vector<const MapTile*> of_ensembles_;
  std::vector<std::optional<MapTally>> here_;
};

}  // namespace talus
