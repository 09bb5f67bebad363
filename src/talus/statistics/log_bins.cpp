#include "talus/statistics/log_bins.hpp"

#include <algorithm>
#include <bit>
#include <boost/sort/pdqsort/pdqsort.hpp>

#include "talus/core/check.hpp"
#include "talus/statistics/quantile.hpp"

namespace talus {

namespace {

constexpr std::uint32_t dropped_bits = 17;  // of the 23 of the fraction
constexpr std::uint32_t which_shift = 14;   // a bin's number takes the 8 bits of the exponent and 6 of the fraction
constexpr std::uint32_t count_bits = 16;
constexpr std::uint32_t full = (1U << count_bits) - 1;
constexpr float least = 0x1p-10f;
constexpr float most = 0x1p80f;

std::uint32_t count_of(std::uint32_t entry) { return entry & full; }

double middle_of(std::uint32_t entry) {
  const std::uint32_t bin = entry >> count_bits & ((1U << which_shift) - 1);
  if (bin == 0) return 0;
  return static_cast<double>(std::bit_cast<float>(bin << dropped_bits | 1U << (dropped_bits - 1)));
}

}  // namespace

std::uint32_t LogBins::key(std::uint32_t which, float value) {
  TALUS_PROMISE(which < 4 && value >= 0, "there are four quantities, none of them negative");
  const std::uint32_t bin = value < least ? 0 : std::bit_cast<std::uint32_t>(std::min(value, most)) >> dropped_bits;
  return which << which_shift | bin;
}

std::size_t LogBins::add_key(std::uint32_t key, std::uint32_t count, std::size_t from) {
  const auto first = entries_.begin() + static_cast<std::ptrdiff_t>(from);
  const auto place = std::lower_bound(first, entries_.end(), key << count_bits);
  const auto index = static_cast<std::size_t>(place - entries_.begin());
  std::uint32_t added = key << count_bits | count;
  if (place != entries_.end() && *place >> count_bits == key) {
    const std::uint32_t together = count_of(*place) + count;
    if (together <= full) {
      *place += count;
      return index;
    }
    *place += full - count_of(*place);
    added = key << count_bits | (together - full);
  }
  make_room(1);
  entries_.insert(entries_.begin() + static_cast<std::ptrdiff_t>(index), added);
  return index;
}

void LogBins::add(std::uint32_t which, std::span<const float> values) {
  TALUS_PROMISE(values.size() <= full, "an entry can count them");
  constexpr std::size_t few = 8;          // these are added one by one
  std::array<std::uint32_t, 512> counts;  // of the bins from the least of the values on
  std::uint32_t least_key = ~0U, most_key = 0;
  for (const float value : values) {
    const std::uint32_t each = key(which, value);
    least_key = std::min(least_key, each);
    most_key = std::max(most_key, each);
  }
  if (values.size() < few || most_key - least_key >= counts.size()) {
    for (const float value : values) add(which, value);
    return;
  }
  const std::size_t bins = most_key - least_key + 1;
  std::fill_n(counts.begin(), bins, 0);
  for (const float value : values) ++counts[key(which, value) - least_key];
  std::size_t place = 0;
  for (std::uint32_t k = 0; k < bins; ++k) {
    if (counts[k] > 0) place = add_key(least_key + k, counts[k], place);
  }
}

void LogBins::make_room(std::size_t more) {
  const std::size_t needed = entries_.size() + more;
  if (needed > entries_.capacity()) entries_.reserve(needed + std::max<std::size_t>(4, needed / 4));
}

/// Makes of the batch's keys, sorted, those that differ and how often each is there.
auto LogBins::count_keys(Batch& batch) const -> Additions {
  std::vector<std::uint32_t>& keys = batch.keys_;
  batch.counts_.clear();
  Additions additions;
  auto entry = entries_.begin();
  std::size_t different = 0;
  for (std::size_t k = 0; k < keys.size();) {
    const std::uint32_t key = keys[k];
    std::uint32_t count = 0;
    for (; k < keys.size() && keys[k] == key; ++k) ++count;
    while (entry != entries_.end() && *entry >> count_bits < key) ++entry;
    if (entry == entries_.end() || *entry >> count_bits != key) {
      ++additions.without_entry;
    } else if (count_of(*entry) + count > full) {
      additions.overflow = true;
    }
    keys[different++] = key;
    batch.counts_.push_back(count);
  }
  keys.resize(different);
  return additions;
}

void LogBins::add(Batch& batch) {
  std::vector<std::uint32_t>& keys = batch.keys_;
  TALUS_PROMISE(keys.size() <= full, "an entry can count them");
  boost::sort::pdqsort_branchless(keys.begin(), keys.end());
  const auto [without_entry, overflow] = count_keys(batch);
  constexpr std::size_t sparse = 16;  // entries a key, from which on each finds its own place sooner
  if (overflow || sparse * keys.size() < entries_.size()) {
    for (std::size_t k = 0; k < keys.size(); ++k) add_key(keys[k], batch.counts_[k], 0);
  } else {
    // From the last one on, so that each entry is moved once.
    std::size_t from = entries_.size(), to = from + without_entry;
    make_room(without_entry);
    entries_.resize(to);
    const auto move_one = [&] { entries_[--to] = entries_[--from]; };
    for (std::size_t k = keys.size(); k-- > 0;) {
      const std::uint32_t key = keys[k];
      while (from > 0 && entries_[from - 1] >> count_bits > key) move_one();
      while (from > 1 && entries_[from - 2] >> count_bits == key) move_one();  // the full ones of this key
      if (from > 0 && entries_[from - 1] >> count_bits == key) {
        entries_[--to] = entries_[--from] + batch.counts_[k];
      } else {
        entries_[--to] = key << count_bits | batch.counts_[k];
      }
    }
  }
  keys.clear();
}

void LogBins::merge(const LogBins& other) {
  for (const std::uint32_t entry : other.entries_) add_key(entry >> count_bits, count_of(entry), 0);
}

std::array<std::uint64_t, 4> LogBins::merge_saved(ByteReader& in) {
  constexpr const char* damaged = "counts in bins are damaged";
  constexpr std::uint32_t first_bin = std::bit_cast<std::uint32_t>(least) >> dropped_bits;
  constexpr std::uint32_t last_bin = std::bit_cast<std::uint32_t>(most) >> dropped_bits;
  LogBins saved;
  saved.entries_ = in.list<std::uint32_t>();
  std::array<std::uint64_t, 4> counts{};
  std::uint32_t before = 0;
  for (std::size_t k = 0; k < saved.entries_.size(); ++k) {
    const std::uint32_t entry = saved.entries_[k], entry_key = entry >> count_bits;
    const std::uint32_t bin = entry_key & ((1U << which_shift) - 1);
    expect_bytes(bin == 0 || (bin >= first_bin && bin <= last_bin), damaged);
    expect_bytes(k == 0 || entry_key > before || (entry_key == before && count_of(entry) == full), damaged);
    expect_bytes(count_of(entry) > 0, damaged);
    counts[entry_key >> which_shift] += count_of(entry);
    before = entry_key;
  }
  if (entries_.empty()) {
    entries_ = std::move(saved.entries_);
  } else {
    merge(saved);
  }
  return counts;
}

double LogBins::quantile(std::uint32_t which, double p, std::uint64_t count) const {
  const auto [rank, fraction] = quantile_place(p, count);
  auto entry = std::lower_bound(entries_.begin(), entries_.end(), which << (which_shift + count_bits));
  std::uint64_t before = 0;  // values in the bins before
  while (before + count_of(*entry) <= rank) before += count_of(*entry++);
  const double low = middle_of(*entry);
  if (fraction == 0) return low;
  if (before + count_of(*entry) <= rank + 1) ++entry;
  return between(low, middle_of(*entry), fraction);
}

}  // namespace talus
