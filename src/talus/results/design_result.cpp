#include "talus/results/design_result.hpp"

#include <algorithm>
#include <tuple>

#include "talus/results/design_pairs.hpp"

namespace talus {

namespace {

KitDemand demand_of(const CheckFactors& factors, double translational, double total, double velocity, double height) {
  const double energy = needed_maximum_energy(factors, energy_to_check(factors, translational, total, velocity));
  return {energy, needed_class(factors, energy), height};
}

class Evaluation {
 public:
  Evaluation(const DesignPlan& plan, const DesignTally& tally) : plan_(plan), tally_(tally) {}

  DesignResult result() const {
    DesignResult result;
    for (std::size_t k = 0; k < plan_.lines.size(); ++k) {
      const DesignLine& line = plan_.lines[k];
      const std::vector<SectionTally>& sections = tally_.lines[k].sections;
      DesignResult::Line& of_line = result.lines.emplace_back();
      SectionTally whole = sections.front();
      for (std::uint32_t s = 0; s < line.sections; ++s) {
        if (s > 0) whole.merge(sections[s]);
        of_line.sections.push_back(figures(sections[s], line.section_begin(s), line.section_begin(s + 1)));
      }
      of_line.whole = figures(whole, line.start, line.start + line.length);
      for (std::uint32_t s = 0; s < line.clearances.size(); ++s) add_clearance(of_line.sections[s], line.clearances[s]);
      if (const auto least = line.least_clearance()) add_clearance(of_line.whole, *least);
      add_choices(k, result.ranking);
    }
    // Ties keep the order of lines and heights.
    std::ranges::stable_sort(result.ranking, {}, [&](const KitChoice& kit) {
      const double missed = kit.caught ? 1 - kit.caught->value : 1;
      if (kit.reaches_protected()) return std::tuple(3, missed, kit.cost, 0.0);
      if (kit.suffices) return std::tuple(0, 0.0, kit.cost, missed);
      if (!catches_wanted_of_crossing(kit)) return std::tuple(2, missed, kit.cost, 0.0);
      return std::tuple(1, static_cast<double>(kit.beside) / static_cast<double>(kit.caught->of), kit.cost, missed);
    });
    std::vector<std::optional<double>> laterals;
    for (const DesignResult::Line& line : result.lines) laterals.push_back(line.whole.lateral);
    result.pairs = evaluate_pairs(plan_, tally_, laterals);
    return result;
  }

 private:
  void add_clearance(DesignFigures& figures, double clearance) const {
    figures.clearance = clearance;
    figures.most_elongation = most_elongation(plan_.factors, clearance);
  }

  DesignFigures figures(const SectionTally& tally, double from, double to) const {
    DesignFigures figures{.from = from, .to = to, .rocks = tally.rocks()};
    figures.share = share_of(tally.rocks(), tally_.rocks, plan_.confidence);
    if (tally.rocks() == 0) return figures;
    std::array<Estimate, crossing_quantity_count> design;
    for (std::size_t q = 0; q < crossing_quantity_count; ++q) {
      const RankedValues values(tally.sketches[q]);
      design[q] = values.estimate(plan_.design_percentile / 100, plan_.confidence);
      if (q >= shown_quantity_count) continue;
      for (const double percentile : plan_.percentiles) {
        figures.percentiles[q].push_back(values.estimate(percentile / 100, plan_.confidence));
      }
    }
    const auto& [translational, total, velocity, height, needed_height, lateral] = design;
    figures.largest_block = tally.largest_block;
    if (plan_.lines.front().length > 0) figures.lateral = lateral.value;
    const CheckedFigures checked{translational, total, velocity, needed_height};
    figures.demand = demand_of(plan_.factors, checked);
    figures.demand_at_upper_end = demand_at_upper_end(plan_.factors, checked);
    return figures;
  }

  void add_choices(std::size_t line, std::vector<KitChoice>& ranking) const {
    if (plan_.kits.empty()) {
      std::vector<KitChoice> choices;
      for (std::size_t h = 0; h < plan_.heights.size(); ++h) choices.push_back(choice(line, h));
      add_useful(choices, ranking);
    }
    for (std::size_t k = 0; k < plan_.kits.size(); ++k) {
      std::vector<KitChoice> choices;
      for (const double height : plan_.kits[k].heights) choices.push_back(choice_of_kit(line, k, height));
      add_useful(choices, ranking);
    }
  }

  /// Adds those of ascending height that catch more than a lower one, or need less energy.
  static void add_useful(const std::vector<KitChoice>& choices, std::vector<KitChoice>& ranking) {
    std::vector<KitChoice> kept;
    for (const KitChoice& higher : choices) {
      const bool is_superfluous = std::ranges::any_of(kept, [&](const KitChoice& lower) {
        const bool catches_no_more = !higher.caught || higher.caught->rocks <= lower.caught->rocks;
        return catches_no_more && lower.maximum_energy <= higher.maximum_energy;
      });
      if (!is_superfluous) kept.push_back(higher);
    }
    ranking.insert(ranking.end(), kept.begin(), kept.end());
  }

  [[nodiscard]] bool is_wanted(std::uint64_t rocks, std::uint64_t of) const {
    return of > 0 && static_cast<double>(rocks) / static_cast<double>(of) >= plan_.catch_share;
  }
  [[nodiscard]] bool catches_wanted_of_crossing(const KitChoice& kit) const {
    return kit.caught && is_wanted(kit.caught->rocks, kit.caught->of - kit.beside);
  }

  [[nodiscard]] KitLimit limit_of(const KitChoice& kit, std::uint64_t crossing, std::uint64_t all) const {
    if (kit.reaches_protected()) return KitLimit::clearance;
    if (kit.suffices || all == 0) return KitLimit::none;
    if (!is_wanted(crossing, all)) return KitLimit::ends;
    return is_wanted(crossing - kit.above, all) ? KitLimit::energy : KitLimit::height;
  }

  KitChoice choice(std::size_t line, std::size_t height) const {
    const DesignTally::Line& tally = tally_.lines[line];
    const std::uint64_t crossing = tally.demands.rocks(), all = crossing + tally.beside;
    KitChoice kit{.line = line, .height = plan_.heights[height], .beside = tally.beside};
    kit.above = tally.demands.above(height);
    // If even all the rocks that cross the line are too few, the kit is chosen for those.
    const std::uint64_t counted = is_wanted(crossing, all) ? all : crossing;
    bool is_enough = false;
    for (std::size_t e = 0; e < plan_.energies.size() && !is_enough; ++e) {
      const std::uint64_t caught = tally.demands.caught(height, e);
      if (e > 0 && caught == crossing - kit.above - kit.through) continue;  // no more than with a lower energy
      kit.maximum_energy = plan_.energies[e];
      kit.kit_class = kit_class_of(kit.maximum_energy);
      kit.caught = share_of(caught, all, plan_.confidence);
      kit.through = crossing - kit.above - caught;
      is_enough = is_wanted(caught, counted);
    }
    kit.suffices = is_enough && counted == all;
    judge(kit, crossing, all);
    return kit;
  }

  KitChoice choice_of_kit(std::size_t line, std::size_t number, double nominal_height) const {
    const DesignKit& of = plan_.kits[number];
    const DesignTally::Line& tally = tally_.lines[line];
    const std::size_t height = first_sufficient(plan_.heights, nominal_height);
    const std::size_t energy = first_sufficient(plan_.energies, of.checked_energy);
    const std::uint64_t crossing = tally.demands.rocks(), all = crossing + tally.beside;
    const std::uint64_t caught = tally.demands.caught(height, energy);
    KitChoice kit{.line = line, .kit = number, .height = nominal_height, .maximum_energy = of.maximum_energy};
    kit.beside = tally.beside;
    kit.kit_class = kit_class_of(of.maximum_energy);
    kit.above = tally.demands.above(height);
    kit.through = crossing - kit.above - caught;
    kit.caught = share_of(caught, all, plan_.confidence);
    kit.clearance = plan_.lines[line].least_clearance();
    if (of.elongation) kit.needed_clearance = needed_clearance(plan_.factors, *of.elongation);
    kit.suffices = is_wanted(caught, all) && !kit.reaches_protected();
    if (of.residual_share) {
      kit.residual_height = nominal_height * *of.residual_share;
      const std::size_t remaining = first_sufficient(plan_.heights, *kit.residual_height);
      const std::uint64_t below = *kit.residual_height > 0 ? crossing - tally.demands.above(remaining) : 0;
      kit.below_residual = share_of(below, all, plan_.confidence);
    }
    judge(kit, crossing, all);
    return kit;
  }

  void judge(KitChoice& kit, std::uint64_t crossing, std::uint64_t all) const {
    kit.limit = limit_of(kit, crossing, all);
    if (kit.caught) {
      kit.is_sure = kit.suffices ? kit.caught->low >= plan_.catch_share : kit.caught->high < plan_.catch_share;
      if (kit.reaches_protected()) kit.is_sure = true;  // whatever its share
    }
    kit.cost = cost_of(plan_, kit.line, kit.kit, kit.height, kit.maximum_energy);
  }

  const DesignPlan& plan_;
  const DesignTally& tally_;
};

}  // namespace

std::optional<RockShare> share_of(std::uint64_t rocks, std::uint64_t all, double confidence) {
  if (all == 0) return std::nullopt;
  const ShareBounds bounds = share_bounds(rocks, all, confidence);
  return RockShare{rocks, all, static_cast<double>(rocks) / static_cast<double>(all), bounds.low, bounds.high};
}

KitDemand demand_of(const CheckFactors& factors, const CheckedFigures& figures) {
  return demand_of(factors, figures.energy_translational.value, figures.energy_total.value, figures.velocity.value,
                   figures.needed_height.value);
}

std::optional<KitDemand> demand_at_upper_end(const CheckFactors& factors, const CheckedFigures& figures) {
  // All quantities have the same number of values: either all have an upper end or none has.
  const auto& [translational, total, velocity, height] = figures;
  if (!height.high) return std::nullopt;
  return demand_of(factors, *translational.high, *total.high, *velocity.high, *height.high);
}

double cost_of(const DesignPlan& plan, std::size_t line, std::optional<std::size_t> kit, double height,
               double maximum_energy) {
  const double length = plan.lines[line].length;
  if (kit && plan.kits[*kit].cost_per_metre) return *plan.kits[*kit].cost_per_metre * (length > 0 ? length : 1);
  return plan.cost.of(length, height, maximum_energy);
}

DesignResult evaluate(const DesignPlan& plan, const DesignTally& tally) { return Evaluation(plan, tally).result(); }

}  // namespace talus
