#pragma once
// Bins of nearly equal relative width: the bin of a value, and the value that represents a bin.

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

#include "talus/core/check.hpp"

namespace talus::log_bins {

inline constexpr float least = 0x1p-10f;  // smaller values count as zero and are in no bin
inline constexpr float most = 0x1p80f;    // 1.2e24; larger values are in the last bin

/// The bins of an octave: borders are at multiples of 1/256 of its beginning, as far apart as possible while the value
/// that represents a bin is within 0.99 % of all its values.
struct Octave {
  static constexpr std::uint32_t steps = 256;
  static constexpr std::uint32_t most_bins = 40;
  std::uint32_t bins = 0;
  std::array<std::uint8_t, steps> bin_of{};  // of each step
  std::array<std::uint16_t, most_bins + 1>
      border_of{};  // in steps: the lower border of each bin, and the last upper one
};

consteval Octave cut_octave() {
  Octave octave;
  std::uint32_t low = Octave::steps;
  while (low < 2 * Octave::steps) {
    std::uint32_t high = low + 1;
    while (high < 2 * Octave::steps && (high + 1 - low) * 10000 <= 99 * (high + 1 + low)) ++high;
    octave.border_of[octave.bins] = static_cast<std::uint16_t>(low - Octave::steps);
    for (std::uint32_t step = low; step < high; ++step)
      octave.bin_of[step - Octave::steps] = static_cast<std::uint8_t>(octave.bins);
    ++octave.bins;
    low = high;
  }
  octave.border_of[octave.bins] = Octave::steps;
  return octave;
}
inline constexpr Octave octave = cut_octave();

inline constexpr std::uint32_t step_bits = 8, dropped_bits = 23 - step_bits;  // of a float's fraction
inline constexpr std::uint32_t first_octave = std::bit_cast<std::uint32_t>(least) >> 23;
inline constexpr std::uint32_t count = ((std::bit_cast<std::uint32_t>(most) >> 23) - first_octave) * octave.bins + 1;

/// The bin of a value of at least `least`.
[[nodiscard]] inline std::uint32_t bin_of(float value) {
  TALUS_PROMISE(value >= least, "smaller values are in no bin");
  const std::uint32_t bits = std::bit_cast<std::uint32_t>(std::min(value, most)) >> dropped_bits;
  return ((bits >> step_bits) - first_octave) * octave.bins + octave.bin_of[bits & (Octave::steps - 1)];
}

/// The value that represents a bin, within 0.99 % of each of its values: the harmonic mean of its borders, which has
/// the same relative distance from both.
[[nodiscard]] inline double middle_of(std::uint32_t bin) {
  const std::uint32_t of_octave = bin % octave.bins, exponent = bin / octave.bins + first_octave;
  const double begin = static_cast<double>(std::bit_cast<float>(exponent << 23));
  const double low = Octave::steps + octave.border_of[of_octave],
               high = Octave::steps + octave.border_of[of_octave + 1];
  return begin * 2 * low * high / ((low + high) * Octave::steps);
}

}  // namespace talus::log_bins
