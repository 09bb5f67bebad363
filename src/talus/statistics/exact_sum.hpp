#pragma once
// A sum of doubles without rounding: it does not depend on the order of the terms, nor on their split over threads,
// ranks and shards.
//
// Source: R. M. Neal, "Fast exact summation using small and large superaccumulators", arXiv:1505.05571 (2015), section
// 3: a fixed-point number that covers the whole range of a double, in 64-bit limbs that represent 32 bits each. The
// upper half of a limb gathers carries, which are passed on only once in 2^30 terms: a term costs three additions.

#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstdint>

#include "talus/core/bytes.hpp"
#include "talus/core/check.hpp"

namespace talus {

/// Exact for finite terms, up to 2^60 of them. Plain data: may be copied bitwise to another process.
class ExactSum {
 public:
  /// Expects a finite number.
  void add(double term) {
    TALUS_PROMISE(std::isfinite(term), "only finite numbers can be summed");
    const auto bits = std::bit_cast<std::uint64_t>(term);
    const auto exponent = static_cast<std::uint32_t>(bits >> 52) & 0x7FFu;
    const std::uint64_t fraction = bits & ((std::uint64_t{1} << 52) - 1);
    // A subnormal number has the exponent of the smallest normal one, without the leading bit.
    const std::uint32_t is_normal = exponent != 0;
    const std::uint64_t mantissa = fraction | std::uint64_t{is_normal} << 52;
    const std::uint32_t lowest_bit = exponent - is_normal;
    const std::uint32_t shift = lowest_bit % limb_bits;
    std::int64_t* limb = limbs_.data() + lowest_bit / limb_bits;
    const std::uint64_t low = mantissa << shift;
    const std::uint64_t high =
        (mantissa >> 1) >> (63 - shift);  // the bits that `low` lost; a shift by 64 would be undefined
    const auto flip = -static_cast<std::int64_t>(bits >> 63);  // (x ^ flip) - flip is -x for negative terms
    // The fences cost no instruction. They keep the compiler from joining two limbs into one vector: the next term
    // often reads one of the two, and a processor cannot forward half of a store it has not finished (measured: twice
    // the time).
    limb[0] += (static_cast<std::int64_t>(low & limb_mask) ^ flip) - flip;
    std::atomic_signal_fence(std::memory_order_seq_cst);
    limb[1] += (static_cast<std::int64_t>(low >> limb_bits) ^ flip) - flip;
    std::atomic_signal_fence(std::memory_order_seq_cst);
    limb[2] += (static_cast<std::int64_t>(high) ^ flip) - flip;
    if (++since_carry_ == most_without_carry) carry();
  }

  void merge(const ExactSum& other);

  /// Equal sums give equal bytes, whatever their terms were.
  void save(ByteWriter& out) const;
  /// Adds a saved sum; throws BadBytes on anything else.
  void merge_saved(ByteReader& in);

  /// The double nearest to the sum, ties to even; infinite if the sum lies beyond the largest double.
  [[nodiscard]] double value() const;

  /// The sum as doubles that do not overlap, largest first: at least 265 leading bits of it.
  [[nodiscard]] std::array<double, 5> leading() const;

  /// Whether the two sums are equal.
  [[nodiscard]] friend bool operator==(ExactSum a, ExactSum b) {
    a.carry();
    b.carry();
    return a.limbs_ == b.limbs_;
  }

 private:
  static constexpr std::uint32_t limb_bits = 32;
  static constexpr std::uint64_t limb_mask = 0xFFFFFFFFu;
  static constexpr std::uint32_t most_without_carry = 1u << 30;
  // Bit 0 of limb 0 is worth 2^-1074. The largest double ends at bit 2097; 67 limbs leave 78 bits above it.
  static constexpr std::size_t limb_count = 67;

  /// Afterwards each limb but the last, which has the sign, is in [0, 2^32): each number has one representation.
  void carry();

  std::array<std::int64_t, limb_count> limbs_{};
  std::uint32_t since_carry_ = 0;  // terms, at most, in the upper halves of the limbs
};

}  // namespace talus
