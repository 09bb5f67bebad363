#pragma once
// The design of barriers as JSON: its plan, to be kept with a run's state, and its result, in summary.json.

#include <nlohmann/json.hpp>

#include <string>

#include "talus/results/design_result.hpp"

namespace talus {

[[nodiscard]] nlohmann::ordered_json plan_json(const DesignPlan& plan);
/// Of so many barriers and collectors. Throws BadBytes, or an exception of the library, on what is not a plan for them.
[[nodiscard]] DesignPlan plan_from(const nlohmann::ordered_json& json, std::size_t barriers);

/// What holds a kit back and what helps, in words; empty where nothing does.
[[nodiscard]] std::string limit_text(const DesignPlan& plan, const KitChoice& kit);

/// The value of the key `design` of summary.json.
[[nodiscard]] nlohmann::ordered_json design_json(const DesignPlan& plan, const DesignResult& result);

}  // namespace talus
