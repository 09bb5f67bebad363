#pragma once
// Statistics of one column of a run's table over a selection of its rocks.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "talus/archive/run_facts.hpp"
#include "talus/results/summary.hpp"

namespace talus {

/// Selects rocks. An empty list passes all rocks; otherwise any of its names matches.
struct RockFilter {
  std::vector<std::string> end_reasons, seeders, sources;
  std::vector<std::string> barriers;                    // hit by the rock
  std::optional<double> least_energy_J, most_energy_J;  // limits of the maximum total kinetic energy
  std::function<bool(std::uint64_t rock)> passes;       // by the rock's number; empty: all

  [[nodiscard]] bool is_empty() const;
};

/// A column with statistics, and its unit; empty: none.
struct NumberColumn {
  std::string_view name, unit;
};
[[nodiscard]] const std::vector<NumberColumn>& endpoint_numbers();
/// The quantities of barriers.csv, and two that follow from them: `velocity_m_s`, the magnitude of the velocity, and
/// `station_m`, the place of the hit along the barrier's line on plan.
[[nodiscard]] const std::vector<NumberColumn>& barrier_numbers();

/// Statistics of a column of endpoints.csv; over all rocks they equal those of the summary. Throws BadInput if a table
/// is damaged. Expects a column of endpoint_numbers().
[[nodiscard]] Tally endpoint_statistics(const std::filesystem::path& folder, const RunFacts& facts,
                                        std::string_view column, const RockFilter& filter);
/// Statistics of the hits on one barrier in barriers.csv by the rocks that pass the filter.
[[nodiscard]] Tally barrier_statistics(const std::filesystem::path& folder, const RunFacts& facts,
                                       std::string_view barrier, std::string_view column, const RockFilter& filter);

/// The cumulative distribution at no more than `most_points` values, including the minimum and maximum.
struct CumulativePoint {
  double value, share;
};
[[nodiscard]] std::vector<CumulativePoint> cumulative(const Tally& tally, std::size_t most_points);

}  // namespace talus
