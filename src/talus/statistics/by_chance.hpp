#pragma once
// Whether a distance between a sample and a population may be due to chance: the same distance of samples of the same
// size that are drawn from the population itself.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace talus {

/// Draws members of a population, with replacement: `chosen` receives numbers in [0, population). A pure function of
/// the seed and the number of the draw.
void draw_members(std::uint64_t seed, std::uint64_t draw, std::size_t population, std::span<std::size_t> chosen);

struct ByChance {
  double median = 0, p95 = 0;  // of the distances by chance
  /// The probability that chance alone gives at least the observed distance: (1 + k) / (1 + m) if k of m draws do, so
  /// that it is never 0. A. C. Davison and D. V. Hinkley, Bootstrap Methods and their Application (1997), section 4.2.
  double p_value = 1;
  std::size_t draws = 0;
};

/// Expects at least one draw.
[[nodiscard]] ByChance by_chance(double observed, std::vector<double> drawn);

}  // namespace talus
