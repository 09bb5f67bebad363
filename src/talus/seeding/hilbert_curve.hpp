#pragma once
// An order of places on plan in which neighbours in the order are neighbours on plan.

#include <cstdint>
#include <utility>

namespace talus {

/// The place of a cell along Hilbert's curve through a square grid of 2^32 by 2^32 cells (H. S. Warren, Hacker's
/// Delight, 2nd edition, 2013, chapter 16).
[[nodiscard]] inline std::uint64_t along_hilbert_curve(std::uint32_t column, std::uint32_t row) {
  std::uint64_t along = 0;
  for (int bit = 31; bit >= 0; --bit) {
    const bool is_right = (column >> bit & 1U) != 0, is_above = (row >> bit & 1U) != 0;
    along = along << 2U | (is_above ? (is_right ? 2U : 1U) : (is_right ? 3U : 0U));
    if (is_above) continue;
    if (is_right) {
      column = ~column;
      row = ~row;
    }
    std::swap(column, row);
  }
  return along;
}

}  // namespace talus
