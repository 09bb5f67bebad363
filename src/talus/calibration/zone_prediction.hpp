#pragma once
// Shares of deposits by zone, as predicted by a mixture of sets.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "talus/calibration/calibrate.hpp"

namespace talus::calibration {

/// Of one zone: the share of as many rocks as were observed.
struct PredictedShare {
  double p05 = 0, p50 = 0, p95 = 0;
};

/// By category of the group's zones. Sets without rocks in the zones are left out.
[[nodiscard]] std::vector<PredictedShare> predicted_shares(const ObservedGroup& group, std::size_t g,
                                                           const std::vector<SetResult>& sets,
                                                           std::span<const double> weights, std::uint64_t seed);

}  // namespace talus::calibration
