#pragma once
// Statistics of one column of a run's table over some of its rocks.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "talus/archive/run_facts.hpp"
#include "talus/results/summary.hpp"

namespace talus {

/// Which rocks count. An empty list lets all pass; of several names in one any will do.
struct RockFilter {
  std::vector<std::string> end_reasons, seeders, sources;
  std::vector<std::string> barriers;                    // that the rock hit
  std::optional<double> least_energy_J, most_energy_J;  // greatest kinetic energy along the path

  [[nodiscard]] bool is_empty() const;
};

/// What can be asked for, and its unit; empty: a number.
struct NumberColumn {
  std::string_view name, unit;
};
[[nodiscard]] const std::vector<NumberColumn>& endpoint_numbers();
/// The numbers of barriers.csv, and two that follow from them: `velocity_m_s`, the velocity's size, and `station_m`,
/// how far along the barrier's line the hit is, on plan.
[[nodiscard]] const std::vector<NumberColumn>& barrier_numbers();

/// Of endpoints.csv: with every rock, the same numbers as in the summary. Throws BadInput
/// where a table is damaged. Expects a column that there is.
[[nodiscard]] Tally endpoint_statistics(const std::filesystem::path& folder, const RunFacts& facts,
                                        std::string_view column, const RockFilter& filter);
/// Of the hits on one barrier in barriers.csv; the filter is of the rocks.
[[nodiscard]] Tally barrier_statistics(const std::filesystem::path& folder, const RunFacts& facts,
                                       std::string_view barrier, std::string_view column, const RockFilter& filter);

/// The share of values that are not greater, at up to so many values, the least and the greatest among them.
struct CumulativePoint {
  double value, share;
};
[[nodiscard]] std::vector<CumulativePoint> cumulative(const Tally& tally, std::size_t most_points);

}  // namespace talus
