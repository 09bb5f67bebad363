#include "talus/results/maps.hpp"

#include <tbb/parallel_for_each.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "talus/core/check.hpp"

namespace talus {

void MapTally::add(std::span<const MapVisit* const> visits) {
  passages_ += visits.size();
  for (const MapVisit* visit : visits) {
    deposits_ += visit->is_deposit ? 1 : 0;
    impacts_ += visit->impacts;
    for (std::size_t k = 0; k < map_quantity_count; ++k) {
      greatest_[k] = std::max(greatest_[k], visit->greatest[k]);
      sums_[k].add(static_cast<double>(visit->greatest[k]));
    }
  }
  for (const MapVisit* visit : visits) {
    for (std::uint32_t k = 0; k < map_quantity_count; ++k) bins_.add(k, visit->greatest[k]);
  }
}

void MapTally::merge(const MapTally& other) {
  passages_ += other.passages_;
  deposits_ += other.deposits_;
  impacts_ += other.impacts_;
  for (std::size_t k = 0; k < map_quantity_count; ++k) {
    greatest_[k] = std::max(greatest_[k], other.greatest_[k]);
    sums_[k].merge(other.sums_[k]);
  }
  bins_.merge(other.bins_);
}

void MapTally::save(ByteWriter& out) const {
  out.put(passages_);
  out.put(deposits_);
  out.put(impacts_);
  out.numbers(std::span(greatest_));
  for (const FixedSum& sum : sums_) sum.save(out);
  bins_.save(out);
}

void MapTally::merge_saved(ByteReader& in) {
  constexpr const char* damaged = "a cell of maps is damaged";
  const auto passages = in.get<std::uint64_t>(), deposits = in.get<std::uint64_t>();
  expect_bytes(passages > 0 && deposits <= passages, damaged);
  passages_ += passages;
  deposits_ += deposits;
  impacts_ += in.get<std::uint64_t>();
  for (float& greatest : greatest_) {
    const auto saved = in.get<float>();
    expect_bytes(saved >= 0 && std::isfinite(saved), damaged);
    greatest = std::max(greatest, saved);
  }
  for (FixedSum& sum : sums_) sum.merge_saved(in);
  for (const std::uint64_t values : bins_.merge_saved(in)) expect_bytes(values == passages, damaged);
}

namespace {

// Divisions that round down, also for cells before the origin: a tile's side is a power of two.
constexpr std::int32_t tile_shift = 5;
static_assert(1 << tile_shift == Maps::tile_side);
constexpr std::int32_t within_tile = Maps::tile_side - 1;

std::uint64_t tile_key(MapCell cell) {
  const auto column = static_cast<std::uint32_t>(cell.column >> tile_shift);
  const auto row = static_cast<std::uint32_t>(cell.row >> tile_shift);
  return std::uint64_t{row} << 32 | column;
}

constexpr std::size_t cells_in_tile = std::size_t{Maps::tile_side} * Maps::tile_side;
std::size_t place_in_tile(MapCell cell) {
  return static_cast<std::size_t>((cell.row & within_tile) * Maps::tile_side + (cell.column & within_tile));
}

}  // namespace

MapTally& Maps::Tile::tally(MapCell cell) {
  std::uint16_t& place = places_[place_in_tile(cell)];
  if (place == 0) {
    // By a quarter: of what is kept for each cell, doubling would waste too much.
    if (tallies_.size() == tallies_.capacity())
      tallies_.reserve(tallies_.size() + std::max<std::size_t>(16, tallies_.size() / 4));
    tallies_.emplace_back();
    place = static_cast<std::uint16_t>(tallies_.size());
  }
  return tallies_[place - 1U];
}

/// Cell by cell, so that what is known of a cell is fetched once: half the time of the order in which they came.
void Maps::Tile::add_waiting() {
  std::array<std::uint32_t, cells_in_tile + 1> ends{};
  for (const MapVisit* visit : waiting_) ++ends[place_in_tile(visit->cell) + 1];
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  std::vector<const MapVisit*> sorted(waiting_.size());
  for (const MapVisit* visit : waiting_) sorted[ends[place_in_tile(visit->cell)]++] = visit;
  for (auto first = sorted.begin(); first != sorted.end();) {
    const MapCell cell = (*first)->cell;
    const auto last = std::find_if(first, sorted.end(), [&](const MapVisit* visit) { return visit->cell != cell; });
    tally(cell).add(std::span(first, last));
    first = last;
  }
  waiting_.clear();
}

Maps::Tile& Maps::tile(MapCell cell) {
  const MapCell first{cell.column & ~within_tile, cell.row & ~within_tile};
  if (recent_ == nullptr || recent_->first_ != first) {
    auto& tile = tiles_[tile_key(cell)];
    if (!tile) tile = std::make_unique<Tile>(first);
    recent_ = tile.get();
  }
  return *recent_;
}

void Maps::add(std::uint64_t rocks, std::span<const std::span<const MapVisit>> visits) {
  rocks_ += rocks;
  std::vector<Tile*> touched;
  for (const std::span<const MapVisit> list : visits) {
    for (const MapVisit& visit : list) {
      Tile& there = tile(visit.cell);
      if (there.waiting_.empty()) touched.push_back(&there);
      there.waiting_.push_back(&visit);
    }
  }
  // Isolated: a thread that waits for the last tile must not begin a block of rocks meanwhile.
  tbb::this_task_arena::isolate(
      [&] { tbb::parallel_for_each(touched.begin(), touched.end(), [](Tile* each) { each->add_waiting(); }); });
}

void Maps::settle() {
  tbb::this_task_arena::isolate([&] {
    tbb::parallel_for_each(tiles_.begin(), tiles_.end(), [](auto& each) {
      for (MapTally& tally : each.second->tallies_) tally.settle();
    });
  });
}

void Maps::merge(const Maps& other) {
  TALUS_PROMISE(grid_ == other.grid_, "only maps on the same grid can be merged");
  rocks_ += other.rocks_;
  for (const auto& [key, theirs] : other.tiles_) {
    Tile& mine = tile(theirs->first_);
    for (std::int32_t row = 0; row < tile_side; ++row) {
      for (std::int32_t column = 0; column < tile_side; ++column) {
        const MapTally* found = theirs->find(column, row);
        if (found != nullptr) mine.tally({theirs->first_.column + column, theirs->first_.row + row}).merge(*found);
      }
    }
  }
}

void Maps::save(ByteWriter& out) const {
  out.put(rocks_);
  for (const Vec2& lengths : {grid_.origin(), grid_.cell()}) {
    out.put(lengths.x());
    out.put(lengths.y());
  }
  out.count(tiles_.size());
  for (const Tile* tile : tiles()) {
    out.put(tile->first_.row);
    out.put(tile->first_.column);
    out.count(tile->tallies_.size());
    for (std::uint16_t place = 0; place < cells_in_tile; ++place) {
      if (tile->places_[place] == 0) continue;
      out.put(place);
      tile->tallies_[tile->places_[place] - 1U].save(out);
    }
  }
}

void Maps::merge_saved(ByteReader& in) {
  constexpr const char* damaged = "the cells of maps are damaged";
  rocks_ += in.get<std::uint64_t>();
  for (const Vec2& lengths : {grid_.origin(), grid_.cell()}) {
    const auto x = in.get<double>(), y = in.get<double>();
    expect_bytes(x == lengths.x() && y == lengths.y(), "maps lie on another grid");
  }
  std::optional<std::pair<std::int32_t, std::int32_t>> tile_before;
  for (std::size_t tiles = in.count(sizeof(MapCell) + sizeof(std::uint64_t)); tiles > 0; --tiles) {
    MapCell first;
    first.row = in.get<std::int32_t>();
    first.column = in.get<std::int32_t>();
    const std::pair order(first.row, first.column);
    expect_bytes((first.row & within_tile) == 0 && (first.column & within_tile) == 0, damaged);
    expect_bytes(!tile_before || *tile_before < order, damaged);
    tile_before = order;
    const std::size_t cells = in.count(sizeof(std::uint16_t) + MapTally::least_saved);
    expect_bytes(cells > 0, damaged);
    std::optional<std::uint16_t> place_before;
    for (std::size_t k = 0; k < cells; ++k) {
      const auto place = in.get<std::uint16_t>();
      expect_bytes(place < cells_in_tile && (!place_before || *place_before < place), damaged);
      place_before = place;
      const MapCell cell{first.column + place % tile_side, first.row + place / tile_side};
      MapTally& tally = tile(cell).tally(cell);
      tally.merge_saved(in);
      expect_bytes(tally.passages() <= rocks_, damaged);
    }
  }
}

std::size_t Maps::touched_cells() const {
  std::size_t cells = 0;
  for (const auto& [key, tile] : tiles_) cells += tile->tallies_.size();
  return cells;
}

std::size_t Maps::bytes() const {
  std::size_t bytes = tiles_.bucket_count() * sizeof(void*);
  for (const auto& [key, tile] : tiles_) {
    constexpr std::size_t node = sizeof(void*) + sizeof(*tiles_.begin());  // of the map
    bytes += node + sizeof(Tile) + tile->tallies_.capacity() * sizeof(MapTally);
    for (const MapTally& tally : tile->tallies_) bytes += tally.bytes_elsewhere();
  }
  return bytes;
}

std::optional<Maps::Extent> Maps::extent() const {
  std::optional<Extent> extent;
  for (const Tile* tile : tiles()) {
    for (std::int32_t row = 0; row < tile_side; ++row) {
      for (std::int32_t column = 0; column < tile_side; ++column) {
        if (tile->find(column, row) == nullptr) continue;
        const MapCell cell{tile->first().column + column, tile->first().row + row};
        if (!extent) extent = Extent{cell, cell};
        extent->first = {std::min(extent->first.column, cell.column), std::min(extent->first.row, cell.row)};
        extent->last = {std::max(extent->last.column, cell.column), std::max(extent->last.row, cell.row)};
      }
    }
  }
  return extent;
}

std::vector<const Maps::Tile*> Maps::tiles() const {
  std::vector<const Tile*> list;
  list.reserve(tiles_.size());
  for (const auto& [key, tile] : tiles_) list.push_back(tile.get());
  std::sort(list.begin(), list.end(), [](const Tile* a, const Tile* b) {
    return std::pair(a->first().row, a->first().column) < std::pair(b->first().row, b->first().column);
  });
  return list;
}

}  // namespace talus
