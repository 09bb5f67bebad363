#include "talus/model/design_plan.hpp"

#include <algorithm>
#include <cmath>
#include <ranges>

#include "talus/project/settings.hpp"

namespace talus::project {

namespace {

std::vector<double> sorted_unique(std::vector<double> values, double unit) {
  for (double& value : values) value *= unit;
  std::ranges::sort(values);
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

DesignLine line_along(const talus::Barrier& barrier, std::uint32_t number, double section_m, bool in_section) {
  DesignLine line{.name = barrier.name, .barrier = number};
  if (in_section || barrier.panels().empty()) return line;
  const Panel& last = barrier.panels().back();
  line.start = barrier.panels().front().station;
  line.length = last.station + last.plan_length - line.start;
  line.section_length = section_m;
  // The last section is half to one and a half times as long: a short one would have too few rocks.
  const double sections = std::round(line.length / section_m);
  line.sections = static_cast<std::uint32_t>(std::clamp(sections, 1.0, double{DesignPlan::most_sections}));
  return line;
}

}  // namespace

CheckFactors check_factors(const Design& design) {
  CheckFactors factors;
  factors.takes_total_energy = design.energy == DesignEnergy::total;
  factors.block_mass = design.block_mass_kg;
  if (design.standard == DesignStandard::none) return factors;
  factors.trajectory = design.trajectory_factor;
  factors.topography = design.topography_factor;
  factors.volume = design.volume_factor;
  factors.density = design.density_factor;
  factors.risk = design.risk_factor;
  factors.level = design.energy_level == DesignLevel::sel ? KitLevel::service : KitLevel::maximum;
  factors.energy = design.energy_factor.value_or(factors.level == KitLevel::service ? 1.0 : 1.2);
  factors.clearance = design.upper_clearance_m;
  factors.clears_half_the_block = true;
  return factors;
}

DesignPlan design_plan(const Design& design, const Model& model) {
  DesignPlan plan;
  const bool in_section = std::holds_alternative<Profile>(model.surface);
  const auto number_of = [&](const std::string& name) {
    const auto found = std::ranges::find(model.barriers, name, &talus::Barrier::name);
    return static_cast<std::uint32_t>(found - model.barriers.begin());
  };
  const auto add = [&](std::uint32_t number) {
    plan.lines.push_back(line_along(model.barriers[number], number, design.section_m, in_section));
  };
  for (const std::string& name : design.lines) add(number_of(name));
  if (design.lines.empty()) {
    for (std::uint32_t number = 0; number < model.barriers.size(); ++number) add(number);
  }
  if (!design.protect.empty()) plan.protect = number_of(design.protect);
  plan.confidence = design.confidence;
  plan.percentiles = design.percentiles;
  plan.design_percentile = design.design_percentile;
  if (design.standard != DesignStandard::none) {
    plan.standard = word(design.standard);
  }
  plan.factors = check_factors(design);
  plan.heights = sorted_unique(design.heights_m, 1);
  plan.energies = sorted_unique(design.energies_kJ, 1000);
  if (plan.factors.level == KitLevel::service) {
    std::erase_if(plan.energies, [](double energy) { return energy < least_energy_with_service; });
  }
  plan.catch_share = design.catch_share;
  plan.cost = {design.cost_height_exponent, design.cost_energy_exponent};
  return plan;
}

}  // namespace talus::project
