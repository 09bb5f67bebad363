#include "talus/calibration/mixture.hpp"

#include <cstdint>
#include <utility>

namespace talus::calibration {

using Eigen::Index;

std::vector<std::size_t> rows_like(const Sample& observed, std::size_t count) {
  std::vector<std::size_t> rows(observed.stratum_count(), 0);
  const auto n = static_cast<std::size_t>(observed.rows.rows());
  if (!observed.has_strata()) return {count};
  for (const std::uint32_t stratum : observed.strata) ++rows[stratum];
  for (std::size_t& each : rows) each = (each * count + n - 1) / n;
  return rows;
}

Sample mixture_of(const std::vector<SetResult>& sets, std::span<const double> weights, std::size_t group,
                  const std::vector<std::size_t>& of_stratum) {
  // Systematic resampling: row i of a stratum is from the set at the share (i + 1/2) / count of the cumulated weights,
  // and the rows of a set are taken in turn.
  constexpr std::uint64_t step = 7919;  // a prime: rocks of a set are spread over its seeders
  Sample mixture;
  std::vector<std::pair<std::size_t, Index>> chosen;
  for (std::uint32_t stratum = 0; stratum < of_stratum.size(); ++stratum) {
    const std::size_t count = of_stratum[stratum];
    if (count == 0) continue;
    std::vector<std::vector<Index>> rows(sets.size());
    double below = 0, all = 0;
    for (std::size_t k = 0; k < sets.size(); ++k) {
      const Sample& sample = sets[k].samples[group];
      for (Index row = 0; row < sample.rows.rows(); ++row) {
        if (!sample.has_strata() || sample.strata[static_cast<std::size_t>(row)] == stratum) rows[k].push_back(row);
      }
      if (!rows[k].empty()) all += weights[k];
    }
    std::size_t drawn = 0;
    for (std::size_t k = 0; k < sets.size(); ++k) {
      if (rows[k].empty()) continue;
      below += weights[k] / all;
      while (drawn < count && (static_cast<double>(drawn) + 0.5) / static_cast<double>(count) <= below) {
        chosen.emplace_back(k, rows[k][drawn * step % rows[k].size()]);
        if (sets[k].samples[group].has_strata()) mixture.strata.push_back(stratum);
        ++drawn;
      }
    }
  }
  mixture.rows.resize(static_cast<Index>(chosen.size()), sets.front().samples[group].rows.cols());
  for (std::size_t i = 0; i < chosen.size(); ++i)
    mixture.rows.row(static_cast<Index>(i)) = sets[chosen[i].first].samples[group].rows.row(chosen[i].second);
  return mixture;
}

}  // namespace talus::calibration
