#pragma once
// The number of successes in independent trials.

#include <array>
#include <cstdint>

namespace talus {

/// The central part, for example 0.95, of the number of successes in `trials` independent trials with this probability:
/// quantiles of the binomial distribution (any textbook), rounded outwards to whole counts.
[[nodiscard]] std::array<double, 2> central_counts(std::uint64_t trials, double probability, double central);

}  // namespace talus
