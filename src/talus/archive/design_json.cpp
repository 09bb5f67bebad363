#include "talus/archive/design_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <ranges>

#include "talus/archive/design_tables.hpp"
#include "talus/core/bytes.hpp"

namespace talus {

namespace {

using Json = nlohmann::ordered_json;

template <class T>
Json optional_json(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json factors_json(const CheckFactors& factors) {
  return {{"trajectory", factors.trajectory},
          {"topography", factors.topography},
          {"volume", factors.volume},
          {"density", factors.density},
          {"risk", factors.risk},
          {"energy", factors.energy},
          {"clearance_m", factors.clearance},
          {"clears_half_the_block", factors.clears_half_the_block},
          {"of_total_energy", factors.takes_total_energy},
          {"level", factors.level == KitLevel::service ? "SEL" : "MEL"},
          {"block_mass_kg", optional_json(factors.block_mass)}};
}

CheckFactors factors_from(const Json& json) {
  CheckFactors factors;
  json.at("trajectory").get_to(factors.trajectory);
  json.at("topography").get_to(factors.topography);
  json.at("volume").get_to(factors.volume);
  json.at("density").get_to(factors.density);
  json.at("risk").get_to(factors.risk);
  json.at("energy").get_to(factors.energy);
  json.at("clearance_m").get_to(factors.clearance);
  json.at("clears_half_the_block").get_to(factors.clears_half_the_block);
  json.at("of_total_energy").get_to(factors.takes_total_energy);
  factors.level = json.at("level") == "SEL" ? KitLevel::service : KitLevel::maximum;
  if (const Json& mass = json.at("block_mass_kg"); !mass.is_null()) factors.block_mass = mass.get<double>();
  return factors;
}

bool rises(const std::vector<double>& values) {
  return std::ranges::adjacent_find(values, std::greater_equal<>()) == values.end();
}

}  // namespace

Json plan_json(const DesignPlan& plan) {
  Json lines = Json::array();
  for (const DesignLine& line : plan.lines) {
    lines.push_back({{"name", line.name},
                     {"barrier", line.barrier},
                     {"from_m", line.start},
                     {"length_m", line.length},
                     {"section_m", line.section_length},
                     {"sections", line.sections}});
  }
  return {{"lines", std::move(lines)},
          {"protect", optional_json(plan.protect)},
          {"confidence", plan.confidence},
          {"percentiles", plan.percentiles},
          {"design_percentile", plan.design_percentile},
          {"standard", plan.standard},
          {"factors", factors_json(plan.factors)},
          {"heights_m", plan.heights},
          {"energies_J", plan.energies},
          {"catch_share", plan.catch_share},
          {"cost_height_exponent", plan.cost.height_exponent},
          {"cost_energy_exponent", plan.cost.energy_exponent}};
}

DesignPlan plan_from(const Json& json, std::size_t barriers) {
  constexpr const char* damaged = "the plan for the design of barriers is damaged";
  DesignPlan plan;
  for (const Json& given : json.at("lines")) {
    DesignLine& line = plan.lines.emplace_back();
    given.at("name").get_to(line.name);
    given.at("barrier").get_to(line.barrier);
    given.at("from_m").get_to(line.start);
    given.at("length_m").get_to(line.length);
    given.at("section_m").get_to(line.section_length);
    given.at("sections").get_to(line.sections);
    expect_bytes(line.barrier < barriers && line.sections > 0 && line.sections <= DesignPlan::most_sections &&
                     (line.sections == 1 || line.section_length > 0),
                 damaged);
  }
  if (const Json& protect = json.at("protect"); !protect.is_null()) plan.protect = protect.get<std::uint32_t>();
  json.at("confidence").get_to(plan.confidence);
  json.at("percentiles").get_to(plan.percentiles);
  json.at("design_percentile").get_to(plan.design_percentile);
  json.at("standard").get_to(plan.standard);
  plan.factors = factors_from(json.at("factors"));
  json.at("heights_m").get_to(plan.heights);
  json.at("energies_J").get_to(plan.energies);
  json.at("catch_share").get_to(plan.catch_share);
  json.at("cost_height_exponent").get_to(plan.cost.height_exponent);
  json.at("cost_energy_exponent").get_to(plan.cost.energy_exponent);
  const auto is_percentage = [](double p) { return p >= 0 && p <= 100; };
  expect_bytes((!plan.protect || *plan.protect < barriers) && rises(plan.heights) && rises(plan.energies) &&
                   plan.confidence > 0 && plan.confidence < 1 && is_percentage(plan.design_percentile) &&
                   std::ranges::all_of(plan.percentiles, is_percentage),
               damaged);
  return plan;
}

namespace {

Json share_json(const std::optional<RockShare>& share) {
  if (!share) return nullptr;
  return {{"value", share->value}, {"low", share->low}, {"high", share->high}};
}

Json demand_json(const std::optional<KitDemand>& demand) {
  if (!demand) return nullptr;
  return {{"energy_J", demand->maximum_energy}, {"class", demand->kit_class}, {"height_m", demand->height}};
}

/// Each percentile as [value, lower end, upper end].
Json percentiles_json(const DesignPlan& plan, const std::vector<Estimate>& estimates) {
  Json json = Json::object();
  for (std::size_t k = 0; k < estimates.size(); ++k) {
    const Estimate& estimate = estimates[k];
    json[fmt::format("{}", plan.percentiles[k])] = {estimate.value, optional_json(estimate.low),
                                                    optional_json(estimate.high)};
  }
  return json;
}

Json figures_json(const DesignPlan& plan, const DesignFigures& figures) {
  Json percentiles;
  for (std::size_t k = 0; k < design_quantities.size(); ++k)
    percentiles[key_of(design_quantities[k])] = percentiles_json(plan, figures.percentiles[k]);
  return {{"from_m", figures.from},
          {"to_m", figures.to},
          {"rocks", figures.rocks},
          {"share", share_json(figures.share)},
          {"percentiles", std::move(percentiles)},
          {"needs", demand_json(figures.demand)},
          {"needs_at_upper_end", demand_json(figures.demand_at_upper_end)}};
}

/// 4501 as 4,501.
std::string grouped(std::uint64_t count) {
  return count < 1000 ? fmt::format("{}", count) : fmt::format("{},{:03}", grouped(count / 1000), count % 1000);
}

const char* limit_name(KitLimit limit) {
  switch (limit) {
    case KitLimit::none:
      return nullptr;
    case KitLimit::ends:
      return "ends";
    case KitLimit::height:
      return "height";
    case KitLimit::energy:
      return "energy";
  }
  return nullptr;
}

Json choice_json(const DesignPlan& plan, const KitChoice& kit) {
  const char* limit = limit_name(kit.limit);
  return {{"line", plan.lines[kit.line].name},
          {"height_m", kit.height},
          {"energy_J", kit.maximum_energy},
          {"class", optional_json(kit.kit_class)},
          {"suffices", kit.suffices},
          {"sure", kit.is_sure},
          {"limited_by", limit != nullptr ? Json(limit) : Json(nullptr)},
          {"limit", limit_text(plan, kit)},
          {"rocks", kit.caught ? kit.caught->of : 0},
          {"caught", kit.caught ? kit.caught->rocks : 0},
          {"caught_share", share_json(kit.caught)},
          {"above", kit.above},
          {"through", kit.through},
          {"beside", kit.beside},
          {"cost", kit.cost}};
}

}  // namespace

std::string limit_text(const DesignPlan& plan, const KitChoice& kit) {
  const auto of_all = [&](std::uint64_t rocks) {
    return fmt::format("{} of {}", grouped(rocks), grouped(kit.caught ? kit.caught->of : 0));
  };
  switch (kit.limit) {
    case KitLimit::none:
      break;
    case KitLimit::ends:
      return fmt::format("{} pass beyond the ends of the line: lengthen it", of_all(kit.beside));
    case KitLimit::height:
      return fmt::format("{} pass above {:g} m: give greater heights_m", of_all(kit.above), kit.height);
    case KitLimit::energy:
      return fmt::format("{} have more than {:g} kJ: give greater energies_kJ", of_all(kit.through),
                         plan.energies.back() / 1000);
  }
  return "";
}

Json design_json(const DesignPlan& plan, const DesignResult& result) {
  Json lines = Json::array();
  for (std::size_t k = 0; k < plan.lines.size(); ++k) {
    Json line{{"name", plan.lines[k].name}, {"length_m", plan.lines[k].length}};
    line.update(figures_json(plan, result.lines[k].whole));
    Json& sections = line["sections"] = Json::array();
    for (const DesignFigures& section : result.lines[k].sections) sections.push_back(figures_json(plan, section));
    lines.push_back(std::move(line));
  }
  Json ranking = Json::array();
  for (const KitChoice& kit : result.ranking) ranking.push_back(choice_json(plan, kit));
  const bool is_possible = !result.ranking.empty() && result.ranking.front().suffices;
  return {{"standard", plan.standard.empty() ? Json(nullptr) : Json(plan.standard)},
          {"factors", factors_json(plan.factors)},
          {"design_percentile", plan.design_percentile},
          {"confidence", plan.confidence},
          {"catch_share", plan.catch_share},
          {"lines", std::move(lines)},
          {"best", is_possible ? ranking.front() : Json(nullptr)},
          {"ranking", std::move(ranking)}};
}

}  // namespace talus
