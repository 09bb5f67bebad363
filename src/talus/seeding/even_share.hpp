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

}  // namespace talus
