#pragma once
// The uncertainty of a run's figures, as the report and the workbench show it.

#include <nlohmann/json.hpp>

#include "talus/archive/uncertainty.hpp"

namespace talus {

/// The number of ensembles, and a row for each figure: its value for all rocks with the range between ensembles, and
/// the ranges and the share of its parts. Each range is a list of the value and its ends, with six digits.
[[nodiscard]] nlohmann::ordered_json uncertainty_json(const Uncertainty& uncertainty);

}  // namespace talus
