#pragma once
// How far the figures of a line or an area differ between the ensembles of a run with uncertain parameters.

#include <nlohmann/json.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "talus/campaign/model.hpp"
#include "talus/lines/area_answer.hpp"
#include "talus/lines/line_answer.hpp"

namespace talus {

/// Of each figure the value of all rocks and the range in which most ensembles are, as in uncertainty.csv
/// (archive/uncertainty.hpp: 90 %). It contains what the parameters change and the chance of an ensemble's rocks.
/// Nullopt: rocks of too few ensembles cross.
struct EnsembleSpread {
  std::uint64_t ensembles = 0;  // with rocks whose paths are kept
  std::uint64_t crossing = 0;   // of these, with rocks that cross or enter
  std::optional<Estimate> share;
  std::array<std::optional<Estimate>, shown_quantity_count> percentile;  // the design percentile
};
struct LineSpread : EnsembleSpread {
  std::optional<Estimate> needed_energy, needed_height;  // of the fence that the check asks for
  std::optional<std::array<int, 3>> needed_class;        // of needed_energy: its value and both ends
};
struct AreaSpread : EnsembleSpread {
  std::optional<Estimate> stopping;  // the share that stops in the area
};

/// `rocks`: those that were asked. Expects a model with ensembles.
[[nodiscard]] LineSpread ensemble_spread(const Model& model, std::span<const std::uint64_t> rocks,
                                         const LineAnswer& answer);
[[nodiscard]] AreaSpread ensemble_spread(const Model& model, std::span<const std::uint64_t> rocks,
                                         const AreaAnswer& answer);
[[nodiscard]] nlohmann::ordered_json spread_json(const LineSpread& spread);
[[nodiscard]] nlohmann::ordered_json spread_json(const AreaSpread& spread);

}  // namespace talus
