// Rules for the kits of a design, and for pairs of lines.

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "talus/project/check_design.hpp"
#include "talus/project/values.hpp"
#include "talus/results/design_plan.hpp"

namespace talus::project {

void DesignRules::check_kits(const FactorSet* set) const {
  if (project.kits.empty()) return;
  for (const std::string_view key : {"heights_m", "energies_kJ"}) {
    if (const auto* given = accepted(&row, key)) {
      report(given, fmt::format("{} has no effect", key), "the project has [[kit]]s to choose from", "Leave it out",
             Severity::warning);
    }
  }
  std::size_t all_heights = 0;
  for (const Kit& kit : project.kits) all_heights += kit.heights_m.size();
  if (all_heights > DesignPlan::most_kit_heights) {
    report(&row, fmt::format("the kits have {} heights", all_heights),
           fmt::format("expected at most {} of all kits together", DesignPlan::most_kit_heights), "", Severity::error);
  }
  const auto priced = std::ranges::count_if(project.kits, [](const Kit& kit) { return kit.cost_per_m.has_value(); });
  for (std::size_t k = 0; k < project.kits.size(); ++k) {
    if (k >= kits.size() || kits[k] == nullptr) continue;
    check_kit(k, set);
    if (priced > 0 && !project.kits[k].cost_per_m && !kits[k]->contains("cost_per_m")) {
      report_kit(k, kits[k], "cost_per_m is missing", "other kits have one, and prices compare with no index",
                 "Give all kits a price, or none", Severity::error);
    }
  }
}

void DesignRules::check_kit(std::size_t k, const FactorSet* set) const {
  const Kit& kit = project.kits[k];
  const toml::table* of = kits[k];
  if (const auto* heights = accepted(of, "heights_m")) {
    if (kit.heights_m.empty()) {
      report_kit(k, heights, "heights_m is empty", "the kit could not be chosen", "", Severity::error);
    }
    for (const std::size_t i : repeated(kit.heights_m)) {
      report_kit(k, heights->as_array()->get(i), fmt::format("heights_m[{}] is {}", i, number_text(kit.heights_m[i])),
                 "it is listed twice", "Leave it out", Severity::error);
    }
    for (std::size_t i = 0; i < kit.heights_m.size(); ++i) {
      if (!kit.tested_height_m || !accepted(of, "tested_height_m") || kit.heights_m[i] >= *kit.tested_height_m)
        continue;
      report_kit(k, heights->as_array()->get(i), fmt::format("heights_m[{}] is {}", i, number_text(kit.heights_m[i])),
                 fmt::format("the kit was tested with {} m, and what a lower one stops was not", *kit.tested_height_m),
                 "Leave it out", Severity::error);
    }
  }
  if (const auto* sel = accepted(of, "sel_kJ"); sel && accepted(of, "mel_kJ") && *kit.sel_kJ > kit.mel_kJ) {
    report_kit(
        k, sel, fmt::format("sel_kJ is {}", number_text(*kit.sel_kJ)),
        fmt::format("the service energy level cannot exceed the maximum energy level, {}", number_text(kit.mel_kJ)), "",
        Severity::error);
  }
  const auto* elongation = accepted(of, "elongation_m");
  if (!elongation) return;
  const Factor* factor = set != nullptr ? set->find("elongation_factor") : nullptr;
  if (factor != nullptr && !value_of(*factor, design) && !row.contains("elongation_factor")) {
    report_kit(k, elongation, "elongation_m is given without design.elongation_factor",
               fmt::format("{} needs {}, and has no value for it: {}", set->name, factor->symbol, factor->not_read),
               "Take it from the edition that binds you", Severity::error);
  }
  if (design.protect.empty() && !design.clearance_m && !row.contains("protect") && !row.contains("clearance_m")) {
    report_kit(k, elongation, "elongation_m has no effect", "the distance to what is protected is not known",
               "Give design.protect or design.clearance_m", Severity::warning);
  }
}

void DesignRules::check_pairs() const {
  const auto* pairs = accepted(&row, "pairs");
  if (!pairs || !design.pairs) return;
  const std::size_t lines = design.lines.empty() ? project.barriers.size() : design.lines.size();
  if (lines < 2) {
    report(pairs, "pairs has no effect", "there is only one line", "Add another [[collector]]", Severity::warning);
    return;
  }
  std::set<double> heights(design.heights_m.begin(), design.heights_m.end());
  std::set<double> energies(design.energies_kJ.begin(), design.energies_kJ.end());
  if (!project.kits.empty()) {
    heights.clear();
    energies.clear();
    for (const Kit& kit : project.kits) {
      heights.insert(kit.heights_m.begin(), kit.heights_m.end());
      if (kit.residual_height != ResidualHeight::unknown) {  // a threshold of its own for each height that remains
        for (const double height : kit.heights_m) heights.insert(-height);
      }
      energies.insert(kit.mel_kJ);
      energies.insert(kit.sel_kJ.value_or(kit.mel_kJ));
    }
  }
  const auto classes = static_cast<double>((heights.size() + 1) * (energies.size() + 1) + 1);
  const double all = 0.5 * static_cast<double>(lines * (lines - 1));
  if (all * classes * classes <= static_cast<double>(DesignPlan::most_pair_counts)) return;
  report(pairs, fmt::format("pairs of {} lines would need {:.2g} counts", lines, all * classes * classes),
         fmt::format("{} heights and {} energies can be combined in as many ways; expected at most {:.2g}",
                     heights.size(), energies.size(), static_cast<double>(DesignPlan::most_pair_counts)),
         "Name fewer lines, or choose from fewer heights and energies", Severity::error);
}

}  // namespace talus::project
