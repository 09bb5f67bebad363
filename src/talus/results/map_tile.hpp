#pragma once
// A square tile of map cells, some of which rocks touched.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "talus/results/map_visits.hpp"
#include "talus/statistics/bin_counts.hpp"
#include "talus/statistics/fixed_sum.hpp"

namespace talus {

class MapTile;

/// The rocks in one cell: a view of the data of its tile. Quantities that are not gathered must not be asked for.
class MapTally {
 public:
  [[nodiscard]] std::uint64_t passages() const;  // rocks that were here
  [[nodiscard]] std::uint64_t deposits() const;  // rocks that came to rest or were stopped here
  [[nodiscard]] std::uint64_t impacts() const;
  [[nodiscard]] double maximum(MapQuantity quantity) const;
  [[nodiscard]] double mean(MapQuantity quantity) const;
  /// Percentiles of a quantity, `percents` in [0, 100], within 1 %; below 0.001 they may be given as 0. Those of a
  /// single rock are exact.
  void percentiles(MapQuantity quantity, std::span<const double> percents, std::span<double> out) const;
  [[nodiscard]] double percentile(MapQuantity quantity, double percent) const {
    double value = 0;
    percentiles(quantity, {&percent, 1}, {&value, 1});
    return value;
  }
  friend bool operator==(const MapTally& a, const MapTally& b);

 private:
  friend class MapTile;
  MapTally(const MapTile& tile, std::uint32_t number) : tile_(&tile), number_(number) {}
  const MapTile* tile_;
  std::uint32_t number_;
};

/// A tile takes 2 KB, a touched cell 30 bytes plus 4 for every quantity and 16 for its mean, and for percentiles 30 to
/// 80 more for each quantity at a few hundred rocks a cell.
class MapTile {
 public:
  MapTile(MapCell first, const MapContents& contents)
      : first_(first), contents_(contents), bins_(contents.with_percentiles()) {}

  /// The cell with the lowest column and row.
  [[nodiscard]] MapCell first() const { return first_; }
  /// The cell at an offset in columns and rows from the first; nullopt if no rock was there, or it is not in the tile.
  [[nodiscard]] std::optional<MapTally> find(std::int32_t column, std::int32_t row) const {
    const auto is_inside = [](std::int32_t k) { return k >= 0 && k < map_tiles::side; };
    if (!is_inside(column) || !is_inside(row)) return std::nullopt;
    const std::uint16_t place = places_[static_cast<std::size_t>(row * map_tiles::side + column)];
    if (place == 0) return std::nullopt;
    return MapTally(*this, place - 1U);
  }
  [[nodiscard]] std::size_t touched_cells() const { return counts_.size(); }

  /// Queues visits for add_waiting(); their words must stay valid until then.
  void wait(const VisitRun& run) { waiting_.push_back(run); }
  [[nodiscard]] bool has_waiting() const { return !waiting_.empty(); }
  void add_waiting();
  /// Expects a cell that was visited.
  void add_impacts(std::uint32_t place, std::uint32_t impacts) { counts_[number_at(place)].impacts += impacts; }
  /// Expects a tile of the same cells, settled, with the same contents.
  void merge(const MapTile& other);
  /// Must be called before values are read or saved.
  void settle() { bins_.settle(); }

  void save(ByteWriter& out) const;
  void merge_saved(ByteReader& in, std::uint64_t rocks);
  /// Minimum size of a saved cell [bytes].
  static constexpr std::size_t least_saved = sizeof(std::uint16_t) + 3 * sizeof(std::uint64_t);

  [[nodiscard]] std::size_t bytes() const;

 private:
  friend class MapTally;
  friend bool operator==(const MapTally& a, const MapTally& b);
  struct Counts {
    std::uint64_t passages = 0, deposits = 0, impacts = 0;
    friend bool operator==(const Counts&, const Counts&) = default;
  };

  /// The number of a touched cell, added if it is new.
  std::uint32_t number_at(std::uint32_t place);
  [[nodiscard]] std::span<float> maxima_of(std::uint32_t number);
  /// Puts the values of one rock into the bins of a cell. Those of its only rock are its maxima and in no bin, until a
  /// second rock comes: that saves most of the memory and time where few rocks come.
  void put_in_bins(std::uint32_t number, std::span<const float> values);
  /// Adds rocks with these maxima to a cell. The values of two or more of them are in bins that the caller merges.
  void add_rocks(std::uint32_t number, std::uint64_t passages, std::span<const float> maxima);
  template <std::uint32_t quantities, bool has_means>
  void add(std::uint32_t number, std::span<const PackedVisit> visits);
  template <bool has_means>
  void add(std::uint32_t number, std::span<const PackedVisit> visits);
  void add(std::uint32_t number, std::span<const PackedVisit> visits);

  MapCell first_;
  MapContents contents_;
  std::array<std::uint16_t, map_tiles::cells> places_{};  // 1 + number of a touched cell, or 0
  // By the number of the cell, and within it by the place of the quantity among those gathered.
  std::vector<Counts> counts_;
  std::vector<float> maxima_;
  std::vector<FixedSum> sums_;  // empty without means
  BinCounts bins_;
  std::vector<VisitRun> waiting_;
};

}  // namespace talus
