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

std::optional<double> optional_number(const Json& json) {
  return json.is_null() ? std::nullopt : std::optional(json.get<double>());
}

CheckFactors factors_from(const Json& json) {
  CheckFactors factors;
  json.at("velocity").get_to(factors.velocity);
  json.at("height").get_to(factors.height);
  json.at("mass").get_to(factors.mass);
  json.at("energy").get_to(factors.energy);
  json.at("capacity").get_to(factors.capacity);
  factors.elongation = optional_number(json.at("elongation"));
  json.at("clearance_m").get_to(factors.clearance);
  json.at("clears_half_the_block").get_to(factors.clears_half_the_block);
  json.at("of_total_energy").get_to(factors.takes_total_energy);
  factors.level = json.at("level") == "SEL" ? KitLevel::service : KitLevel::maximum;
  factors.block_mass = optional_number(json.at("block_mass_kg"));
  return factors;
}

std::vector<AppliedFactor> applied_from(const Json& json) {
  std::vector<AppliedFactor> applied;
  for (const Json& given : json) {
    AppliedFactor& factor = applied.emplace_back();
    given.at("symbol").get_to(factor.symbol);
    given.at("key").get_to(factor.key);
    given.at("multiplies").get_to(factor.multiplies);
    given.at("value").get_to(factor.value);
    given.at("source").get_to(factor.source);
    given.at("not_read").get_to(factor.not_read);
  }
  return applied;
}

bool rises(const std::vector<double>& values) {
  return std::ranges::adjacent_find(values, std::greater_equal<>()) == values.end();
}

Json pieces_json(const std::vector<LinePiece>& pieces) {
  Json list = Json::array();
  for (const LinePiece& piece : pieces) list.push_back({piece.station, piece.along_x, piece.along_y});
  return list;
}

Json kits_json(const std::vector<DesignKit>& kits) {
  Json list = Json::array();
  for (const DesignKit& kit : kits) {
    list.push_back({{"name", kit.name},
                    {"heights_m", kit.heights},
                    {"energy_J", kit.maximum_energy},
                    {"checked_energy_J", kit.checked_energy},
                    {"elongation_m", optional_json(kit.elongation)},
                    {"residual_share", optional_json(kit.residual_share)},
                    {"cost_per_m", optional_json(kit.cost_per_metre)}});
  }
  return list;
}

std::vector<DesignKit> kits_from(const Json& json) {
  std::vector<DesignKit> kits;
  for (const Json& given : json) {
    DesignKit& kit = kits.emplace_back();
    given.at("name").get_to(kit.name);
    given.at("heights_m").get_to(kit.heights);
    given.at("energy_J").get_to(kit.maximum_energy);
    given.at("checked_energy_J").get_to(kit.checked_energy);
    kit.elongation = optional_number(given.at("elongation_m"));
    kit.residual_share = optional_number(given.at("residual_share"));
    kit.cost_per_metre = optional_number(given.at("cost_per_m"));
  }
  return kits;
}

Json pairs_json(const std::vector<DesignPair>& pairs) {
  Json list = Json::array();
  for (const DesignPair& pair : pairs) {
    list.push_back({{"lines", {pair.one, pair.other}},
                    {"overlap_m", optional_json(pair.overlap)},
                    {"distance_m", optional_json(pair.distance)}});
  }
  return list;
}

std::vector<DesignPair> pairs_from(const Json& json) {
  std::vector<DesignPair> pairs;
  for (const Json& given : json) {
    pairs.push_back({given.at("lines").at(0).get<std::uint32_t>(), given.at("lines").at(1).get<std::uint32_t>(),
                     optional_number(given.at("overlap_m")), optional_number(given.at("distance_m"))});
  }
  return pairs;
}

bool is_among(const std::vector<double>& ascending, double value) {
  return std::ranges::binary_search(ascending, value);
}

/// Whether rocks are counted by everything that a kit is compared with.
bool are_counted(const DesignPlan& plan, const DesignKit& kit) {
  const double residual = kit.residual_share.value_or(0);
  return is_among(plan.energies, kit.checked_energy) && std::ranges::all_of(kit.heights, [&](double height) {
           return is_among(plan.heights, height) && (residual == 0 || is_among(plan.heights, height * residual));
         });
}

bool pairs_are_possible(const DesignPlan& plan) {
  const auto classes = static_cast<double>(plan.kit_classes() + 1);
  return static_cast<double>(plan.pairs.size()) * classes * classes <=
             static_cast<double>(DesignPlan::most_pair_counts) &&
         std::ranges::all_of(plan.pairs, [&](const DesignPair& pair) {
           return pair.one < pair.other && pair.other < plan.lines.size();
         });
}

}  // namespace

Json applied_json(const std::vector<AppliedFactor>& applied) {
  Json list = Json::array();
  for (const AppliedFactor& factor : applied) {
    list.push_back({{"symbol", factor.symbol},
                    {"key", factor.key},
                    {"multiplies", factor.multiplies},
                    {"value", factor.value},
                    {"source", factor.source},
                    {"not_read", factor.not_read}});
  }
  return list;
}

Json factors_json(const CheckFactors& factors) {
  return {{"velocity", factors.velocity},
          {"height", factors.height},
          {"mass", factors.mass},
          {"energy", factors.energy},
          {"capacity", factors.capacity},
          {"elongation", optional_json(factors.elongation)},
          {"clearance_m", factors.clearance},
          {"clears_half_the_block", factors.clears_half_the_block},
          {"of_total_energy", factors.takes_total_energy},
          {"level", factors.level == KitLevel::service ? "SEL" : "MEL"},
          {"block_mass_kg", optional_json(factors.block_mass)}};
}

Json plan_json(const DesignPlan& plan) {
  Json lines = Json::array();
  for (const DesignLine& line : plan.lines) {
    lines.push_back({{"name", line.name},
                     {"barrier", line.barrier},
                     {"from_m", line.start},
                     {"length_m", line.length},
                     {"section_m", line.section_length},
                     {"sections", line.sections},
                     {"pieces", pieces_json(line.pieces)},
                     {"clearances_m", line.clearances}});
  }
  return {{"lines", std::move(lines)},
          {"protect", optional_json(plan.protect)},
          {"free_end_m", plan.free_end},
          {"confidence", plan.confidence},
          {"percentiles", plan.percentiles},
          {"design_percentile", plan.design_percentile},
          {"standard", plan.standard},
          {"standard_not_read", plan.standard_not_read},
          {"applied", applied_json(plan.applied)},
          {"factors", factors_json(plan.factors)},
          {"heights_m", plan.heights},
          {"energies_J", plan.energies},
          {"kits", kits_json(plan.kits)},
          {"pairs", pairs_json(plan.pairs)},
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
    for (const Json& piece : given.at("pieces")) {
      line.pieces.push_back({piece.at(0).get<double>(), piece.at(1).get<double>(), piece.at(2).get<double>()});
    }
    given.at("clearances_m").get_to(line.clearances);
    expect_bytes(line.clearances.empty() || line.clearances.size() == line.sections, damaged);
    expect_bytes(line.barrier < barriers && line.sections > 0 && line.sections <= DesignPlan::most_sections &&
                     (line.sections == 1 || line.section_length > 0),
                 damaged);
  }
  if (const Json& protect = json.at("protect"); !protect.is_null()) plan.protect = protect.get<std::uint32_t>();
  json.at("free_end_m").get_to(plan.free_end);
  json.at("confidence").get_to(plan.confidence);
  json.at("percentiles").get_to(plan.percentiles);
  json.at("design_percentile").get_to(plan.design_percentile);
  json.at("standard").get_to(plan.standard);
  json.at("standard_not_read").get_to(plan.standard_not_read);
  plan.applied = applied_from(json.at("applied"));
  plan.factors = factors_from(json.at("factors"));
  json.at("heights_m").get_to(plan.heights);
  json.at("energies_J").get_to(plan.energies);
  plan.kits = kits_from(json.at("kits"));
  plan.pairs = pairs_from(json.at("pairs"));
  json.at("catch_share").get_to(plan.catch_share);
  json.at("cost_height_exponent").get_to(plan.cost.height_exponent);
  json.at("cost_energy_exponent").get_to(plan.cost.energy_exponent);
  const auto is_percentage = [](double p) { return p >= 0 && p <= 100; };
  expect_bytes((!plan.protect || *plan.protect < barriers) && rises(plan.heights) && rises(plan.energies) &&
                   plan.confidence > 0 && plan.confidence < 1 && is_percentage(plan.design_percentile) &&
                   std::ranges::all_of(plan.percentiles, is_percentage) && pairs_are_possible(plan) &&
                   std::ranges::all_of(plan.kits, [&](const DesignKit& kit) { return are_counted(plan, kit); }),
               damaged);
  return plan;
}

Json share_json(const std::optional<RockShare>& share) {
  if (!share) return nullptr;
  return {{"value", share->value}, {"low", share->low}, {"high", share->high}};
}

namespace {

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

const char* limit_name(KitLimit limit) {
  switch (limit) {
    case KitLimit::none:
      return nullptr;
    case KitLimit::clearance:
      return "clearance";
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
          {"cost", kit.cost},
          {"kit", kit.kit ? Json(plan.kits[*kit.kit].name) : Json(nullptr)},
          {"needs_clearance_m", optional_json(kit.needed_clearance)},
          {"clearance_m", optional_json(kit.clearance)},
          {"residual_height_m", optional_json(kit.residual_height)},
          {"below_residual_share", share_json(kit.below_residual)}};
}

Json pair_kit_json(const DesignPlan& plan, const PairKit& kit) {
  return {{"line", plan.lines[kit.line].name},
          {"kit", kit.kit ? Json(plan.kits[*kit.kit].name) : Json(nullptr)},
          {"height_m", kit.height},
          {"energy_J", kit.maximum_energy}};
}

Json pair_json(const DesignPlan& plan, const PairChoice& choice) {
  const DesignPair& pair = plan.pairs[choice.pair];
  return {{"first", pair_kit_json(plan, choice.first)},
          {"second", pair_kit_json(plan, choice.second)},
          {"suffices", choice.suffices},
          {"sure", choice.is_sure},
          {"rocks", choice.caught ? choice.caught->of : 0},
          {"caught", choice.caught ? choice.caught->rocks : 0},
          {"caught_share", share_json(choice.caught)},
          {"caught_by_first", choice.by_first},
          {"at_second", choice.at_second},
          {"caught_by_second", choice.by_second},
          {"beside", choice.beside},
          {"cost", choice.cost},
          {"overlap_m", optional_json(pair.overlap)},
          {"distance_m", optional_json(pair.distance)},
          {"needs_overlap_m", optional_json(choice.needed_overlap)}};
}

}  // namespace

std::string grouped(std::uint64_t count) {
  return count < 1000 ? fmt::format("{}", count) : fmt::format("{},{:03}", grouped(count / 1000), count % 1000);
}

Json demand_json(const std::optional<KitDemand>& demand) {
  if (!demand) return nullptr;
  return {{"energy_J", demand->maximum_energy}, {"class", demand->kit_class}, {"height_m", demand->height}};
}

Json figures_json(const DesignPlan& plan, const DesignFigures& figures) {
  Json percentiles;
  for (std::size_t k = 0; k < shown_quantity_count; ++k)
    percentiles[key_of(design_quantities[k])] = percentiles_json(plan, figures.percentiles[k]);
  return {{"from_m", figures.from},
          {"to_m", figures.to},
          {"rocks", figures.rocks},
          {"share", share_json(figures.share)},
          {"percentiles", std::move(percentiles)},
          {"needs", demand_json(figures.demand)},
          {"needs_at_upper_end", demand_json(figures.demand_at_upper_end)},
          {"largest_block_m", optional_json(figures.largest_block)},
          {"lateral", optional_json(figures.lateral)},
          {"clearance_m", optional_json(figures.clearance)},
          {"most_elongation_m", optional_json(figures.most_elongation)}};
}

std::string limit_text(const DesignPlan& plan, const KitChoice& kit) {
  const auto of_all = [&](std::uint64_t rocks) {
    return fmt::format("{} of {}", grouped(rocks), grouped(kit.caught ? kit.caught->of : 0));
  };
  switch (kit.limit) {
    case KitLimit::none:
      break;
    case KitLimit::clearance:
      return fmt::format(
          "its net needs {:.3g} m to what is protected, and there are {:.3g} m: choose one that elongates "
          "less, or move the line",
          *kit.needed_clearance, *kit.clearance);
    case KitLimit::ends:
      return fmt::format("{} pass beyond the ends of the line: lengthen it", of_all(kit.beside));
    case KitLimit::height:
      return fmt::format("{} reach above {:g} m: give {}", of_all(kit.above), kit.height,
                         kit.kit ? "higher kits" : "greater heights_m");
    case KitLimit::energy:
      if (kit.kit) {
        return fmt::format("{} have more energy than the kit may have: give stronger kits", of_all(kit.through));
      }
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
  Json pairs = Json::array();
  for (const PairChoice& pair : result.pairs) pairs.push_back(pair_json(plan, pair));
  const bool is_possible = !result.ranking.empty() && result.ranking.front().suffices;
  return {{"standard", plan.standard.empty() ? Json(nullptr) : Json(plan.standard)},
          {"factors", factors_json(plan.factors)},
          {"applied_factors", applied_json(plan.applied)},
          {"standard_not_read", plan.standard_not_read},
          {"design_percentile", plan.design_percentile},
          {"confidence", plan.confidence},
          {"catch_share", plan.catch_share},
          {"lines", std::move(lines)},
          {"best", is_possible ? ranking.front() : Json(nullptr)},
          {"ranking", std::move(ranking)},
          {"free_end_m", plan.free_end},
          {"pairs", std::move(pairs)}};
}

}  // namespace talus
