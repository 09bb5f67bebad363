#include "talus/calibration/coverage.hpp"

#include <algorithm>
#include <cmath>

#include "talus/statistics/binomial.hpp"

namespace talus::calibration {

std::vector<HeldOutCoverage> coverage_of(const std::vector<HeldOut>& held_out) {
  std::vector<HeldOutCoverage> all;
  for (const HeldOut& held : held_out) {
    for (const PredictedFeature& each : held.features) {
      auto found = std::ranges::find_if(all, [&](const HeldOutCoverage& known) {
        return known.group == each.group && known.feature.name == each.feature.name;
      });
      if (found == all.end()) found = all.insert(all.end(), {each.group, each.feature});
      found->observations += each.observations;
      found->within_90 += each.within_90;
    }
  }
  constexpr double part = 0.9, central = 0.95;
  for (HeldOutCoverage& each : all) {
    const auto [least, most] = central_counts(each.observations, part, central);
    each.min_expected = static_cast<std::size_t>(least);
    each.max_expected = static_cast<std::size_t>(most);
  }
  return all;
}

std::size_t within_90(const Sample& observed, const Sample& forecast, Eigen::Index feature) {
  constexpr double central = 0.9;
  std::vector<std::vector<double>> values(forecast.stratum_count());
  for (Eigen::Index row = 0; row < forecast.rows.rows(); ++row) {
    values[forecast.has_strata() ? forecast.strata[static_cast<std::size_t>(row)] : 0].push_back(
        forecast.rows(row, feature));
  }
  for (auto& each : values) std::ranges::sort(each);
  std::size_t count = 0;
  for (Eigen::Index row = 0; row < observed.rows.rows(); ++row) {
    const auto& own = values[observed.has_strata() ? observed.strata[static_cast<std::size_t>(row)] : 0];
    const auto [first, last] = std::equal_range(own.begin(), own.end(), observed.rows(row, feature));
    const auto below = static_cast<double>(first - own.begin()) + static_cast<double>(last - first) / 2;
    if (std::abs(below / static_cast<double>(own.size()) - 0.5) <= central / 2) ++count;
  }
  return count;
}

}  // namespace talus::calibration
