#pragma once
// design.csv and design_ranking.csv: the design of barriers for spreadsheets.

#include <filesystem>
#include <string>

#include "talus/results/design_result.hpp"

namespace talus::io {

/// A row a section of every line, and one of the whole line, whose section is "all"; cells of what is not known are
/// empty.
[[nodiscard]] std::string design_table(const DesignPlan& plan, const DesignResult& result);
/// A row a kit, the best first.
[[nodiscard]] std::string ranking_table(const DesignPlan& plan, const DesignResult& result);

/// Writes both into a run's folder. Throws BadInput where that fails.
void write_design_tables(const std::filesystem::path& folder, const DesignPlan& plan, const DesignResult& result);
/// Removes those that an earlier run left there.
void remove_design_tables(const std::filesystem::path& folder);

}  // namespace talus::io
