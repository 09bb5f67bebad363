#include "talus/model/design_plan.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <ranges>

#include "talus/model/design_geometry.hpp"
#include "talus/project/factor_set.hpp"

namespace talus::project {

namespace {

std::vector<double> sorted_unique(std::vector<double> values, double unit) {
  for (double& value : values) value *= unit;
  std::ranges::sort(values);
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

}  // namespace

DesignLine line_along(const talus::Barrier& barrier, std::uint32_t number, double section_m, bool in_section) {
  DesignLine line{.name = barrier.name, .barrier = number};
  if (in_section || barrier.panels().empty()) return line;
  const Panel& last = barrier.panels().back();
  line.start = barrier.panels().front().station;
  line.length = last.station + last.plan_length - line.start;
  line.section_length = section_m;
  line.pieces = pieces_of(barrier);
  // The last section is half to one and a half times as long: a short one would have too few rocks.
  const double sections = std::round(line.length / section_m);
  line.sections = static_cast<std::uint32_t>(std::clamp(sections, 1.0, double{DesignPlan::most_sections}));
  return line;
}

namespace {

/// The factor of a quantity.
double& factor_on(CheckFactors& factors, std::string_view quantity) {
  if (quantity == "velocity") return factors.velocity;
  if (quantity == "height") return factors.height;
  if (quantity == "mass") return factors.mass;
  if (quantity == "energy") return factors.energy;
  if (quantity == "capacity") return factors.capacity;
  return *factors.elongation;
}

void apply_set(const FactorSet& set, const Design& design, DesignPlan& plan) {
  plan.standard = set.name;
  plan.standard_not_read = set.not_read;
  plan.design_percentile = design.design_percentile.value_or(set.design_percentile.value_or(plan.design_percentile));
  CheckFactors& factors = plan.factors;
  factors.level = design.energy_level == DesignLevel::sel ? KitLevel::service : KitLevel::maximum;
  factors.clearance = design.upper_clearance_m.value_or(set.upper_clearance_m);
  factors.clears_half_the_block = set.clears_half_the_block;
  const auto is_known = [&](const Factor& factor) { return value_of(factor, design).has_value(); };
  std::vector<Factor> in_order = set.factors;  // the unknown ones last
  std::stable_partition(in_order.begin(), in_order.end(), is_known);
  for (const Factor& factor : in_order) {
    const auto value = value_of(factor, design);
    if (!value) {  // on the elongation, which no kit gives
      factors.elongation.reset();
      continue;
    }
    for (const std::string& quantity : factor.multiplies) factor_on(factors, quantity) *= *value;
    plan.applied.push_back({factor.symbol, factor.key, fmt::format("{}", fmt::join(factor.multiplies, ", ")),
                            set.find_source(factor.source)->text, factor.not_read, *value});
  }
}

/// The clearance of each section of a line.
void add_clearances(DesignLine& line, const Design& design, const std::vector<talus::Barrier>& barriers,
                    std::optional<std::uint32_t> protect) {
  if (design.clearance_m) {
    line.clearances.assign(line.sections, *design.clearance_m);
    return;
  }
  if (!protect || barriers[line.barrier].panels().empty() || barriers[*protect].panels().empty()) return;
  for (std::uint32_t s = 0; s < line.sections; ++s) {
    line.clearances.push_back(
        distance_between(barriers[line.barrier], line.section_begin(s), line.section_begin(s + 1), barriers[*protect]));
  }
}

void add_kits(const std::vector<Kit>& kits, DesignPlan& plan) {
  const bool is_service = plan.factors.level == KitLevel::service;
  constexpr double kJ = 1000;
  std::vector<double> heights, energies;
  for (const Kit& given : kits) {
    DesignKit& kit = plan.kits.emplace_back();
    kit.name = given.name;
    kit.heights = sorted_unique(given.heights_m, 1);
    kit.maximum_energy = given.mel_kJ * kJ;
    // The check asks for a MEL of three times the needed SEL.
    kit.checked_energy = is_service && given.sel_kJ ? 3 * *given.sel_kJ * kJ : kit.maximum_energy;
    kit.elongation = given.elongation_m;
    if (given.residual_height != ResidualHeight::unknown) {
      constexpr double of_a = 0.5, of_b = 0.3;
      kit.residual_share = given.residual_height == ResidualHeight::a   ? of_a
                           : given.residual_height == ResidualHeight::b ? of_b
                                                                        : 0;
    }
    kit.cost_per_metre = given.cost_per_m;
    energies.push_back(kit.checked_energy);
    for (const double height : kit.heights) {
      heights.push_back(height);
      if (kit.residual_share.value_or(0) > 0) heights.push_back(height * *kit.residual_share);
    }
  }
  plan.heights = sorted_unique(std::move(heights), 1);
  plan.energies = sorted_unique(std::move(energies), 1);
}

void add_pairs(const Model& model, DesignPlan& plan) {
  for (std::uint32_t one = 0; one < plan.lines.size(); ++one) {
    for (std::uint32_t other = one + 1; other < plan.lines.size(); ++other) {
      DesignPair& pair = plan.pairs.emplace_back(DesignPair{one, other});
      const talus::Barrier& here = model.barriers[plan.lines[one].barrier];
      const talus::Barrier& there = model.barriers[plan.lines[other].barrier];
      if (plan.lines[one].length == 0 || plan.lines[other].length == 0) continue;
      if (const auto stagger = stagger_of(here, there)) {
        pair.overlap = stagger->overlap;
        pair.distance = stagger->distance;
      }
    }
  }
}

}  // namespace

DesignBasis design_basis(const Project& project) {
  DesignBasis basis{project.design.value_or(Design{}), {}, project.kits};
  basis.factors = factor_set_of(basis.design, project.file.parent_path());
  return basis;
}

DesignPlan design_check(const DesignBasis& basis) {
  const Design& design = basis.design;
  DesignPlan plan;
  plan.confidence = design.confidence;
  plan.percentiles = design.percentiles;
  plan.design_percentile = design.design_percentile.value_or(plan.design_percentile);
  plan.factors.takes_total_energy = design.energy == DesignEnergy::total;
  plan.factors.block_mass = design.block_mass_kg;
  if (basis.factors) apply_set(*basis.factors, design, plan);
  plan.heights = sorted_unique(design.heights_m, 1);
  plan.energies = sorted_unique(design.energies_kJ, 1000);
  if (plan.factors.level == KitLevel::service) {
    std::erase_if(plan.energies, [](double energy) { return energy < least_energy_with_service; });
  }
  if (!basis.kits.empty()) add_kits(basis.kits, plan);
  plan.catch_share = design.catch_share;
  plan.cost = {design.cost_height_exponent, design.cost_energy_exponent};
  return plan;
}

DesignPlan design_plan(const Project& project, const Model& model) {
  const Design& design = *project.design;
  DesignPlan plan = design_check(design_basis(project));
  const bool in_section = std::holds_alternative<Profile>(*model.surface);
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
  for (DesignLine& line : plan.lines) add_clearances(line, design, model.barriers, plan.protect);
  if (!in_section) plan.free_end = design.free_end_m;
  if (design.pairs) add_pairs(model, plan);
  return plan;
}

}  // namespace talus::project
