#pragma once
// Counts of values in bins of nearly equal relative width, kept only where there are any: quantiles of a few quantities
// at each of very many places.

#include <array>
#include <cstdint>
#include <vector>

#include "talus/core/bytes.hpp"

namespace talus {

/// Up to four quantities, `which` in [0, 4), of values that are not negative. Counts are integers: any split and any
/// order of the values merges to the same bits.
///
/// A bin holds the values that agree in exponent and the first six bits of the fraction: its width is 1/128 to 1/64 of
/// its values, its middle at most 1/128 = 0.78 % off. Values below 2^-10 count as zero; values from 2^80 (1.2e24) on
/// fall into the last bin. A bin that holds values takes 4 bytes, 4 more for every 65535 values after the first as
/// many, and all together a third more for growing.
class LogBins {
 public:
  void add(std::uint32_t which, float value) { append(key(which, value) << count_bits | 1); }
  void merge(const LogBins& other);
  /// Counts what was added lately among the rest. What is asked does so for itself, each time, where this was not done.
  void settle();

  void save(ByteWriter& out) const;
  /// Adds saved bins, and gives how many values of each quantity they hold. Throws BadBytes on what are none.
  std::array<std::uint64_t, 4> merge_saved(ByteReader& in);

  /// The quantile p in [0, 1] of one of the quantities by definition 7 (quantile.hpp), each order statistic within
  /// 0.78 %. `count`, at least 1, is how many values of this quantity were added: the caller knows it.
  [[nodiscard]] double quantile(std::uint32_t which, double p, std::uint64_t count) const;

  [[nodiscard]] std::size_t bytes() const { return entries_.capacity() * sizeof(std::uint32_t); }
  friend bool operator==(const LogBins& a, const LogBins& b);

 private:
  static constexpr std::uint32_t count_bits = 16;

  /// Quantity and bin: 2 and 14 bits.
  [[nodiscard]] static std::uint32_t key(std::uint32_t which, float value);
  [[nodiscard]] LogBins settled() const;
  [[nodiscard]] bool is_settled() const { return settled_ == entries_.size(); }
  void append(std::uint32_t entry) {
    if (entries_.size() == entries_.capacity()) make_room();
    entries_.push_back(entry);
  }
  void make_room();

  // The upper 16 bits of an entry are the key, the lower ones a count of 1 to 65535. The first entries are settled:
  // ascending, and of those with one key all but the first are full, so that there is one representation of the same
  // counts. After them come the latest in the order in which they were added, so that to add a value touches one place
  // in memory; they are settled when there are half as many as before.
  std::vector<std::uint32_t> entries_;
  std::uint32_t settled_ = 0;
};

}  // namespace talus
