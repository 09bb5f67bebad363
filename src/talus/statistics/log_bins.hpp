#pragma once
// Counts of values in bins of nearly equal relative width, kept only where there are any: quantiles of a few quantities
// at each of very many places.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "talus/core/bytes.hpp"

namespace talus {

/// Up to four quantities, `which` in [0, 4), of values that are not negative. Counts are integers: any split and any
/// order of the values merges to the same bits.
///
/// A bin holds the values that agree in exponent and the first six bits of the fraction: its width is 1/128 to 1/64 of
/// its values, its middle at most 1/128 = 0.78 % off. Values below 2^-10 count as zero; values from 2^80 (1.2e24) on
/// fall into the last bin. A bin that holds values takes 4 bytes, 4 more for every 65535 values after the first as
/// many, and all together a quarter more for growing.
class LogBins {
 public:
  void add(std::uint32_t which, float value) { add_key(key(which, value), 1, 0); }
  /// Several at a time, which is faster: up to 65535.
  void add(std::uint32_t which, std::span<const float> values);
  /// A few values of all quantities, to be put among the entries in one go, which is faster yet where entries are many
  /// and far away in memory.
  class Batch {
   public:
    void put(std::uint32_t which, float value) { keys_.push_back(key(which, value)); }

   private:
    friend class LogBins;
    std::vector<std::uint32_t> keys_, counts_;
  };
  /// Empties the batch, of up to 65535 values.
  void add(Batch& batch);
  void merge(const LogBins& other);

  void save(ByteWriter& out) const { out.list(entries_); }
  /// Adds saved bins, and gives how many values of each quantity they hold. Throws BadBytes on what are none.
  std::array<std::uint64_t, 4> merge_saved(ByteReader& in);

  /// The quantile p in [0, 1] of one of the quantities by definition 7 (quantile.hpp), each order statistic within
  /// 0.78 %. `count`, at least 1, is how many values of this quantity were added: the caller knows it.
  [[nodiscard]] double quantile(std::uint32_t which, double p, std::uint64_t count) const;

  [[nodiscard]] std::size_t bytes() const { return entries_.capacity() * sizeof(std::uint32_t); }
  friend bool operator==(const LogBins& a, const LogBins& b) { return a.entries_ == b.entries_; }

 private:
  /// Quantity and bin: 2 and 14 bits.
  [[nodiscard]] static std::uint32_t key(std::uint32_t which, float value);
  /// Looks among the entries from `from` on, and gives the place of the key's first entry.
  std::size_t add_key(std::uint32_t key, std::uint32_t count, std::size_t from);
  void make_room(std::size_t more);
  struct Additions {
    std::size_t without_entry = 0;
    bool overflow = false;  // of the count in an entry
  };
  [[nodiscard]] Additions count_keys(Batch& batch) const;

  // Ascending; the upper 16 bits are the key, the lower ones a count of 1 to 65535. Of entries with one key all but the
  // first are full, so that there is one representation of the same counts.
  std::vector<std::uint32_t> entries_;
};

}  // namespace talus
