#include "talus/statistics/counted_draws.hpp"

#include "talus/core/random.hpp"

namespace talus {

std::uint64_t CountedDraws::bits(std::uint64_t row, std::uint32_t column) const {
  const auto words = philox(seed_, row, static_cast<std::uint32_t>(purpose_), column);
  return static_cast<std::uint64_t>(words[0]) << 32 | words[1];
}

std::size_t CountedDraws::below(std::size_t count, std::uint64_t row, std::uint32_t column) const {
  __extension__ using Wide = unsigned __int128;
  return static_cast<std::size_t>(static_cast<Wide>(bits(row, column)) * count >> 64);
}

}  // namespace talus
