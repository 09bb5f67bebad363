#pragma once
// The visits of one rock to cells, and the packed visits of many rocks on their way to the maps.

#include <array>
#include <bit>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "talus/results/map_grid.hpp"
#include "talus/results/map_quantity.hpp"

namespace talus {

/// Which quantities are gathered, for which of them percentiles, and whether means: others take no time and no memory.
class MapContents {
 public:
  using Choice = std::array<bool, map_quantity_count>;  // by MapQuantity
  /// Everything.
  MapContents() : MapContents(all(), all(), true) {}
  /// Expects percentiles of gathered quantities only.
  MapContents(const Choice& gathered, const Choice& with_percentiles, bool has_means = true);

  /// The gathered quantities, in the order of MapQuantity.
  [[nodiscard]] std::uint32_t quantities() const { return quantities_; }
  [[nodiscard]] std::uint32_t with_percentiles() const { return with_percentiles_; }
  [[nodiscard]] bool has_means() const { return has_means_; }
  [[nodiscard]] MapQuantity quantity(std::uint32_t place) const { return list_[place]; }
  /// The place of a quantity among the gathered ones, and among those with percentiles; nullopt if it is not one of
  /// them.
  [[nodiscard]] std::optional<std::uint32_t> place(MapQuantity quantity) const { return place_[index(quantity)]; }
  [[nodiscard]] std::optional<std::uint32_t> place_of_percentiles(MapQuantity quantity) const {
    return place_of_percentiles_[index(quantity)];
  }
  friend bool operator==(const MapContents&, const MapContents&) = default;

 private:
  static constexpr Choice all() {
    Choice choice{};
    choice.fill(true);
    return choice;
  }
  static std::size_t index(MapQuantity quantity) { return static_cast<std::size_t>(quantity); }
  std::uint32_t quantities_ = 0, with_percentiles_ = 0;
  bool has_means_ = true;
  std::array<MapQuantity, map_quantity_count> list_{};
  std::array<std::optional<std::uint32_t>, map_quantity_count> place_, place_of_percentiles_;
};

/// Cells are in square tiles, whose side is a power of two.
namespace map_tiles {

inline constexpr std::int32_t shift = 5, side = 1 << shift, within = side - 1;
inline constexpr std::size_t cells = std::size_t{side} * side;

// Shifts and masks round down, also for cells before the origin.
[[nodiscard]] inline MapCell first_of(MapCell cell) { return {cell.column & ~within, cell.row & ~within}; }
[[nodiscard]] inline std::uint64_t key_of(MapCell cell) {
  const auto column = static_cast<std::uint32_t>(cell.column >> shift);
  const auto row = static_cast<std::uint32_t>(cell.row >> shift);
  return std::uint64_t{row} << 32 | column;
}
[[nodiscard]] inline std::uint32_t place_of(MapCell cell) {
  return static_cast<std::uint32_t>((cell.row & within) * side + (cell.column & within));
}
[[nodiscard]] inline MapCell cell_at(MapCell first, std::uint32_t place) {
  return {first.column + static_cast<std::int32_t>(place % side), first.row + static_cast<std::int32_t>(place / side)};
}

}  // namespace map_tiles

/// One rock in one cell.
struct MapVisit {
  MapCell cell;
  std::array<float, map_quantity_count> maxima{};  // by MapQuantity
  std::uint32_t impacts = 0;                       // on the ground
  bool is_deposit = false;                         // it ended here
};

/// The visits of one rock, in the order in which it first reached the cells. A hash table with linear probing finds a
/// cell again. A slot has the place of a visit in the list, numbered on from rock to rock; places of earlier rocks are
/// lower than those of the present one and count as empty, so that nothing has to be cleared.
class RockVisits {
 public:
  void begin_rock() {
    before_ += static_cast<std::uint32_t>(visits_.size());
    visits_.clear();
    if (before_ > 1U << 30) forget();
  }
  [[nodiscard]] std::span<const MapVisit> list() const { return visits_; }
  [[nodiscard]] bool has(MapCell cell) { return !slots_.empty() && find(cell) > before_; }
  /// The visit to a cell, added if it is new; valid until the next call.
  MapVisit& at(MapCell cell) {
    if (!visits_.empty() && visits_[recent_].cell == cell) return visits_[recent_];
    if (2 * visits_.size() >= slots_.size()) grow();
    std::uint32_t& slot = find(cell);
    if (slot <= before_) {
      visits_.push_back({cell});
      slot = before_ + static_cast<std::uint32_t>(visits_.size());
    }
    recent_ = slot - before_ - 1;
    return visits_[recent_];
  }

 private:
  std::uint32_t& find(MapCell cell) {
    const auto column = static_cast<std::uint32_t>(cell.column), row = static_cast<std::uint32_t>(cell.row);
    const std::size_t mask = slots_.size() - 1;
    std::size_t k = ((column * 0x9E3779B1U) ^ (row * 0x85EBCA77U)) >> 7 & mask;
    while (slots_[k] > before_ && visits_[slots_[k] - before_ - 1].cell != cell) k = (k + 1) & mask;
    return slots_[k];
  }
  void grow() {
    slots_.assign(std::max<std::size_t>(64, 2 * slots_.size()), 0);
    for (std::uint32_t k = 0; k < visits_.size(); ++k) find(visits_[k].cell) = before_ + k + 1;
  }
  void forget() {
    std::fill(slots_.begin(), slots_.end(), 0);
    before_ = 0;
  }

  std::vector<MapVisit> visits_;
  std::uint32_t before_ = 0, recent_ = 0;
  std::vector<std::uint32_t> slots_;
};

/// Visits of one rock to cells of one tile, packed: for each its place in the tile, whether it is a deposit, and its
/// impacts in 10, 1 and 21 bits; then the gathered quantities as floats.
struct VisitRun {
  std::uint64_t tile;  // its key
  const std::uint32_t* words;
  std::uint32_t count;
  std::uint32_t map;  // number of the set of maps they belong to
};

struct PackedVisit {
  static constexpr std::uint32_t place_bits = 10, deposit_bit = 1U << place_bits, impact_shift = place_bits + 1;
  static constexpr std::uint32_t most_impacts = (1U << (32 - impact_shift)) - 1;
  static_assert(1U << place_bits == map_tiles::cells);
  const std::uint32_t* words;
  [[nodiscard]] std::uint32_t place() const { return words[0] & (deposit_bit - 1); }
  [[nodiscard]] bool is_deposit() const { return (words[0] & deposit_bit) != 0; }
  [[nodiscard]] std::uint32_t impacts() const { return words[0] >> impact_shift; }
  [[nodiscard]] float value(std::uint32_t quantity) const { return std::bit_cast<float>(words[1 + quantity]); }
};

/// Memory for packed visits in pieces of one size, which are reused: allocating new ones takes as long as filling them.
class VisitMemory {
 public:
  static constexpr std::size_t piece_words = std::size_t{1} << 15;
  struct Piece {
    std::array<std::uint32_t, piece_words> words;
  };
  /// May be called by any thread.
  [[nodiscard]] std::unique_ptr<Piece> take();
  void give_back(std::vector<std::unique_ptr<Piece>> pieces);
  /// Frees pieces that are not in use.
  void release();

 private:
  std::mutex mutex_;
  std::vector<std::unique_ptr<Piece>> free_;
};

/// Visits of many rocks.
struct VisitBlock {
  /// Impacts beyond the number that a packed visit can count.
  struct MoreImpacts {
    std::uint32_t map;
    MapCell cell;
    std::uint32_t impacts;
  };
  std::vector<VisitRun> runs;  // their words are in `pieces`
  std::vector<MoreImpacts> more_impacts;
  std::vector<std::unique_ptr<VisitMemory::Piece>> pieces;
  [[nodiscard]] std::size_t bytes() const {
    return pieces.size() * sizeof(VisitMemory::Piece) + runs.capacity() * sizeof(VisitRun);
  }
};

/// Packs the visits of one rock after the other.
class VisitPacker {
 public:
  VisitPacker(const MapContents& contents, VisitMemory& memory) : contents_(contents), memory_(memory) {}
  void add(std::uint32_t map, std::span<const MapVisit> visits);
  /// The visits added since the last call.
  [[nodiscard]] VisitBlock take();

 private:
  MapContents contents_;
  VisitMemory& memory_;
  VisitBlock block_;
  std::uint32_t* next_ = nullptr;
  std::size_t left_ = 0;  // words, in the last piece
};

}  // namespace talus
