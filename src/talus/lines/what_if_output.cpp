#include "talus/lines/what_if_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "talus/archive/design_json.hpp"
#include "talus/core/problems.hpp"
#include "talus/project/words.hpp"

namespace talus::what_if {

namespace {

using Json = nlohmann::ordered_json;

std::optional<double> value_of(const std::optional<Estimate>& estimate) {
  return estimate ? std::optional(estimate->value) : std::nullopt;
}

/// How the figures of a row are named: share_change_low, energy_change_low_J.
struct FigureName {
  std::string_view name, unit_in_name, unit, meaning;
};
constexpr FigureName share_name{"share", "", "", "share of the rocks that cross"};
constexpr FigureName check_energy{"energy", "_J", "J", "design percentile of the energy that the check takes"};
constexpr std::array<FigureName, MemberValues::quantities> quantity_names{
    {{"ke_translational", "_J", "J", "design percentile of the translational energy"},
     {"ke_total", "_J", "J", "design percentile of the total energy"},
     {"height", "_m", "m", "design percentile of the height of the block's top; in a polygon, of the bounce height"},
     {"velocity", "_m_s", "m/s", "design percentile of the velocity"}}};

/// The columns of the table: of the energies the one that the check takes.
struct Column {
  FigureName name;
  std::optional<Asked> of;  // nullopt: the share
};
std::array<Column, 4> columns_of(Asked energy) {
  return {{{share_name, std::nullopt},
           {check_energy, energy},
           {quantity_names[place_of(Asked::height)], Asked::height},
           {quantity_names[place_of(Asked::velocity)], Asked::velocity}}};
}

std::vector<std::string> names_of_figures() {
  std::vector<std::string> names;
  for (const ColumnText& column : WhatIfRow::family_texts()) names.push_back(column.name);
  return names;
}

WhatIfRow row_of(const Answer& answer, Asked energy, const Figures& figures, const Differences& differences) {
  WhatIfRow row;
  row.rocks = answer.rocks;
  row.crossing = figures.rocks;
  const auto add = [&](const std::optional<Estimate>& estimate) {
    const Estimate known = estimate.value_or(Estimate{});
    row.figures.push_back(estimate ? std::optional(known.value) : std::nullopt);
    row.figures.insert(row.figures.end(), {known.low, known.high});
  };
  for (const Column& column : columns_of(energy)) {
    add(column.of ? figures.percentile[place_of(*column.of)] : estimate_of(figures.share));
    add(column.of ? differences.percentile[place_of(*column.of)] : differences.share);
  }
  if (const auto& demand = figures.demand) {
    row.needs_mel_kJ = demand->maximum_energy / 1000;
    row.needs_class = static_cast<std::uint64_t>(demand->kit_class);
    row.needs_height_m = demand->height;
  }
  row.runout_median_m = value_of(figures.runout_median);
  row.runout_m = value_of(figures.runout);
  row.left = value_of(estimate_of(figures.left));
  return row;
}

Json json_of(const std::optional<Estimate>& estimate) {
  if (!estimate) return nullptr;
  const auto or_null = [](const std::optional<double>& value) { return value ? Json(*value) : Json(); };
  return {estimate->value, or_null(estimate->low), or_null(estimate->high)};
}

Json json_of(const std::optional<Estimate>& share,
             const std::array<std::optional<Estimate>, MemberValues::quantities>& percentiles, Asked energy) {
  const auto key_of = [](const FigureName& name) { return fmt::format("{}{}", name.name, name.unit_in_name); };
  Json json{{"share", json_of(share)}, {key_of(check_energy), json_of(percentiles[place_of(energy)])}};
  for (std::size_t q = 0; q < percentiles.size(); ++q) json[key_of(quantity_names[q])] = json_of(percentiles[q]);
  return json;
}

Json json_of(const Figures& figures, Asked energy) {
  Json json{{"rocks", figures.rocks}};
  json.update(json_of(estimate_of(figures.share), figures.percentile, energy));
  json["needs"] = demand_json(figures.demand);
  json["needs_at_upper_end"] = demand_json(figures.demand_at_upper_end);
  json["runout_median_m"] = json_of(figures.runout_median);
  json["runout_m"] = json_of(figures.runout);
  json["left"] = json_of(estimate_of(figures.left));
  return json;
}

Json json_of(const Differences& differences, Asked energy) {
  Json json{{"gained", differences.gained}, {"lost", differences.lost}};
  json.update(json_of(differences.share, differences.percentile, energy));
  return json;
}

std::optional<Estimate> or_zero(const std::optional<RockShare>& share) {
  return share ? estimate_of(share) : Estimate{0, 0, 0};
}

/// By the names of the figures in an answer, those in which another model differs from the project's own by more than
/// chance. A share of no rock is zero; other figures of no rock are not compared.
Json disagreements_json(const WhatIf& what_if, const Answer& answer) {
  Json list = Json::array();
  for (std::size_t k = 0; k < answer.variations.size(); ++k) {
    const Variation& variation = what_if.variations()[k];
    if (!variation.model) continue;
    const Figures& other = answer.variations[k].figures;
    const auto compare = [&](std::string figure, const std::optional<Estimate>& own,
                             const std::optional<Estimate>& its) {
      if (own && its && are_apart(*own, *its))
        list.push_back({{"model", project::word(*variation.model)}, {"figure", std::move(figure)}});
    };
    if (!std::holds_alternative<std::monostate>(what_if.place()))
      compare("share", or_zero(answer.base.share), or_zero(other.share));
    for (std::size_t q = 0; q < quantity_names.size(); ++q)
      compare(fmt::format("{}{}", quantity_names[q].name, quantity_names[q].unit_in_name), answer.base.percentile[q],
              other.percentile[q]);
    compare("runout_m", answer.base.runout, other.runout);
    compare("left", or_zero(answer.base.left), or_zero(other.left));
  }
  return list;
}

/// The shapes of blocks of a model that has any, each once; `sphere` for a seeder without one.
Json shapes_json(const Variation& variation) {
  Json shapes = Json::array();
  if (variation.model != RockModel::rigid_body) return shapes;
  for (const project::Seeder& seeder : variation.project.seeders) {
    if (std::ranges::count(shapes, Json(seeder.shape)) == 0) shapes.push_back(seeder.shape);
  }
  return shapes;
}

Json json_of(const Change& change) {
  return {{"path", {change.table, change.row, change.key}},
          {"name", change.name},
          {"before", change.before.value_or(nullptr)},
          {"after", change.after.value_or(nullptr)}};
}

}  // namespace

std::vector<ColumnText> WhatIfRow::family_texts() {
  std::vector<ColumnText> texts;
  for (const Column& column : columns_of(Asked::energy_translational)) {
    const FigureName& figure = column.name;
    const auto add = [&](const char* part, std::string meaning) {
      texts.push_back({fmt::format("{}{}{}", figure.name, part, figure.unit_in_name), std::string(figure.unit),
                       std::move(meaning)});
    };
    add("", std::string(figure.meaning));
    add("_low", "lower end of its confidence interval");
    add("_high", "upper end");
    add("_change", fmt::format("{} minus that of the base", figure.name));
    add("_change_low", "lower end of its confidence interval, for the same rocks");
    add("_change_high", "upper end");
  }
  return texts;
}

std::string table_of(const WhatIf& what_if, const Answer& answer) {
  std::string text = header_of<WhatIfRow>(names_of_figures());
  WhatIfRow base = row_of(answer, what_if.energy(), answer.base, {});
  base.factor = "base";
  append_row(text, base);
  for (std::size_t k = 0; k < answer.variations.size(); ++k) {
    const Variation& variation = what_if.variations()[k];
    const auto& [figures, differences] = answer.variations[k];
    WhatIfRow row = row_of(answer, what_if.energy(), figures, differences);
    row.factor = key_of(variation);
    row.step_percent = percent_of(variation);
    row.changes = changes_text(variation);
    row.clipped = variation.clipped;
    row.gained = differences.gained;
    row.lost = differences.lost;
    append_row(text, row);
  }
  return text;
}

Json json_of(const WhatIf& what_if, const Answer& answer) {
  Json json{{"rocks", answer.rocks},
            {"planned", answer.planned},
            {"percentile", what_if.percentile()},
            {"confidence", what_if.confidence()},
            {"energy", what_if.takes_total_energy() ? "total" : "translational"},
            {"standard", what_if.standard().empty() ? Json() : Json(what_if.standard())},
            {"model", project::word(what_if.rock_model())},
            {"base", json_of(answer.base, what_if.energy())},
            {std::string(word(ProblemKind::models_disagree)), disagreements_json(what_if, answer)}};
  Json& list = json["variations"] = Json::array();
  for (std::size_t k = 0; k < answer.variations.size(); ++k) {
    const Variation& variation = what_if.variations()[k];
    Json changes = Json::array();
    for (const Change& change : variation.changes) changes.push_back(json_of(change));
    const auto percent = percent_of(variation);
    Json one{{"factor", key_of(variation)},
             {"title", title_of(variation)},
             {"step_percent", percent ? Json(*percent) : Json()},
             {"text", changes_text(variation)},
             {"clipped", variation.clipped},
             {"changes", std::move(changes)}};
    if (variation.model) {
      one["model"] = project::word(*variation.model);
      one["shapes"] = shapes_json(variation);
    }
    one.update(json_of(answer.variations[k].figures, what_if.energy()));
    one["difference"] = json_of(answer.variations[k].differences, what_if.energy());
    list.push_back(std::move(one));
  }
  return json;
}

}  // namespace talus::what_if
