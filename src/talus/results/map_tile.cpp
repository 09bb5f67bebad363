#include "talus/results/map_tile.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "talus/core/check.hpp"

namespace talus {

std::uint64_t MapTally::passages() const { return tile_->counts_[number_].passages; }
std::uint64_t MapTally::deposits() const { return tile_->counts_[number_].deposits; }
std::uint64_t MapTally::impacts() const { return tile_->counts_[number_].impacts; }

double MapTally::maximum(MapQuantity quantity) const {
  const auto place = tile_->contents_.place(quantity);
  TALUS_PROMISE(place, "only gathered quantities can be asked for");
  return tile_->maxima_[number_ * tile_->contents_.quantities() + *place];
}

double MapTally::mean(MapQuantity quantity) const {
  const auto place = tile_->contents_.place(quantity);
  TALUS_PROMISE(place && tile_->contents_.has_means(), "only gathered quantities can be asked for");
  return tile_->sums_[number_ * tile_->contents_.quantities() + *place].value() / static_cast<double>(passages());
}

void MapTally::percentiles(MapQuantity quantity, std::span<const double> percents, std::span<double> out) const {
  const auto which = tile_->contents_.place_of_percentiles(quantity);
  TALUS_PROMISE(which, "only gathered quantities can be asked for");
  if (passages() == 1) {
    std::ranges::fill(out, maximum(quantity));
    return;
  }
  constexpr std::size_t at_once = 16;
  std::array<double, at_once> probabilities;
  const double maximum_value = maximum(quantity);
  for (std::size_t first = 0; first < percents.size(); first += at_once) {
    const std::size_t count = std::min(at_once, percents.size() - first);
    for (std::size_t k = 0; k < count; ++k) probabilities[k] = percents[first + k] / 100;
    const std::span<double> part = out.subspan(first, count);
    tile_->bins_.quantiles(number_, *which, passages(), std::span(probabilities).first(count), part);
    for (double& value : part) value = std::min(value, maximum_value);
  }
}

bool operator==(const MapTally& a, const MapTally& b) {
  const MapTile &left = *a.tile_, &right = *b.tile_;
  if (!(left.contents_ == right.contents_) || !(left.counts_[a.number_] == right.counts_[b.number_])) return false;
  const std::size_t quantities = left.contents_.quantities();
  for (std::size_t k = 0; k < quantities; ++k) {
    const std::size_t at_left = a.number_ * quantities + k, at_right = b.number_ * quantities + k;
    if (left.maxima_[at_left] != right.maxima_[at_right]) return false;
    if (left.contents_.has_means() && !(left.sums_[at_left] == right.sums_[at_right])) return false;
  }
  if (left.contents_.with_percentiles() == 0) return true;
  return BinCounts::are_same(left.bins_, a.number_, right.bins_, b.number_);
}

std::uint32_t MapTile::number_at(std::uint32_t place) {
  std::uint16_t& there = places_[place];
  if (there == 0) {
    // Grows by a quarter: doubling would waste too much of what is kept for each cell.
    const std::size_t cells = counts_.size(), more = cells + std::max<std::size_t>(16, cells / 4);
    const std::size_t room = std::min<std::size_t>(map_tiles::cells, more);
    if (cells == counts_.capacity()) {
      counts_.reserve(room);
      maxima_.reserve(room * contents_.quantities());
      if (contents_.has_means()) sums_.reserve(room * contents_.quantities());
    }
    counts_.emplace_back();
    maxima_.resize(maxima_.size() + contents_.quantities());
    if (contents_.has_means()) sums_.resize(sums_.size() + contents_.quantities());
    if (contents_.with_percentiles() > 0) bins_.new_place();
    there = static_cast<std::uint16_t>(counts_.size());
  }
  return there - 1U;
}

std::span<float> MapTile::maxima_of(std::uint32_t number) {
  return std::span(maxima_).subspan(std::size_t{number} * contents_.quantities(), contents_.quantities());
}

void MapTile::put_in_bins(std::uint32_t number, std::span<const float> values) {
  if (contents_.with_percentiles() == 0) return;
  BinCounts::Adder bins = bins_.at(number);
  for (std::uint32_t k = 0; k < values.size(); ++k) {
    const auto which = contents_.place_of_percentiles(contents_.quantity(k));
    if (which) bins.add(*which, values[k]);
  }
}

void MapTile::add_rocks(std::uint32_t number, std::uint64_t passages, std::span<const float> maxima) {
  Counts& counts = counts_[number];
  const std::span<float> known = maxima_of(number);
  if (counts.passages == 1) put_in_bins(number, known);
  if (counts.passages > 0 && passages == 1) put_in_bins(number, maxima);
  counts.passages += passages;
  for (std::size_t k = 0; k < maxima.size(); ++k) known[k] = std::max(known[k], maxima[k]);
}

template <std::uint32_t quantities, bool has_means>
void MapTile::add(std::uint32_t number, std::span<const PackedVisit> visits) {
  Counts& counts = counts_[number];
  if (counts.passages == 1) put_in_bins(number, maxima_of(number));
  counts.passages += visits.size();
  std::array<float, quantities> maxima{};
  std::array<std::uint64_t, quantities> units{};
  FixedSum* const sums = has_means ? sums_.data() + std::size_t{number} * quantities : nullptr;
  for (const PackedVisit& visit : visits) {
    counts.deposits += visit.is_deposit() ? 1 : 0;
    counts.impacts += visit.impacts();
    for (std::uint32_t k = 0; k < quantities; ++k) {
      const float value = visit.value(k);
      maxima[k] = std::max(maxima[k], value);
      if constexpr (!has_means) continue;
      if (value < FixedSum::small_term) {
        units[k] += FixedSum::units_of(value);
      } else {
        sums[k].add(static_cast<double>(value));
      }
    }
  }
  for (std::uint32_t k = 0; k < quantities; ++k) {
    float& known = maxima_[std::size_t{number} * quantities + k];
    known = std::max(known, maxima[k]);
    if constexpr (has_means) sums[k].add_units(units[k]);
  }
  if (contents_.with_percentiles() == 0 || counts.passages == 1) return;
  BinCounts::Adder bins = bins_.at(number);
  for (std::uint32_t k = 0; k < quantities; ++k) {
    const auto which = contents_.place_of_percentiles(contents_.quantity(k));
    if (!which) continue;
    for (const PackedVisit& visit : visits) bins.add(*which, visit.value(k));
  }
}

template <bool has_means>
void MapTile::add(std::uint32_t number, std::span<const PackedVisit> visits) {
  static_assert(map_quantity_count == 4 && map_quantity_count <= BinCounts::most_quantities);
  switch (contents_.quantities()) {
    case 0:
      return add<0, has_means>(number, visits);
    case 1:
      return add<1, has_means>(number, visits);
    case 2:
      return add<2, has_means>(number, visits);
    case 3:
      return add<3, has_means>(number, visits);
    default:
      return add<4, has_means>(number, visits);
  }
}

void MapTile::add(std::uint32_t number, std::span<const PackedVisit> visits) {
  return contents_.has_means() ? add<true>(number, visits) : add<false>(number, visits);
}

/// Cell by cell, so that the data of a cell are fetched once: half the time of the order of arrival.
void MapTile::add_waiting() {
  const std::size_t words = 1 + contents_.quantities();
  std::array<std::uint32_t, map_tiles::cells + 1> ends{};
  std::size_t total = 0;
  for (const VisitRun& run : waiting_) {
    for (std::size_t k = 0; k < run.count; ++k) ++ends[PackedVisit{run.words + k * words}.place() + 1];
    total += run.count;
  }
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  thread_local std::vector<PackedVisit> sorted;
  sorted.resize(total);
  for (const VisitRun& run : waiting_) {
    for (std::size_t k = 0; k < run.count; ++k) {
      const PackedVisit visit{run.words + k * words};
      sorted[ends[visit.place()]++] = visit;
    }
  }
  waiting_ = std::vector<VisitRun>();
  std::uint32_t first = 0;
  for (std::uint32_t place = 0; place < map_tiles::cells; ++place) {
    const std::uint32_t end = ends[place];
    while (first < end) {
      const std::uint32_t count = std::min<std::uint32_t>(end - first, FixedSum::most_small_terms);
      add(number_at(place), std::span(sorted).subspan(first, count));
      first += count;
    }
  }
  bins_.settle_if_due();
}

void MapTile::merge(const MapTile& other) {
  TALUS_PROMISE(contents_ == other.contents_, "only tiles with the same contents can be merged");
  const std::size_t quantities = contents_.quantities();
  for (std::uint32_t place = 0; place < map_tiles::cells; ++place) {
    if (other.places_[place] == 0) continue;
    const std::uint32_t from = other.places_[place] - 1U, to = number_at(place);
    counts_[to].deposits += other.counts_[from].deposits;
    counts_[to].impacts += other.counts_[from].impacts;
    add_rocks(to, other.counts_[from].passages, std::span(other.maxima_).subspan(from * quantities, quantities));
    if (contents_.has_means()) {
      for (std::size_t k = 0; k < quantities; ++k) sums_[to * quantities + k].merge(other.sums_[from * quantities + k]);
    }
    if (contents_.with_percentiles() > 0) bins_.merge(to, other.bins_, from);
  }
  settle();
}

void MapTile::save(ByteWriter& out) const {
  const std::size_t quantities = contents_.quantities();
  out.count(counts_.size());
  for (std::uint16_t place = 0; place < map_tiles::cells; ++place) {
    if (places_[place] == 0) continue;
    const std::uint32_t number = places_[place] - 1U;
    out.put(place);
    out.put(counts_[number].passages);
    out.put(counts_[number].deposits);
    out.put(counts_[number].impacts);
    for (std::size_t k = 0; k < quantities; ++k) {
      out.put(maxima_[number * quantities + k]);
      if (contents_.has_means()) sums_[number * quantities + k].save(out);
    }
    if (contents_.with_percentiles() > 0) bins_.save(number, out);
  }
}

void MapTile::merge_saved(ByteReader& in, std::uint64_t rocks) {
  constexpr const char* damaged = "a cell of maps is damaged";
  const std::size_t quantities = contents_.quantities();
  const std::size_t cells = in.count(least_saved);
  expect_bytes(cells > 0, damaged);
  std::optional<std::uint16_t> before;
  for (std::size_t cell = 0; cell < cells; ++cell) {
    const auto place = in.get<std::uint16_t>();
    expect_bytes(place < map_tiles::cells && (!before || *before < place), damaged);
    before = place;
    const std::uint32_t number = number_at(place);
    const auto passages = in.get<std::uint64_t>(), deposits = in.get<std::uint64_t>();
    expect_bytes(passages > 0 && deposits <= passages, damaged);
    Counts& counts = counts_[number];
    counts.deposits += deposits;
    counts.impacts += in.get<std::uint64_t>();
    std::array<float, map_quantity_count> maxima{};
    for (std::size_t k = 0; k < quantities; ++k) {
      maxima[k] = in.get<float>();
      expect_bytes(maxima[k] >= 0 && std::isfinite(maxima[k]), damaged);
      if (contents_.has_means()) sums_[number * quantities + k].merge_saved(in);
    }
    add_rocks(number, passages, std::span(maxima).first(quantities));
    expect_bytes(counts.passages <= rocks, damaged);
    if (contents_.with_percentiles() == 0) continue;
    const std::uint64_t max_in_bins = passages == 1 ? 0 : passages;
    for (const std::uint64_t values : bins_.merge_saved(number, in)) expect_bytes(values <= max_in_bins, damaged);
  }
}

std::size_t MapTile::bytes() const {
  return sizeof(*this) + counts_.capacity() * sizeof(Counts) + maxima_.capacity() * sizeof(float) +
         sums_.capacity() * sizeof(FixedSum) + bins_.bytes() + waiting_.capacity() * sizeof(VisitRun);
}

}  // namespace talus
