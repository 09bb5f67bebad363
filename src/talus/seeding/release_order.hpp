#pragma once
// The order in which the places of a seeder release its rocks: any first rocks are spread evenly over all places.

#include <cstdint>

namespace talus {

/// Turn t is that of the place (start + t step) modulo their number, a lattice of rank one (H. Niederreiter, Random
/// Number Generation and Quasi-Monte Carlo Methods, 1992, chapter 5). All places have a turn before any has its next,
/// so each has floor(t / places) of t turns or one more. With neighbouring places next to each other in their order
/// (hilbert_curve.hpp), the first t turns leave no gap on plan (Z. He, A. B. Owen, "Extensible grids: uniform sampling
/// on a space filling curve", Journal of the Royal Statistical Society B 78, 2016, 917-931). With a uniform start each
/// turn has each place with equal probability, so means over any first turns are unbiased over seeds.
struct ReleaseOrder {
  std::uint64_t first_rock = 0, rocks = 0;
  /// Consecutive rocks that share a turn: one of each ensemble, so that all ensembles have the same places.
  std::uint64_t rocks_at_once = 1;
  std::uint64_t places = 1;
  std::uint64_t step = 1, start = 0;  // below the number of places, or 1; the step has no common divisor with it

  [[nodiscard]] std::uint64_t turns() const { return rocks / rocks_at_once + (rocks % rocks_at_once > 0 ? 1 : 0); }
  [[nodiscard]] std::uint64_t turn_of(std::uint64_t rock) const { return (rock - first_rock) / rocks_at_once; }
  [[nodiscard]] std::uint64_t place_of_turn(std::uint64_t turn) const;
  [[nodiscard]] std::uint64_t place_of(std::uint64_t rock) const { return place_of_turn(turn_of(rock)); }
  /// How many of the first `released` rocks start from the places `begin` to `end` - 1. In the time of a logarithm.
  [[nodiscard]] std::uint64_t rocks_from(std::uint64_t begin, std::uint64_t end, std::uint64_t released) const;
};

/// A step for so many places: near their number over the golden ratio, with small partial quotients of the two, so that
/// the turns of any first part are far apart.
[[nodiscard]] std::uint64_t even_step(std::uint64_t places);

}  // namespace talus
