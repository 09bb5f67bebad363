#pragma once
// Rocks shared evenly among places, in order.

#include <cstddef>
#include <cstdint>

namespace talus {

/// The place of rock k of n among `places`: floor(k places / n). Every place has floor(n / places) rocks or one more,
/// for any seed.
[[nodiscard]] inline std::size_t place_of_share(std::uint64_t k, std::uint64_t n, std::size_t places) {
  __extension__ using Wide = unsigned __int128;  // k places has up to 72 bits
  return static_cast<std::size_t>(Wide{k} * places / n);
}

/// The first of the n rocks at a place, or at the next one that has any; n for the number of places.
[[nodiscard]] inline std::uint64_t first_at_share(std::size_t place, std::uint64_t n, std::size_t places) {
  __extension__ using Wide = unsigned __int128;
  return static_cast<std::uint64_t>((Wide{place} * n + places - 1) / places);
}

}  // namespace talus
