#pragma once
// Ensembles of rocks with the same parameters.

#include <cstdint>

namespace talus {

inline constexpr std::uint64_t most_ensembles = 10'000;

/// The ensemble of a rock, from 0. Rocks take turns, so that each ensemble has rocks of every seeder. Expects at least
/// one ensemble.
[[nodiscard]] inline std::uint64_t ensemble_of(std::uint64_t rock, std::uint64_t ensembles) { return rock % ensembles; }

}  // namespace talus
