#include "talus/core/random.hpp"

#include <Random123/philox.h>

#include <bit>

namespace talus {

namespace {

// The middle of one of 2^52 equal cells of (0, 1): never 0 or 1, so that every quantile function accepts it.
double open_uniform(std::uint32_t high, std::uint32_t low) {
  const std::uint64_t bits = (static_cast<std::uint64_t>(high) << 32 | low) >> 12;
  return (static_cast<double>(bits) + 0.5) * 0x1p-52;
}

std::uint32_t low_word(std::uint64_t x) { return static_cast<std::uint32_t>(x); }
std::uint32_t high_word(std::uint64_t x) { return static_cast<std::uint32_t>(x >> 32); }

}  // namespace

std::array<std::uint32_t, 4> philox(std::uint64_t key, std::uint64_t counter, std::uint32_t high,
                                    std::uint32_t highest) {
  const auto words =
      r123::Philox4x32()({{low_word(counter), high_word(counter), high, highest}}, {{low_word(key), high_word(key)}});
  return {words[0], words[1], words[2], words[3]};
}

std::array<double, 2> uniform_pair(std::uint64_t seed, std::uint64_t rock, Stream stream, std::uint32_t index) {
  const auto words = philox(seed, rock, static_cast<std::uint32_t>(stream), index);
  return {open_uniform(words[0], words[1]), open_uniform(words[2], words[3])};
}

std::uint64_t permuted(std::uint64_t i, std::uint64_t count, std::array<std::uint32_t, 2> key) {
  if (count < 2) return 0;
  const int half_bits = (static_cast<int>(std::bit_width(count - 1)) + 1) / 2;
  const std::uint64_t mask = (std::uint64_t{1} << half_bits) - 1;
  do {
    std::uint64_t left = i >> half_bits, right = i & mask;
    for (std::uint32_t round = 0; round < 4; ++round) {
      const auto words = r123::Philox4x32()(
          {{low_word(right), high_word(right), round, static_cast<std::uint32_t>(half_bits)}}, {{key[0], key[1]}});
      const std::uint64_t mixed = (left ^ (static_cast<std::uint64_t>(words[0]) << 32 | words[1])) & mask;
      left = right;
      right = mixed;
    }
    i = left << half_bits | right;
  } while (i >= count);
  return i;
}

}  // namespace talus
