#pragma once
// Quantiles of a sample as spreadsheets define them.

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "talus/core/check.hpp"

namespace talus {

/// Where the quantile p of `count` values is among them in ascending order: a part `fraction` of the way from the value
/// with the zero-based number `rank` to the next. R. J. Hyndman and Y. Fan, "Sample quantiles in statistical packages",
/// The American Statistician 50 (1996) 361-365, definition 7: spreadsheets' PERCENTILE, R's default.
struct QuantilePlace {
  std::uint64_t rank;
  double fraction;
};

[[nodiscard]] inline QuantilePlace quantile_place(double p, std::uint64_t count) {
  TALUS_PROMISE(p >= 0 && p <= 1 && count > 0, "a quantile needs a probability and a sample");
  const double place = p * static_cast<double>(count - 1);
  const std::uint64_t rank = std::min(static_cast<std::uint64_t>(place), count - 1);
  return {rank, rank + 1 < count ? place - static_cast<double>(rank) : 0.0};
}

/// `fraction` of the way from `low` to `high`, never past either.
[[nodiscard]] inline double between(double low, double high, double fraction) {
  return std::clamp(low + fraction * (high - low), low, high);
}

}  // namespace talus
