#pragma once
// Answers of ditches (ditch_answer.hpp) as JSON; docs/slope-tools.md describes the figures.

#include <nlohmann/json.hpp>

#include "talus/lines/ditch_answer.hpp"

namespace talus {

/// The percentiles of impact and roll-out.
inline constexpr double ditch_percentiles[]{50, 90, 95, 99};

/// All intervals have this confidence.
[[nodiscard]] nlohmann::ordered_json ditch_json(const Model& model, const Ditch& ditch, const DitchAnswer& answer,
                                                double confidence);

}  // namespace talus
