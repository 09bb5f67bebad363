#include "talus/results/maps.hpp"

#include <tbb/parallel_for_each.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <utility>

#include "talus/core/check.hpp"

namespace talus {

namespace {

MapCell first_cell(std::uint64_t key) {
  const auto column = static_cast<std::int32_t>(static_cast<std::uint32_t>(key) << map_tiles::shift);
  const auto row = static_cast<std::int32_t>(static_cast<std::uint32_t>(key >> 32) << map_tiles::shift);
  return {column, row};
}

/// Isolated: a thread that waits for the last tile must not start a block of rocks meanwhile.
template <class List, class Work>
void for_each_at_once(List&& list, Work&& work) {
  tbb::this_task_arena::isolate([&] { tbb::parallel_for_each(list.begin(), list.end(), work); });
}

}  // namespace

void add_waiting(std::span<MapTile* const> tiles) {
  for_each_at_once(tiles, [](MapTile* tile) { tile->add_waiting(); });
}

Maps::Tile& Maps::tile(std::uint64_t key) {
  auto& tile = tiles_[key];
  if (!tile) tile = std::make_unique<Tile>(first_cell(key), contents_);
  return *tile;
}

void Maps::wait(const VisitRun& run, std::vector<MapTile*>& waiting) {
  Tile& there = tile(run.tile);
  if (!there.has_waiting()) waiting.push_back(&there);
  there.wait(run);
}

void Maps::add(const VisitBlock::MoreImpacts& more) {
  tile(map_tiles::key_of(more.cell)).add_impacts(map_tiles::place_of(more.cell), more.impacts);
}

void Maps::add(std::uint64_t rocks, std::span<const std::span<const MapVisit>> visits) {
  VisitMemory memory;
  VisitPacker packer(contents_, memory);
  for (const std::span<const MapVisit> list : visits) packer.add(0, list);
  const VisitBlock block = packer.take();
  add_rocks(rocks);
  std::vector<MapTile*> waiting;
  for (const VisitRun& run : block.runs) wait(run, waiting);
  add_waiting(waiting);
  for (const VisitBlock::MoreImpacts& more : block.more_impacts) add(more);
  settle();
}

void Maps::settle() {
  for_each_at_once(tiles_, [](auto& each) { each.second->settle(); });
}

void Maps::merge(const Maps& other) {
  TALUS_PROMISE(grid_ == other.grid_ && contents_ == other.contents_, "only maps of the same kind can be merged");
  rocks_ += other.rocks_;
  std::vector<std::pair<Tile*, const Tile*>> pairs;
  for (const auto& [key, theirs] : other.tiles_) pairs.emplace_back(&tile(key), theirs.get());
  for_each_at_once(pairs, [](const auto& pair) { pair.first->merge(*pair.second); });
}

void Maps::save(ByteWriter& out) const {
  out.put(rocks_);
  for (const Vec2& lengths : {grid_.origin(), grid_.cell()}) {
    out.put(lengths.x());
    out.put(lengths.y());
  }
  out.put(contents_.quantities());
  out.put(contents_.with_percentiles());
  out.flag(contents_.has_means());
  out.count(tiles_.size());
  for (const Tile* tile : tiles()) {
    out.put(tile->first().row);
    out.put(tile->first().column);
    tile->save(out);
  }
}

void Maps::merge_saved(ByteReader& in) {
  constexpr const char* damaged = "the cells of maps are damaged";
  rocks_ += in.get<std::uint64_t>();
  for (const Vec2& lengths : {grid_.origin(), grid_.cell()}) {
    const auto x = in.get<double>(), y = in.get<double>();
    expect_bytes(x == lengths.x() && y == lengths.y(), "maps are on another grid");
  }
  const auto quantities = in.get<std::uint32_t>(), with_percentiles = in.get<std::uint32_t>();
  const bool has_means = in.flag();
  expect_bytes(quantities == contents_.quantities() && with_percentiles == contents_.with_percentiles() &&
                   has_means == contents_.has_means(),
               "maps have other quantities");
  std::optional<std::pair<std::int32_t, std::int32_t>> before;
  for (std::size_t tiles = in.count(sizeof(MapCell) + sizeof(std::uint64_t)); tiles > 0; --tiles) {
    MapCell first;
    first.row = in.get<std::int32_t>();
    first.column = in.get<std::int32_t>();
    const std::pair order(first.row, first.column);
    expect_bytes(map_tiles::first_of(first) == first, damaged);
    expect_bytes(!before || *before < order, damaged);
    before = order;
    tile(map_tiles::key_of(first)).merge_saved(in, rocks_);
  }
}

std::size_t Maps::touched_cells() const {
  std::size_t cells = 0;
  for (const auto& [key, tile] : tiles_) cells += tile->touched_cells();
  return cells;
}

std::size_t Maps::bytes() const {
  constexpr std::size_t node = sizeof(void*) + sizeof(*tiles_.begin());  // of the map of tiles
  std::size_t bytes = tiles_.bucket_count() * sizeof(void*) + tiles_.size() * node;
  for (const auto& [key, tile] : tiles_) bytes += tile->bytes();
  return bytes;
}

std::optional<Maps::Extent> Maps::extent() const {
  std::optional<Extent> extent;
  for (const Tile* tile : tiles()) {
    for (std::int32_t row = 0; row < tile_side; ++row) {
      for (std::int32_t column = 0; column < tile_side; ++column) {
        if (!tile->find(column, row)) continue;
        const MapCell cell{tile->first().column + column, tile->first().row + row};
        if (!extent) extent = Extent{cell, cell};
        extent->first = {std::min(extent->first.column, cell.column), std::min(extent->first.row, cell.row)};
        extent->last = {std::max(extent->last.column, cell.column), std::max(extent->last.row, cell.row)};
      }
    }
  }
  return extent;
}

const Maps::Tile* Maps::find_tile(MapCell first) const {
  const auto found = tiles_.find(map_tiles::key_of(first));
  return found == tiles_.end() ? nullptr : found->second.get();
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
