#pragma once
// Two doubles in one register, which every 64-bit processor has; the compiler makes one instruction of each operation.

namespace talus {

using Pair = double __attribute__((vector_size(16)));
/// The result of a comparison: all bits set, or none.
using PairMask = decltype(Pair{} < Pair{});

[[nodiscard]] inline Pair pair(double x) { return Pair{x, x}; }
[[nodiscard]] inline Pair swapped(Pair x) { return Pair{x[1], x[0]}; }
/// x where the mask is set, else 0.
[[nodiscard]] inline Pair chosen(PairMask mask, Pair x) {
  return reinterpret_cast<Pair>(mask & reinterpret_cast<PairMask>(x));
}

}  // namespace talus
