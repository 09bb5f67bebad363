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

/// So many rocks of each ensemble.
using Counts = std::vector<std::uint64_t>;

Counts counted(std::span<const std::uint64_t> rocks, std::uint64_t ensembles) {
  Counts counts(ensembles);
  for (const std::uint64_t rock : rocks) ++counts[ensemble_of(rock, ensembles)];
  return counts;
}

/// Of the ensembles with rocks that were asked, the share that `found` says.
std::optional<Estimate> share_between(const Counts& asked, const Counts& found) {
  std::vector<double> shares;
  std::uint64_t all_found = 0, all_asked = 0;
  for (std::size_t k = 0; k < asked.size(); ++k) {
    if (asked[k] == 0) continue;
    shares.push_back(static_cast<double>(found[k]) / static_cast<double>(asked[k]));
    all_found += found[k];
    all_asked += asked[k];
  }
  if (all_asked == 0) return std::nullopt;
  return spread_of(std::move(shares), static_cast<double>(all_found) / static_cast<double>(all_asked));
}

void count(const Counts& asked, const Counts& crossing, EnsembleSpread& spread) {
  for (std::size_t k = 0; k < asked.size(); ++k) {
    if (asked[k] == 0) continue;
    ++spread.ensembles;
    if (crossing[k] > 0) ++spread.crossing;
  }
  spread.share = share_between(asked, crossing);
}

/// The design percentiles of what a polygon shows.
std::array<double, shown_quantity_count> percentiles_of(std::span<const RockInside> rocks, const DesignPlan& plan) {
  std::array<double, shown_quantity_count> found{};
  for (std::size_t q = 0; q < found.size(); ++q) {
    QuantileSketch sketch(rocks.size());
    for (const RockInside& rock : rocks) sketch.add(rock.maxima[q]);
    found[q] = RankedValues(sketch).estimate(plan.design_percentile / 100, plan.confidence).value;
  }
  return found;
}

nlohmann::ordered_json json_of(const std::optional<Estimate>& range) {
  return range ? nlohmann::ordered_json{range->value, *range->low, *range->high} : nlohmann::ordered_json();
}

nlohmann::ordered_json common_json(const EnsembleSpread& spread) {
  nlohmann::ordered_json json{{"ensembles", spread.ensembles},
                              {"crossing", spread.crossing},
                              {"confidence", Uncertainty::confidence},
                              {"share", json_of(spread.share)}};
  for (std::size_t q = 0; q < spread.percentile.size(); ++q)
    json[key_of(design_quantities[q])] = json_of(spread.percentile[q]);
  return json;
}

}  // namespace

LineSpread ensemble_spread(const Model& model, std::span<const std::uint64_t> rocks, const LineAnswer& answer) {
  const std::uint64_t ensembles = model.ensembles.size();
  const SectionTally none(answer.crossings.size());
  SectionTally all = none;
  std::vector<SectionTally> tallies(ensembles, none);
  Counts crossing(ensembles);
  for (const CrossingRock& each : answer.crossings) {
    const std::uint64_t k = ensemble_of(each.rock, ensembles);
    tallies[k].add(each.at);
    all.add(each.at);
    ++crossing[k];
  }
  LineSpread spread;
  count(counted(rocks, ensembles), crossing, spread);
  if (all.rocks() == 0) return spread;

  std::vector<double> energies, heights;
  std::array<std::vector<double>, shown_quantity_count> percentiles;
  for (std::uint64_t k = 0; k < ensembles; ++k) {
    if (crossing[k] == 0) continue;
    const auto of_ensemble = percentiles_of(tallies[k], answer.plan);
    for (std::size_t q = 0; q < percentiles.size(); ++q) percentiles[q].push_back(of_ensemble[q].value);
    const KitDemand demand = demand_of(of_ensemble, answer.plan.factors);
    energies.push_back(demand.maximum_energy);
    heights.push_back(demand.height);
  }
  const auto of_all = percentiles_of(all, answer.plan);
  for (std::size_t q = 0; q < percentiles.size(); ++q)
    spread.percentile[q] = spread_of(std::move(percentiles[q]), of_all[q].value);
  const KitDemand demand = demand_of(of_all, answer.plan.factors);
  spread.needed_energy = spread_of(std::move(energies), demand.maximum_energy);
  if (const auto& energy = spread.needed_energy) {
    const auto of = [&](double needed) { return needed_class(answer.plan.factors, needed); };
    spread.needed_class = {of(energy->value), of(*energy->low), of(*energy->high)};
  }
  spread.needed_height = spread_of(std::move(heights), demand.height);
  return spread;
}

AreaSpread ensemble_spread(const Model& model, std::span<const std::uint64_t> rocks, const AreaAnswer& answer) {
  const std::uint64_t ensembles = model.ensembles.size();
  std::vector<std::vector<RockInside>> inside(ensembles);
  Counts entering(ensembles), stopping(ensembles);
  for (const RockInside& rock : answer.entering) {
    const std::uint64_t k = ensemble_of(rock.rock, ensembles);
    inside[k].push_back(rock);
    ++entering[k];
    if (rock.stops) ++stopping[k];
  }
  const Counts asked = counted(rocks, ensembles);
  AreaSpread spread;
  count(asked, entering, spread);
  spread.stopping = share_between(asked, stopping);
  if (answer.entering.empty()) return spread;

  std::array<std::vector<double>, shown_quantity_count> percentiles;
  for (const std::vector<RockInside>& of_ensemble : inside) {
    if (of_ensemble.empty()) continue;
    const auto found = percentiles_of(of_ensemble, answer.plan);
    for (std::size_t q = 0; q < percentiles.size(); ++q) percentiles[q].push_back(found[q]);
  }
  const auto of_all = percentiles_of(answer.entering, answer.plan);
  for (std::size_t q = 0; q < percentiles.size(); ++q)
    spread.percentile[q] = spread_of(std::move(percentiles[q]), of_all[q]);
  return spread;
}

nlohmann::ordered_json spread_json(const LineSpread& spread) {
  nlohmann::ordered_json json = common_json(spread);
  json["needs_energy_J"] = json_of(spread.needed_energy);
  json["needs_class"] = spread.needed_class ? nlohmann::ordered_json(*spread.needed_class) : nlohmann::ordered_json();
  json["needs_height_m"] = json_of(spread.needed_height);
  return json;
}

nlohmann::ordered_json spread_json(const AreaSpread& spread) {
  nlohmann::ordered_json json = common_json(spread);
  json["stopping"] = json_of(spread.stopping);
  return json;
}

}  // namespace talus
