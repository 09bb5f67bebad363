#pragma once
// Percentile intervals by the bootstrap: B. Efron and R. J. Tibshirani, An Introduction to the Bootstrap (1993),
// chapter 13.

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "talus/statistics/order_statistics.hpp"

namespace talus {

/// How intervals are made from resampled rows.
struct Bootstrap {
  std::size_t replicas = 1000;
  double confidence = 0.95;
  std::uint64_t seed = 1;
};

/// Computes statistics of a choice of rows, which may name a row several times; empty if they are undefined.
using StatisticsOfRows = std::function<std::vector<double>(std::span<const std::size_t> rows)>;

/// The statistics of rows 0 ... rows - 1, each with the percentile interval from as many rows drawn with replacement.
/// Replicas without statistics are left out. An interval is empty if more than half of them are. Empty if the
/// statistics of all rows are undefined.
[[nodiscard]] std::vector<Estimate> bootstrap_estimates(std::size_t rows, const StatisticsOfRows& statistics,
                                                        const Bootstrap& bootstrap);

}  // namespace talus
