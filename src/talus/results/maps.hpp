#pragma once
// What rocks did in each cell of a grid on plan, in memory that follows the cells they touched and not the number of
// rocks. Everything is a count, a maximum or a sum in fixed point: any split of the rocks, merged in any order, gives
// the same bits.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "talus/results/map_grid.hpp"
#include "talus/statistics/fixed_sum.hpp"
#include "talus/statistics/log_bins.hpp"

namespace talus {

/// What a map shows of the rocks' motion. A rock counts in a cell once, with the greatest value of its stay there; if
/// it comes again, with the greatest of all its stays. Each quantity has its own greatest.
enum class MapQuantity : std::uint32_t {
  energy_total,          // translational and rotational [J]
  energy_translational,  // [J]
  velocity,              // [m/s]
  bounce_height          // of the centre above the ground below it [m]
};
inline constexpr std::size_t map_quantity_count = 4;

/// One rock in one cell.
struct MapVisit {
  MapCell cell;
  std::array<float, map_quantity_count> greatest{};  // by MapQuantity
  std::uint32_t impacts = 0;                         // on the ground
  bool is_deposit = false;                           // it ended here
};

/// All rocks in one cell.
class MapTally {
 public:
  void add(std::span<const MapVisit* const> visits);
  void merge(const MapTally& other);
  /// Before many percentiles are asked for: see LogBins.
  void settle() { bins_.settle(); }
  void save(ByteWriter& out) const;
  void merge_saved(ByteReader& in);

  [[nodiscard]] std::uint64_t passages() const { return passages_; }  // rocks that were here
  [[nodiscard]] std::uint64_t deposits() const { return deposits_; }  // rocks that came to rest here, or were stopped
  [[nodiscard]] std::uint64_t impacts() const { return impacts_; }
  [[nodiscard]] double maximum(MapQuantity quantity) const { return greatest_[static_cast<std::size_t>(quantity)]; }
  [[nodiscard]] double mean(MapQuantity quantity) const {
    return sums_[static_cast<std::size_t>(quantity)].value() / static_cast<double>(passages_);
  }
  /// The percentile of a quantity, `percent` in [0, 100], within 1 %; below 0.001 it may be given as 0.
  [[nodiscard]] double percentile(MapQuantity quantity, double percent) const {
    return std::min(maximum(quantity), bins_.quantile(static_cast<std::uint32_t>(quantity), percent / 100, passages_));
  }
  [[nodiscard]] std::size_t bytes_elsewhere() const { return bins_.bytes(); }
  /// Bytes that a saved tally takes at the least: what all have, and a bin a quantity.
  static constexpr std::size_t least_saved = 3 * 8 + map_quantity_count * (4 + 16) + 8 + map_quantity_count * 4;

  friend bool operator==(const MapTally&, const MapTally&) = default;

 private:
  std::uint64_t passages_ = 0, deposits_ = 0, impacts_ = 0;
  std::array<float, map_quantity_count> greatest_{};
  std::array<FixedSum, map_quantity_count> sums_;
  LogBins bins_;
};

/// Cells lie in tiles of 32 by 32, made when a rock first touches them. A tile takes 2 KB, a touched cell 136 bytes and
/// 4 to 6 for every bin of its percentiles, of which each rock adds four at most. Measured, all together, in bytes a
/// touched cell: 180 at 1 to 2 rocks a cell, 450 at 16, 1200 at 75, 3600 at 1900, where hardly a bin is new.
class Maps {
 public:
  explicit Maps(const MapGrid& grid) : grid_(grid) {}

  /// So many rocks more, and what they visited. Tiles are worked on by as many threads as the caller may use.
  void add(std::uint64_t rocks, std::span<const std::span<const MapVisit>> visits);
  /// Expects maps on the same grid.
  void merge(const Maps& other);
  /// Before many percentiles are asked for.
  void settle();
  void save(ByteWriter& out) const;
  /// Adds saved maps; throws BadBytes on what are none, or lie on another grid.
  void merge_saved(ByteReader& in);

  [[nodiscard]] const MapGrid& grid() const { return grid_; }
  [[nodiscard]] std::uint64_t rocks() const { return rocks_; }
  [[nodiscard]] std::size_t touched_cells() const;
  [[nodiscard]] std::size_t bytes() const;

  /// The columns and rows from the first to the last that rocks touched.
  struct Extent {
    MapCell first, last;
  };
  [[nodiscard]] std::optional<Extent> extent() const;

  static constexpr std::int32_t tile_side = 32;
  /// A square of cells, of which some were touched.
  class Tile {
   public:
    explicit Tile(MapCell first) : first_(first) {}
    /// The cell of least column and row.
    [[nodiscard]] MapCell first() const { return first_; }
    /// Of the cell so many columns and rows from the first; null where no rock was.
    [[nodiscard]] const MapTally* find(std::int32_t column, std::int32_t row) const {
      const std::uint16_t place = places_[static_cast<std::size_t>(row * tile_side + column)];
      return place == 0 ? nullptr : &tallies_[place - 1U];
    }

   private:
    friend class Maps;
    [[nodiscard]] MapTally& tally(MapCell cell);
    void add_waiting();

    MapCell first_;
    std::array<std::uint16_t, std::size_t{tile_side} * tile_side> places_{};  // 1 + place in the list, or 0
    std::vector<MapTally> tallies_;
    std::vector<const MapVisit*> waiting_;  // empty but while visits are added
  };
  /// Row after row of tiles, from the least row and column.
  [[nodiscard]] std::vector<const Tile*> tiles() const;

 private:
  [[nodiscard]] Tile& tile(MapCell cell);

  MapGrid grid_;
  std::uint64_t rocks_ = 0;
  std::unordered_map<std::uint64_t, std::unique_ptr<Tile>> tiles_;
  Tile* recent_ = nullptr;  // rocks go from cell to cell
};

}  // namespace talus
