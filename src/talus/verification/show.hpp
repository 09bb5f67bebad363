#pragma once
// The comparison as text for a terminal, as JSON, and as the page docs/verification-tables.md.

#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>

#include "talus/verification/case.hpp"
#include "talus/verification/verify.hpp"

namespace talus::verification {

/// Every number of a case, grouped by table, and a summary line.
[[nodiscard]] std::string text(const CaseResult& result);

/// The numbers that differ, if any, one line per case and one for all.
[[nodiscard]] std::string summary(std::span<const CaseResult> results);

[[nodiscard]] nlohmann::ordered_json json(std::span<const CaseResult> results);

/// The text of the page about a table, without results: its place in the manual, the comparison, the tolerances with
/// their reasons, and exceptions.
[[nodiscard]] std::string description(const Table& table);

/// The first line of the page.
inline constexpr std::string_view page_title = "# Verification, table by table\n";

/// The whole page. Cases and results in the same order.
[[nodiscard]] std::string page(std::span<const Case> cases, std::span<const CaseResult> results);

}  // namespace talus::verification
