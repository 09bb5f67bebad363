#pragma once
// Which rocks are kept if a store cannot have all: an order of the rocks by their numbers and the seed alone. The first
// rocks in this order, however many, are a fair sample of all.

#include <cstdint>

namespace talus {

/// SplitMix64: Steele, Lea and Flood, "Fast splittable pseudorandom number generators", OOPSLA 2014.
[[nodiscard]] inline std::uint64_t mixed_bits(std::uint64_t x) {
  x = (x + 1) * 0x9E3779B97F4A7C15U;
  x = (x ^ (x >> 30U)) * 0xBF58476D1CE4E5B9U;
  x = (x ^ (x >> 27U)) * 0x94D049BB133111EBU;
  return x ^ (x >> 31U);
}

/// The place of a rock in the order; the lowest comes first.
///
/// Rocks compete as in a knock-out: of the rocks 2k and 2k + 1 a pseudorandom one gets into the next round, of the two
/// winners among 4k to 4k + 3 again one, and so on. A rock that gets into round n comes before all that do not. So the
/// first rocks in this order have one of every 2^n with consecutive numbers, each with the same chance: every seeder,
/// line and source has its share (stratified sampling: Cochran, Sampling Techniques, chapter 5), and periodic releases,
/// such as cells row by row, do not interfere. Rocks that get equally far come in pseudorandom order.
[[nodiscard]] inline std::uint64_t place_in_choice(std::uint64_t seed, std::uint64_t rock) {
  constexpr std::uint64_t most_rounds = 63;
  constexpr unsigned order_bits = 58;  // below the six bits of the rounds
  const std::uint64_t key = mixed_bits(seed);
  std::uint64_t rounds = 0;
  for (std::uint64_t left = rock; rounds < most_rounds; ++rounds, left >>= 1U) {
    const std::uint64_t pair = mixed_bits((left >> 1U) ^ mixed_bits(key + rounds));
    if ((pair & 1U) != (left & 1U)) break;
  }
  return ((most_rounds - rounds) << order_bits) | (mixed_bits(rock ^ key) >> (64 - order_bits));
}

}  // namespace talus
