#pragma once
// Two doubles side by side: what every 64-bit processor has registers for, and what the compiler turns into one
// instruction each.

namespace talus {

using Pair = double __attribute__((vector_size(16)));
/// Of a comparison: all bits set, or none.
using PairMask = decltype(Pair{} < Pair{});

[[nodiscard]] inline Pair pair(double x) { return Pair{x, x}; }
[[nodiscard]] inline Pair swapped(Pair x) { return Pair{x[1], x[0]}; }
/// x where the mask is set, 0 where it is not.
[[nodiscard]] inline Pair chosen(PairMask mask, Pair x) {
  return reinterpret_cast<Pair>(mask & reinterpret_cast<PairMask>(x));
}

}  // namespace talus
