#pragma once
// Maps of the range between ensembles: what the rocks of a single set of parameters may show in a cell.

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>

#include "talus/maps/map_cells.hpp"

namespace talus {

/// The ends of a range that holds 90 % of the ensembles.
struct MapBandEnd {
  std::string_view word;  // in the names of files
  double share;           // of the ensembles that are below
  std::string_view meaning;
};
inline constexpr std::array<MapBandEnd, 2> map_band_ends{
    {{"low", 0.05, "5 % of the ensembles are below"}, {"high", 0.95, "5 % of the ensembles are above"}}};

/// Computes values from the rocks in a cell; `rocks` are all of the run, or of the ensemble.
using MapCellValues = std::function<void(const MapTally& cell, std::uint64_t rocks, std::span<double> out)>;

/// The ends of the range of `count` values, for each value low and high: quantiles of the ensembles (definition 7 of
/// statistics/quantile.hpp), of which those without a rock in the cell count as 0. NaN where a quantile lies among
/// these.
void band_values(const MapCellTallies& cell, const MapCellValues& values, std::size_t count, std::span<double> out);

/// The part of the parameters in the variance of the reach probability between ensembles, 0 to 1: by the law of total
/// variance it is what the mean variance of a share, p (1 - p) / (n - 1) in an ensemble of n rocks, leaves. NaN if the
/// ensembles do not differ, or if one has fewer than two rocks.
[[nodiscard]] double parameter_part_of_reach(const MapCellTallies& cell);

}  // namespace talus
