#include "talus/statistics/bootstrap.hpp"

#include <algorithm>
#include <numeric>

#include "talus/core/stop.hpp"
#include "talus/statistics/counted_draws.hpp"
#include "talus/statistics/quantile.hpp"

namespace talus {

namespace {

double sorted_quantile(const std::vector<double>& ascending, double p) {
  const QuantilePlace place = quantile_place(p, ascending.size());
  const double low = ascending[place.rank];
  return between(low, ascending[std::min<std::size_t>(place.rank + 1, ascending.size() - 1)], place.fraction);
}

}  // namespace

std::vector<Estimate> bootstrap_estimates(std::size_t rows, const StatisticsOfRows& statistics,
                                          const Bootstrap& bootstrap) {
  std::vector<std::size_t> chosen(rows);
  std::iota(chosen.begin(), chosen.end(), std::size_t{0});
  const std::vector<double> whole = rows > 0 ? statistics(chosen) : std::vector<double>{};
  std::vector<std::vector<double>> replicas(whole.size());
  const CountedDraws draws(bootstrap.seed, CountedDraws::Purpose::bootstrap);
  for (std::size_t replica = 0; replica < bootstrap.replicas && !whole.empty(); ++replica) {
    stop_point();
    for (std::size_t row = 0; row < rows; ++row)
      chosen[row] = draws.below(rows, row, static_cast<std::uint32_t>(replica));
    const std::vector<double> values = statistics(chosen);
    for (std::size_t i = 0; i < values.size(); ++i) replicas[i].push_back(values[i]);
  }
  std::vector<Estimate> estimates;
  for (std::size_t i = 0; i < whole.size(); ++i) {
    Estimate& estimate = estimates.emplace_back(Estimate{.value = whole[i], .low = {}, .high = {}});
    if (replicas[i].empty() || replicas[i].size() * 2 < bootstrap.replicas) continue;
    std::ranges::sort(replicas[i]);
    const double side = (1 - bootstrap.confidence) / 2;
    estimate.low = std::min(whole[i], sorted_quantile(replicas[i], side));
    estimate.high = std::max(whole[i], sorted_quantile(replicas[i], 1 - side));
  }
  return estimates;
}

}  // namespace talus
