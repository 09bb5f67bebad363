#include "talus/maps/map_bands.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "talus/statistics/quantile.hpp"

namespace talus {

namespace {

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

/// Of `none` values of 0 and these, which are in ascending order and not negative.
double quantile_with_none(double p, std::uint64_t none, std::span<const double> sorted) {
  const QuantilePlace place = quantile_place(p, none + sorted.size());
  const std::uint64_t upper = place.rank + (place.fraction > 0 ? 1 : 0);
  if (upper < none) return no_value;
  const auto at = [&](std::uint64_t rank) { return rank < none ? 0.0 : sorted[rank - none]; };
  return between(at(place.rank), at(upper), place.fraction);
}

}  // namespace

void band_values(const MapCellTallies& cell, const MapCellValues& values, std::size_t count, std::span<double> out) {
  const std::size_t ensembles = cell.of_ensembles.size();
  thread_local std::vector<double> of_cell, by_value;  // value by value, the ensembles in ascending order
  of_cell.resize(count);
  by_value.resize(count * ensembles);
  std::size_t reached = 0;
  for (std::size_t k = 0; k < ensembles; ++k) {
    if (!cell.of_ensembles[k]) continue;
    values(*cell.of_ensembles[k], cell.rocks_of_ensembles[k], of_cell);
    for (std::size_t i = 0; i < count; ++i) by_value[i * ensembles + reached] = of_cell[i];
    ++reached;
  }
  for (std::size_t i = 0; i < count; ++i) {
    const std::span<double> sorted = std::span(by_value).subspan(i * ensembles, reached);
    std::ranges::sort(sorted);
    for (std::size_t end = 0; end < map_band_ends.size(); ++end)
      out[map_band_ends.size() * i + end] = quantile_with_none(map_band_ends[end].share, ensembles - reached, sorted);
  }
}

double parameter_part_of_reach(const MapCellTallies& cell) {
  const std::size_t ensembles = cell.of_ensembles.size();
  if (ensembles < 2) return no_value;
  thread_local std::vector<double> shares;
  shares.clear();
  double mean = 0, sampling = 0;
  for (std::size_t k = 0; k < ensembles; ++k) {
    const auto rocks = static_cast<double>(cell.rocks_of_ensembles[k]);
    if (rocks < 2) return no_value;
    const double share = cell.of_ensembles[k] ? static_cast<double>(cell.of_ensembles[k]->passages()) / rocks : 0.0;
    shares.push_back(share);
    mean += share / static_cast<double>(ensembles);
    sampling += share * (1 - share) / (rocks - 1) / static_cast<double>(ensembles);
  }
  double variance = 0;
  for (const double share : shares) variance += (share - mean) * (share - mean) / static_cast<double>(ensembles - 1);
  return variance > 0 ? std::max(0.0, 1 - sampling / variance) : no_value;
}

}  // namespace talus
