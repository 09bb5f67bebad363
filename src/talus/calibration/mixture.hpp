#pragma once
// Predictions from several sets of parameters: simulated rows of all of them, mixed by their weights.

#include <cstddef>
#include <span>
#include <vector>

#include "talus/calibration/calibrate.hpp"

namespace talus::calibration {

/// Simulated rows of a group under several sets with these weights, drawn evenly: so many of each stratum.
[[nodiscard]] Sample mixture_of(const std::vector<SetResult>& sets, std::span<const double> weights, std::size_t group,
                                const std::vector<std::size_t>& of_stratum);
/// So many rows, divided among the strata as the observed ones are.
[[nodiscard]] std::vector<std::size_t> rows_like(const Sample& observed, std::size_t count);

}  // namespace talus::calibration
