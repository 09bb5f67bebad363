#pragma once
// The design of barriers as JSON: its plan, saved in a run's state, and its result, in summary.json.

#include <nlohmann/json.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "talus/results/design_result.hpp"

namespace talus {

[[nodiscard]] nlohmann::ordered_json plan_json(const DesignPlan& plan);
/// The plan for a model with this number of barriers and collectors. Throws BadBytes, or an exception of the JSON
/// library, on anything else.
[[nodiscard]] DesignPlan plan_from(const nlohmann::ordered_json& json, std::size_t barriers);

/// Why a kit does not catch enough rocks, and what helps; empty if it does.
[[nodiscard]] std::string limit_text(const DesignPlan& plan, const KitChoice& kit);

/// 4501 as "4,501".
[[nodiscard]] std::string grouped(std::uint64_t count);

/// The factors of the check.
[[nodiscard]] nlohmann::ordered_json factors_json(const CheckFactors& factors);
/// Each with its symbol, what it multiplies and its source.
[[nodiscard]] nlohmann::ordered_json applied_json(const std::vector<AppliedFactor>& applied);
/// `value`, `low` and `high`; null without rocks.
[[nodiscard]] nlohmann::ordered_json share_json(const std::optional<RockShare>& share);
/// `energy_J`, `class` and `height_m`; null without a demand.
[[nodiscard]] nlohmann::ordered_json demand_json(const std::optional<KitDemand>& demand);
/// The figures of a line or of a section of it.
[[nodiscard]] nlohmann::ordered_json figures_json(const DesignPlan& plan, const DesignFigures& figures);

/// The value of the key `design` of summary.json.
[[nodiscard]] nlohmann::ordered_json design_json(const DesignPlan& plan, const DesignResult& result);

}  // namespace talus
