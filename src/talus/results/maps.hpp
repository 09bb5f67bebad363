#pragma once
// What rocks did in each cell of a grid on plan, in memory that follows the cells they touched and not the number of
// rocks. Everything is a count, a maximum or a sum in fixed point: any split of the rocks, merged in any order, gives
// the same bits.

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

/// Cells lie in tiles of 32 by 32, made when a rock first touches them. With all quantities and percentiles, all
/// together, a touched cell took 290 bytes at 44 rocks a cell and 370 at 174 (bench/results/2026-11-23.md).
class Maps {
 public:
  explicit Maps(const MapGrid& grid, const MapContents& contents = {}) : grid_(grid), contents_(contents) {}

  /// So many rocks more, and what they visited. Tiles are worked on by as many threads as the caller may use.
  void add(std::uint64_t rocks, std::span<const std::span<const MapVisit>> visits);
  /// The same in pieces, for those who add to several maps at once: what waits at which tiles, then add_waiting() of
  /// all of these, which may be done at the same time, then what packed visits could not count.
  void add_rocks(std::uint64_t rocks) { rocks_ += rocks; }
  void wait(const VisitRun& run, std::vector<MapTile*>& waiting);
  void add(const VisitBlock::MoreImpacts& more);
  /// Expects maps on the same grid with the same contents, settled.
  void merge(const Maps& other);
  /// Before anything is asked or saved.
  void settle();
  void save(ByteWriter& out) const;
  /// Adds saved maps; throws BadBytes on what are none, lie on another grid or hold other quantities.
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
  /// Row after row of tiles, from the least row and column.
  [[nodiscard]] std::vector<const Tile*> tiles() const;

 private:
  [[nodiscard]] Tile& tile(std::uint64_t key);

  MapGrid grid_;
  MapContents contents_;
  std::uint64_t rocks_ = 0;
  std::unordered_map<std::uint64_t, std::unique_ptr<Tile>> tiles_;  // by key
};

/// Adds what waits at tiles, on as many threads as the caller may use.
void add_waiting(std::span<MapTile* const> tiles);

}  // namespace talus
