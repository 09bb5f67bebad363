#include "talus/statistics/exact_sum.hpp"

#include <algorithm>

namespace talus {

void ExactSum::carry() {
  for (std::size_t i = 0; i + 1 < limb_count; ++i) {
    const std::int64_t over = limbs_[i] >> limb_bits;  // rounds down, so that the remainder is not negative
    limbs_[i + 1] += over;
    limbs_[i] &= static_cast<std::int64_t>(limb_mask);
  }
  since_carry_ = 0;
}

void ExactSum::merge(const ExactSum& other) {
  carry();
  ExactSum carried = other;
  carried.carry();
  for (std::size_t i = 0; i < limb_count; ++i) limbs_[i] += carried.limbs_[i];
  carry();
}

void ExactSum::save(ByteWriter& out) const {
  ExactSum carried = *this;
  carried.carry();
  out.numbers(std::span<const std::int64_t>(carried.limbs_));
}

void ExactSum::merge_saved(ByteReader& in) {
  ExactSum saved;
  in.numbers(std::span(saved.limbs_));
  for (std::size_t i = 0; i + 1 < limb_count; ++i) {
    expect_bytes(saved.limbs_[i] >= 0 && saved.limbs_[i] <= static_cast<std::int64_t>(limb_mask), "a sum is damaged");
  }
  constexpr std::int64_t most = std::int64_t{1} << 47;  // 2^60 terms of 2^1024 give the last limb, 2^1038, 2^46
  expect_bytes(saved.limbs_.back() >= -most && saved.limbs_.back() <= most, "a sum is damaged");
  merge(saved);
}

double ExactSum::value() const {
  ExactSum magnitude = *this;
  magnitude.carry();
  const bool is_negative = magnitude.limbs_.back() < 0;
  if (is_negative) {
    for (std::int64_t& limb : magnitude.limbs_) limb = -limb;
    magnitude.carry();
  }
  const auto& limbs = magnitude.limbs_;

  std::size_t top = limb_count;
  while (top > 0 && limbs[top - 1] == 0) --top;
  if (top == 0) return 0;
  --top;
  // Bits are numbered from the lowest of limb 0; this is the highest set bit.
  const int highest = static_cast<int>(top) * static_cast<int>(limb_bits) +
                      static_cast<int>(std::bit_width(static_cast<std::uint64_t>(limbs[top]))) - 1;
  if (highest > 2097)
    return is_negative ? -HUGE_VAL : HUGE_VAL;  // beyond the largest double whatever the lower bits are

  const auto bit = [&](int i) {
    return (static_cast<std::uint64_t>(limbs[static_cast<std::size_t>(i) / limb_bits]) >>
            (static_cast<std::uint32_t>(i) % limb_bits)) &
           1u;
  };
  const int lowest = std::max(0, highest - 52);  // of the 53 bits that a double keeps
  std::uint64_t mantissa = 0;
  for (int i = highest; i >= lowest; --i) mantissa = mantissa << 1 | bit(i);
  if (lowest > 0 && bit(lowest - 1)) {
    bool is_more_than_half = false;
    for (int i = lowest - 2; i >= 0 && !is_more_than_half; --i) is_more_than_half = bit(i);
    if (is_more_than_half || (mantissa & 1u)) ++mantissa;
  }
  // Exact: at most 53 bits, or a power of two after rounding up; subnormal numbers keep all their bits.
  const double value = std::ldexp(static_cast<double>(mantissa), lowest - 1074);
  return is_negative ? -value : value;
}

std::array<double, 5> ExactSum::leading() const {
  std::array<double, 5> parts{};
  ExactSum rest = *this;
  for (double& part : parts) {
    part = rest.value();
    if (!std::isfinite(part)) break;
    rest.add(-part);
  }
  return parts;
}

}  // namespace talus
