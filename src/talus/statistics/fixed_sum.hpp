#pragma once
// A fixed-point sum of 16 bytes that does not depend on the order of its terms.
//
// ExactSum keeps every bit of every term and takes 544 bytes. This one is for a sum in each cell of a map: the range of
// the terms is known there, and 2^-24 of their unit is far below what can be measured.

#include <cmath>
#include <cstdint>

#include "talus/core/bytes.hpp"
#include "talus/core/check.hpp"

namespace talus {

/// Of numbers from 0 to 2^70 (1.2e21), each truncated to a multiple of 2^-24 (6e-8); holds at least 2^32 terms of any
/// size.
class FixedSum {
 public:
  static constexpr double largest_term = 0x1p70;

  void add(double term) {
    TALUS_PROMISE(term >= 0 && term <= largest_term, "the term must be in the range of a fixed-point sum");
    const double units = term * 0x1p24;
    if (units < 0x1p63) {  // almost always
      add(0, static_cast<std::uint64_t>(static_cast<std::int64_t>(units)));
      return;
    }
    const double high = std::floor(units * 0x1p-64);
    add(static_cast<std::uint64_t>(high),
        static_cast<std::uint64_t>(units - high * 0x1p64));  // the difference is exact
  }
  /// Terms below `small_term` in units of 2^-24. The sum of `most_small_terms` of them fits into 64 bits: it can be
  /// made first and added at once.
  static constexpr float small_term = 0x1p31F;
  static constexpr std::uint32_t most_small_terms = 256;
  [[nodiscard]] static std::uint64_t units_of(float small) {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(static_cast<double>(small) * 0x1p24));
  }
  void add_units(std::uint64_t units) { add(0, units); }

  void merge(const FixedSum& other) { add(other.high_, other.low_); }
  void save(ByteWriter& out) const {
    out.put(high_);
    out.put(low_);
  }
  void merge_saved(ByteReader& in) {
    const auto high = in.get<std::uint64_t>(), low = in.get<std::uint64_t>();
    add(high, low);
  }

  /// The sum, to a double's precision.
  [[nodiscard]] double value() const {
    return (static_cast<double>(high_) * 0x1p64 + static_cast<double>(low_)) * 0x1p-24;
  }

  friend bool operator==(const FixedSum&, const FixedSum&) = default;

 private:
  void add(std::uint64_t high, std::uint64_t low) {
    low_ += low;
    high_ += high + (low_ < low ? 1 : 0);
  }

  std::uint64_t high_ = 0, low_ = 0;  // in units of 2^40 and of 2^-24
};

}  // namespace talus
