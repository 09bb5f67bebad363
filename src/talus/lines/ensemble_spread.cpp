#include "talus/lines/ensemble_spread.hpp"

#include <utility>
#include <vector>

#include "talus/archive/design_tables.hpp"
#include "talus/archive/uncertainty.hpp"
#include "talus/results/ensemble.hpp"

namespace talus {

namespace {

/// Nullopt for too few ensembles to tell.
std::optional<Estimate> spread_of(std::vector<double> values, double of_all_rocks) {
  if (values.size() < Uncertainty::fewest) return std::nullopt;
  return range_of(std::move(values), of_all_rocks, Uncertainty::confidence);
}

/// The design percentile of each quantity of the rocks of one ensemble, or of all.
std::array<Estimate, crossing_quantity_count> percentiles_of(const SectionTally& tally, const DesignPlan& plan) {
  std::array<Estimate, crossing_quantity_count> found;
  for (std::size_t q = 0; q < found.size(); ++q)
    found[q] = RankedValues(tally.sketches[q]).estimate(plan.design_percentile / 100, plan.confidence);
  return found;
}

KitDemand demand_of(const std::array<Estimate, crossing_quantity_count>& percentiles, const CheckFactors& factors) {
  const auto of = [&](CrossingQuantity quantity) { return percentiles[static_cast<std::size_t>(quantity)]; };
  return demand_of(factors, {of(CrossingQuantity::energy_translational), of(CrossingQuantity::energy_total),
                             of(CrossingQuantity::velocity), of(CrossingQuantity::needed_height)});
}

}  // namespace

EnsembleSpread ensemble_spread(const Model& model, std::span<const std::uint64_t> rocks, const LineAnswer& answer) {
  const std::uint64_t ensembles = model.ensembles.size();
  std::vector<std::uint64_t> asked(ensembles);
  for (const std::uint64_t rock : rocks) ++asked[ensemble_of(rock, ensembles)];
  const SectionTally none(answer.crossings.size());
  SectionTally all = none;
  std::vector<SectionTally> tallies(ensembles, none);
  for (const CrossingRock& crossing : answer.crossings) {
    tallies[ensemble_of(crossing.rock, ensembles)].add(crossing.at);
    all.add(crossing.at);
  }

  EnsembleSpread spread;
  std::vector<double> shares, energies, heights;
  std::array<std::vector<double>, shown_quantity_count> percentiles;
  for (std::uint64_t k = 0; k < ensembles; ++k) {
    if (asked[k] == 0) continue;
    ++spread.ensembles;
    shares.push_back(static_cast<double>(tallies[k].rocks()) / static_cast<double>(asked[k]));
    if (tallies[k].rocks() == 0) continue;
    ++spread.crossing;
    const auto of_ensemble = percentiles_of(tallies[k], answer.plan);
    for (std::size_t q = 0; q < percentiles.size(); ++q) percentiles[q].push_back(of_ensemble[q].value);
    const KitDemand demand = demand_of(of_ensemble, answer.plan.factors);
    energies.push_back(demand.maximum_energy);
    heights.push_back(demand.height);
  }
  if (!rocks.empty())
    spread.share = spread_of(std::move(shares), static_cast<double>(all.rocks()) / static_cast<double>(rocks.size()));
  if (all.rocks() == 0) return spread;
  const auto of_all = percentiles_of(all, answer.plan);
  for (std::size_t q = 0; q < percentiles.size(); ++q)
    spread.percentile[q] = spread_of(std::move(percentiles[q]), of_all[q].value);
  const KitDemand demand = demand_of(of_all, answer.plan.factors);
  spread.needed_energy = spread_of(std::move(energies), demand.maximum_energy);
  spread.needed_height = spread_of(std::move(heights), demand.height);
  return spread;
}

nlohmann::ordered_json spread_json(const EnsembleSpread& spread) {
  using Json = nlohmann::ordered_json;
  const auto json_of = [](const std::optional<Estimate>& range) {
    return range ? Json{range->value, *range->low, *range->high} : Json();
  };
  Json json{{"ensembles", spread.ensembles},
            {"crossing", spread.crossing},
            {"confidence", Uncertainty::confidence},
            {"share", json_of(spread.share)}};
  for (std::size_t q = 0; q < spread.percentile.size(); ++q)
    json[key_of(design_quantities[q])] = json_of(spread.percentile[q]);
  json["needs_energy_J"] = json_of(spread.needed_energy);
  json["needs_height_m"] = json_of(spread.needed_height);
  return json;
}

}  // namespace talus
