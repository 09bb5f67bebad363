#include "talus/results/map_visits.hpp"

#include <utility>

#include "talus/core/check.hpp"

namespace talus {

MapContents::MapContents(const Choice& gathered, const Choice& with_percentiles, bool has_means)
    : has_means_(has_means) {
  for (std::uint32_t k = 0; k < map_quantity_count; ++k) {
    TALUS_PROMISE(gathered[k] || !with_percentiles[k], "percentiles need a gathered quantity");
    if (!gathered[k]) continue;
    list_[quantities_] = static_cast<MapQuantity>(k);
    place_[k] = quantities_++;
    if (with_percentiles[k]) place_of_percentiles_[k] = with_percentiles_++;
  }
}

std::unique_ptr<VisitMemory::Piece> VisitMemory::take() {
  {
    const std::lock_guard lock(mutex_);
    if (!free_.empty()) {
      auto piece = std::move(free_.back());
      free_.pop_back();
      return piece;
    }
  }
  return std::make_unique_for_overwrite<Piece>();
}

void VisitMemory::give_back(std::vector<std::unique_ptr<Piece>> pieces) {
  const std::lock_guard lock(mutex_);
  free_.insert(free_.end(), std::make_move_iterator(pieces.begin()), std::make_move_iterator(pieces.end()));
}

void VisitMemory::release() {
  const std::lock_guard lock(mutex_);
  free_.clear();
  free_.shrink_to_fit();
}

void VisitPacker::add(std::uint32_t map, std::span<const MapVisit> visits) {
  const std::size_t words = 1 + contents_.quantities();
  const VisitRun none{};
  VisitRun run = none;
  const auto end_run = [&] {
    if (run.count > 0) block_.runs.push_back(std::exchange(run, none));
  };
  for (const MapVisit& visit : visits) {
    const std::uint64_t tile = map_tiles::key_of(visit.cell);
    if (left_ < words) {
      end_run();
      block_.pieces.push_back(memory_.take());
      next_ = block_.pieces.back()->words.data();
      left_ = VisitMemory::piece_words;
    }
    if (run.count == 0 || tile != run.tile) {
      end_run();
      run = {tile, next_, 0, map};
    }
    const std::uint32_t impacts = std::min(visit.impacts, PackedVisit::most_impacts);
    if (visit.impacts > impacts) block_.more_impacts.push_back({map, visit.cell, visit.impacts - impacts});
    next_[0] = map_tiles::place_of(visit.cell) | (visit.is_deposit ? PackedVisit::deposit_bit : 0) |
               impacts << PackedVisit::impact_shift;
    for (std::uint32_t k = 0; k < contents_.quantities(); ++k) {
      const float value = visit.maxima[static_cast<std::size_t>(contents_.quantity(k))];
      next_[1 + k] = std::bit_cast<std::uint32_t>(value);
    }
    next_ += words;
    left_ -= words;
    ++run.count;
  }
  end_run();
}

VisitBlock VisitPacker::take() {
  left_ = 0;
  return std::exchange(block_, {});
}

}  // namespace talus
