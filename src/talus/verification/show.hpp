#pragma once
// The comparison for people and for machines: text on a terminal, JSON, and the page docs/verification.md.

#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "talus/verification/case.hpp"
#include "talus/verification/verify.hpp"

namespace talus::verification {

/// Every number of a case, grouped by table, and a line that sums it up.
[[nodiscard]] std::string text(const CaseResult& result);

/// The numbers that differ, if any, and one line a case and one for all.
[[nodiscard]] std::string summary(std::span<const CaseResult> results);

[[nodiscard]] nlohmann::ordered_json json(std::span<const CaseResult> results);

/// What the page says of a table before it has a result: where it stands, what it is compared with, tolerances and
/// their reasons, and what is left out.
[[nodiscard]] std::string description(const Table& table);

/// The whole page. Cases and results in the same order.
[[nodiscard]] std::string page(std::span<const Case> cases, std::span<const CaseResult> results);

}  // namespace talus::verification
