#pragma once
// Counts and quantities of rocks in each cell of a grid on plan. Memory depends on the number of touched cells, not on
// that of rocks. Everything is a count, a maximum or a fixed-point sum: any split of the rocks, merged in any order,
// gives the same bits.

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "talus/results/map_grid.hpp"
#include "talus/results/map_tile.hpp"
#include "talus/results/map_visits.hpp"

namespace talus {

/// Cells are in tiles of 32 by 32, made when a rock first touches them. With all quantities and percentiles a touched
/// cell took 290 bytes in total at 44 rocks a cell, and 370 at 174 (bench/results/2026-11-23.md).
class Maps {
 public:
  explicit Maps(const MapGrid& grid, const MapContents& contents = {}) : grid_(grid), contents_(contents) {}

  /// Adds a number of rocks and their visits. Tiles are processed by as many threads as the caller may use.
  void add(std::uint64_t rocks, std::span<const std::span<const MapVisit>> visits);
  /// The same in steps, for adding to several maps at once: queue the visits at the tiles, then add_waiting() for all
  /// of these, which may run in parallel, then the impacts that packed visits could not count.
  void add_rocks(std::uint64_t rocks) { rocks_ += rocks; }
  void wait(const VisitRun& run, std::vector<MapTile*>& waiting);
  void add(const VisitBlock::MoreImpacts& more);
  /// Expects maps on the same grid with the same contents, settled.
  void merge(const Maps& other);
  /// Must be called before values are read or saved.
  void settle();
  void save(ByteWriter& out) const;
  /// Adds saved maps; throws BadBytes on anything else, and on maps of another grid or other quantities.
  void merge_saved(ByteReader& in);

  [[nodiscard]] const MapGrid& grid() const { return grid_; }
  [[nodiscard]] const MapContents& contents() const { return contents_; }
  [[nodiscard]] std::uint64_t rocks() const { return rocks_; }
  [[nodiscard]] std::size_t touched_cells() const;
  [[nodiscard]] std::size_t bytes() const;

  /// The columns and rows from the first to the last that rocks touched.
  struct Extent {
    MapCell first, last;
  };
  [[nodiscard]] std::optional<Extent> extent() const;

  static constexpr std::int32_t tile_side = map_tiles::side;
  using Tile = MapTile;
  /// Tiles row by row, from the lowest row and column.
  [[nodiscard]] std::vector<const Tile*> tiles() const;
  /// The tile whose first cell this is; null if no rock touched it.
  [[nodiscard]] const Tile* find_tile(MapCell first) const;

 private:
  [[nodiscard]] Tile& tile(std::uint64_t key);

  MapGrid grid_;
  MapContents contents_;
  std::uint64_t rocks_ = 0;
  std::unordered_map<std::uint64_t, std::unique_ptr<Tile>> tiles_;  // by key
};

/// Adds the queued visits of tiles, on as many threads as the caller may use.
void add_waiting(std::span<MapTile* const> tiles);

}  // namespace talus
