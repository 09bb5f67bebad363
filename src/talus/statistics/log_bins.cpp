#include "talus/statistics/log_bins.hpp"

#include <algorithm>
#include <bit>
#include <utility>

#include "talus/core/check.hpp"
#include "talus/statistics/quantile.hpp"

namespace talus {

namespace {

constexpr std::uint32_t dropped_bits = 17;  // of the 23 of the fraction
constexpr std::uint32_t which_shift = 14;   // a bin's number takes the 8 bits of the exponent and 6 of the fraction
constexpr float least = 0x1p-10f;
constexpr float most = 0x1p80f;

/// A count for each key, and which keys have one, told by bits and by bits of words of bits: a sort without
/// comparisons, of whose half a megabyte the values of one place touch a few kilobytes.
class KeyCounts {
 public:
  void add(std::uint32_t key, std::uint32_t count) {
    counts_[key] += count;
    words_[key >> 6] |= bit(key);
    groups_[key >> 12] |= bit(key >> 6);
  }
  /// Calls take(key, count) for the keys in ascending order, and leaves nothing.
  template <class Take>
  void take_all(Take&& take) {
    for (std::uint32_t group = 0; group < groups_.size(); ++group) {
      take_bits(groups_[group], group, [&](std::uint32_t word) {
        take_bits(words_[word], word, [&](std::uint32_t key) { take(key, std::exchange(counts_[key], 0)); });
      });
    }
  }

 private:
  static std::uint64_t bit(std::uint32_t k) { return std::uint64_t{1} << (k & 63); }
  template <class Take>
  static void take_bits(std::uint64_t& word, std::uint32_t upper, Take&& take) {
    for (std::uint64_t bits = std::exchange(word, 0); bits != 0; bits &= bits - 1) {
      take(upper << 6 | static_cast<std::uint32_t>(std::countr_zero(bits)));
    }
  }

  std::array<std::uint64_t, 1 << 16> counts_{};
  std::array<std::uint64_t, 1 << 10> words_{};
  std::array<std::uint64_t, 1 << 4> groups_{};
};

constexpr std::uint32_t full = 0xFFFF;  // the most that an entry can count
std::uint32_t count_of(std::uint32_t entry) { return entry & full; }

double middle_of(std::uint32_t key) {
  const std::uint32_t bin = key & ((1U << which_shift) - 1);
  if (bin == 0) return 0;
  return static_cast<double>(std::bit_cast<float>(bin << dropped_bits | 1U << (dropped_bits - 1)));
}

}  // namespace

std::uint32_t LogBins::key(std::uint32_t which, float value) {
  TALUS_PROMISE(which < 4 && value >= 0, "there are four quantities, none of them negative");
  const std::uint32_t bin = value < least ? 0 : std::bit_cast<std::uint32_t>(std::min(value, most)) >> dropped_bits;
  return which << which_shift | bin;
}

void LogBins::make_room() {
  constexpr std::size_t few = 64;
  if (entries_.size() - settled_ >= std::max<std::size_t>(few, settled_ / 2)) settle();
  const std::size_t size = entries_.size();
  if (size == entries_.capacity()) entries_.reserve(size + std::max<std::size_t>(4, size < 128 ? size / 2 : size / 4));
}

void LogBins::merge(const LogBins& other) {
  for (const std::uint32_t entry : other.entries_) append(entry);
}

void LogBins::settle() {
  if (is_settled()) return;
  thread_local KeyCounts counts;  // empty between calls
  for (const std::uint32_t entry : entries_) counts.add(entry >> count_bits, count_of(entry));
  entries_.clear();
  counts.take_all([&](std::uint32_t key, std::uint64_t count) {
    const std::uint64_t in_first = (count - 1) % full + 1;
    entries_.push_back(key << count_bits | static_cast<std::uint32_t>(in_first));
    for (count -= in_first; count > 0; count -= full) entries_.push_back(key << count_bits | full);
  });
  settled_ = static_cast<std::uint32_t>(entries_.size());
}

LogBins LogBins::settled() const {
  LogBins bins = *this;
  bins.settle();
  return bins;
}

void LogBins::save(ByteWriter& out) const { out.list(is_settled() ? entries_ : settled().entries_); }

bool operator==(const LogBins& a, const LogBins& b) { return a.settled().entries_ == b.settled().entries_; }

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
    settled_ = static_cast<std::uint32_t>(entries_.size());
  } else {
    merge(saved);
  }
  return counts;
}

double LogBins::quantile(std::uint32_t which, double p, std::uint64_t count) const {
  if (!is_settled()) return settled().quantile(which, p, count);
  const auto [rank, fraction] = quantile_place(p, count);
  auto entry = std::lower_bound(entries_.begin(), entries_.end(), which << (which_shift + count_bits));
  std::uint64_t before = 0;  // values in the bins before
  while (before + count_of(*entry) <= rank) before += count_of(*entry++);
  const double low = middle_of(*entry >> count_bits);
  if (fraction == 0) return low;
  if (before + count_of(*entry) <= rank + 1) ++entry;
  return between(low, middle_of(*entry >> count_bits), fraction);
}

}  // namespace talus
