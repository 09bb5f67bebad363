#include "talus/lines/what_if_factors.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "talus/core/nearest.hpp"
#include "talus/model/rock_models.hpp"
#include "talus/project/echo.hpp"
#include "talus/project/settings.hpp"
#include "talus/project/words.hpp"
#include "talus/sampling/distribution.hpp"

namespace talus::what_if {

namespace {

using Json = nlohmann::ordered_json;
using project::Material;
using project::Project;

/// A multiplied number within the range of its setting.
double within(const project::Range& range, double value, bool& is_clipped) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const double least = range.least_excluded ? std::nextafter(range.least, infinite) : range.least;
  const double most = range.most_excluded ? std::nextafter(range.most, -infinite) : range.most;
  const double clipped = std::clamp(value, least, most);
  is_clipped = is_clipped || clipped != value;
  return clipped;
}

bool is_zero(const Distribution& distribution, Moves moves) {
  if (distribution.kind == DistributionKind::empirical) return true;  // of a file: it has no mean to move
  return distribution.mean == 0 && (moves == Moves::mean || distribution.std_dev.value_or(0) == 0);
}

/// Makes one variation.
class Varying {
 public:
  Varying(const Project& before, std::size_t kind, double factor)
      : before_(before), kind_(factor_kinds[kind]), factor_(factor) {
    variation_.kind = kind;
    variation_.factor = factor;
    variation_.project = before;
  }

  void material(std::size_t row) {
    Material& material = variation_.project.materials[row];
    const bool is_sphere = has_extent(before_.analysis.model);
    const auto change = [&](Distribution Material::*member, const char* key) {
      distribution(material.*member, "material", row, key, factor_);
    };
    if (kind_.key == "normal_restitution") change(&Material::normal_restitution, "normal_restitution");
    if (kind_.key == "tangential_restitution") change(&Material::tangential_restitution, "tangential_restitution");
    if (kind_.key == "friction_angle" && !is_sphere) change(&Material::friction_angle_deg, "friction_angle_deg");
    if (kind_.key == "dynamic_friction" && is_sphere) change(&Material::dynamic_friction, "dynamic_friction");
    if (kind_.key == "rolling_friction" && is_sphere) change(&Material::rolling_friction, "rolling_friction");
    if (kind_.key == "roughness") {
      change(&Material::roughness_deg, "roughness_deg");
      if (before_.analysis.has_heights_of_roughness() && material.roughness_amplitude_m > 0) {
        material.roughness_amplitude_m = number(material.roughness_amplitude_m, "material", "roughness_amplitude_m");
        changed("material", row, "roughness_amplitude_m");
      }
    }
    forest_drag(material.forest, material.forest_drag_kg_s, {"material", row, "forest", "forest_drag_kg_s"});
  }

  void forest(std::size_t row) {
    project::ForestArea& forest = variation_.project.forests[row];
    forest_drag(forest.density, forest.drag_kg_s, {"forest", row, "density", "drag_kg_s"});
  }

  void seeder(std::size_t row) {
    if (kind_.key != "mass") return;
    std::optional<project::RockSize>& size = variation_.project.seeders[row].size;
    if (!size) return;
    const double factor = size->of == SizeOf::diameter ? std::cbrt(factor_) : factor_;
    distribution(size->distribution, "seeder", row, size->key(), factor);
  }

  [[nodiscard]] Variation take() {
    variation_.clipped = fmt::format("{}", fmt::join(clipped_, ", "));
    return std::move(variation_);
  }
  /// Why the variation cannot be run; empty: it can.
  [[nodiscard]] const std::string& why_not() const { return why_not_; }

 private:
  struct ForestKeys {
    std::string_view table;
    std::size_t row;
    std::string_view density, drag;
  };
  /// A word for the density becomes the drag that it stands for.
  void forest_drag(Forest& density, std::optional<double>& drag, const ForestKeys& keys) {
    const double before = drag.value_or(talus::forest_drag(density));
    if (kind_.key != "forest_drag" || before == 0) return;
    drag = number(before, keys.table, keys.drag);
    if (std::exchange(density, Forest::none) != Forest::none) changed(keys.table, keys.row, keys.density);
    changed(keys.table, keys.row, keys.drag);
  }

  double number(double value, std::string_view table, std::string_view key) {
    bool is_clipped = false;
    const double result = within(project::setting(table, key).range, value * factor_, is_clipped);
    if (is_clipped) clipped_.push_back(fmt::format("{} at {:.6g}", key, result));
    return result;
  }

  void distribution(Distribution& all, std::string_view table, std::size_t row, std::string_view key, double factor) {
    if (is_zero(all, kind_.moves)) return;
    bool is_clipped = false;
    all.mean = within(project::setting(table, key).range, all.mean * factor, is_clipped);
    if (kind_.moves == Moves::whole) {
      for (std::optional<double>* part : {&all.std_dev, &all.rel_min, &all.rel_max})
        if (*part) **part *= factor;
    }
    changed(table, row, key);
    if (is_clipped)
      clipped_.push_back(fmt::format("{} of {} at {:.6g}", key, variation_.changes.back().name, all.mean));
    if (const auto why = why_unusable(all, project::bounds(table, key)); why && why_not_.empty())
      why_not_ = fmt::format("{} {}", key, *why);
  }

  void changed(std::string_view table, std::size_t row, std::string_view key) {
    const project::Table& of = project::table(table);
    Project before = before_;
    const auto value = [&](Project& project) {
      auto written = project::written(of.find(key)->slot(of.rows(project)[row]), project.is_2d());
      // A plain number is one in the file.
      if (written && written->is_object() && written->value("distribution", "none") == "none")
        *written = Json(written->at("mean"));
      if (written && *written == "none") written.reset();
      return written;
    };
    const std::string& name = table == "material" ? before_.materials[row].name
                              : table == "forest" ? before_.forests[row].name
                                                  : before_.seeders[row].name;
    variation_.changes.push_back(
        {std::string(table), std::string(key), row, name, value(before), value(variation_.project)});
  }

  const Project& before_;
  const FactorKind& kind_;
  const double factor_;
  Variation variation_;
  std::vector<std::string> clipped_;
  std::string why_not_;
};

Varying varied(const Project& project, std::size_t kind, double factor, const std::string& material) {
  Varying varying(project, kind, factor);
  for (std::size_t row = 0; row < project.materials.size(); ++row)
    if (material.empty() || project.materials[row].name == material) varying.material(row);
  for (std::size_t row = 0; row < project.forests.size() && material.empty(); ++row) varying.forest(row);
  for (std::size_t row = 0; row < project.seeders.size(); ++row) varying.seeder(row);
  return varying;
}

/// The steps to take; problems of the choice are added.
std::vector<std::pair<std::size_t, double>> chosen_steps(const FactorChoice& choice, std::string_view where,
                                                         Problems& problems) {
  std::vector<std::pair<std::size_t, double>> chosen;
  if (!choice.steps)
    for (std::size_t kind = 0; kind < factor_kinds.size(); ++kind)
      chosen.emplace_back(kind, factor_kinds[kind].usual_step);
  for (const Step& step : choice.steps.value_or(std::vector<Step>{})) {
    const auto found = std::ranges::find(factor_kinds, step.key, &FactorKind::key);
    if (found == factor_kinds.end()) {
      std::vector<std::string_view> known;
      for (const FactorKind& kind : factor_kinds) known.push_back(kind.key);
      const auto near = nearest(step.key, known);
      problems.add({.where = std::string(where),
                    .what = fmt::format("there is no factor \"{}\"", step.key),
                    .why = fmt::format("expected {}", fmt::join(known, ", ")),
                    .hint = near ? fmt::format("Did you mean {}?", *near) : ""});
      continue;
    }
    const auto kind = static_cast<std::size_t>(found - factor_kinds.begin());
    if (!(step.share > 0 && step.share < 1)) {
      problems.add({.where = std::string(where),
                    .what = fmt::format("the step of {} is {:g} %", step.key, 100 * step.share),
                    .why = "expected a share of the value, above 0 and below 100 %"});
    } else if (std::ranges::count(chosen, kind, &std::pair<std::size_t, double>::first) > 0) {
      problems.add({.where = std::string(where),
                    .what = fmt::format("{} is given twice", step.key),
                    .why = "a factor has one step"});
    } else {
      chosen.emplace_back(kind, step.share);
    }
  }
  return chosen;
}

void check_material(const Project& project, const std::string& name, std::string_view where, Problems& problems) {
  if (name.empty()) return;
  std::vector<std::string_view> names;
  for (const Material& material : project.materials) names.push_back(material.name);
  if (std::ranges::count(names, name) > 0) return;
  const auto near = nearest(name, names);
  problems.add({.where = std::string(where),
                .what = fmt::format("there is no material \"{}\"", name),
                .why = fmt::format("the project has {}", fmt::join(names, ", ")),
                .hint = near ? fmt::format("Did you mean \"{}\"?", *near) : ""});
}

/// Says what the step of the mass leaves as it is.
void warn_of_other_sizes(const Project& project, Problems& warnings) {
  for (const project::Seeder& seeder : project.seeders) {
    if (seeder.size && seeder.size->distribution.kind != DistributionKind::empirical) continue;
    warnings.add({.severity = Severity::warning,
                  .where = fmt::format("seeder \"{}\"", seeder.name),
                  .what = "keeps the sizes of its rocks",
                  .why = "they are those of a file, which a step does not change"});
  }
}

/// Says which materials have the default friction, of the project's own model and of others. Once for models that lack
/// the same.
void warn_of_default_friction(const Project& project, const std::vector<Variation>& others, Problems& warnings) {
  const auto warn = [&](const std::string& as, const std::vector<std::string>& names, const char* otherwise) {
    if (names.empty()) return;
    warnings.add({.severity = Severity::warning,
                  .what = fmt::format("{}{} {} the default friction", as, fmt::join(names, ", "),
                                      names.size() == 1 ? "has" : "have"),
                  .why = "nobody has chosen it",
                  .hint = fmt::format("Give the materials their friction (talus materials), or {}", otherwise)});
  };
  warn("", project::materials_of_default_friction(project), "say why it suits the ground");
  std::map<std::vector<std::string>, std::vector<std::string_view>> models;
  for (const Variation& other : others)
    models[project::materials_of_default_friction(other.project)].push_back(project::name_of(*other.model));
  for (const auto& [names, of] : models)
    warn(fmt::format("as {}, ", fmt::join(of, " and ")), names, "take their figures as a bound");
}

/// The other rock models.
std::vector<Variation> other_models(const Project& project, Problems& warnings) {
  std::vector<Variation> others;
  for (const RockModel model : {RockModel::lumped_mass, RockModel::rigid_sphere, RockModel::rigid_body}) {
    if (model == project.analysis.model) continue;
    Variation variation{.model = model, .kind = 0, .factor = 1, .project = project::with_rock_model(project, model)};
    variation.changes.push_back(
        {"analysis", "model", 0, "", Json(project::word(project.analysis.model)), Json(project::word(model))});
    for (std::size_t row = 0; row < project.seeders.size(); ++row) {
      const project::Seeder &before = project.seeders[row], &after = variation.project.seeders[row];
      if (before.shape != after.shape)
        variation.changes.push_back({"seeder", "shape", row, before.name, Json(before.shape), Json(after.shape)});
    }
    others.push_back(std::move(variation));
  }
  warn_of_default_friction(project, others, warnings);
  return others;
}

std::string text_of(const std::optional<Json>& value) {
  if (!value) return "none";
  if (value->is_object()) {
    std::string text;
    for (const auto& [key, part] : value->items()) {
      if (key == "distribution") continue;
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", key,
                          part.is_number() ? fmt::format("{:.4g}", part.get<double>()) : part.dump());
    }
    return "{" + text + "}";
  }
  return value->is_number() ? fmt::format("{:.4g}", value->get<double>()) : value->get<std::string>();
}

}  // namespace

std::string_view key_of(const Variation& variation) {
  return variation.model ? "model" : factor_kinds[variation.kind].key;
}

std::string_view title_of(const Variation& variation) {
  return variation.model ? "Rock model" : factor_kinds[variation.kind].title;
}

std::optional<double> percent_of(const Variation& variation) {
  if (variation.model) return std::nullopt;
  constexpr double digits = 1e9;
  return std::round(digits * 100 * (variation.factor - 1)) / digits;
}

std::string step_text(const Variation& variation) {
  return variation.model ? std::string(project::name_of(*variation.model))
                         : fmt::format("{:+.4g} %", *percent_of(variation));
}

std::string changes_text(const Variation& variation) {
  std::string text;
  std::optional<Json> forest;  // the word that a drag replaces
  for (const Change& change : variation.changes) {
    if (change.key == "forest" || change.key == "density") {
      forest = change.before;
      continue;
    }
    text += fmt::format("{}{}{}{} to {}", text.empty() ? "" : "; ", change.name, change.name.empty() ? "" : " ",
                        text_of(change.before ? change.before : std::exchange(forest, {})), text_of(change.after));
  }
  return text;
}

std::string path_of(const Change& change) {
  return project::table(change.table).repeated ? fmt::format("{}.{}.{}", change.table, change.row, change.key)
                                               : fmt::format("{}.{}", change.table, change.key);
}

Variation vary(const Project& project, std::size_t kind, double factor, const std::string& material) {
  return varied(project, kind, factor, material).take();
}

Project applied(const Variation& variation, const Project& to, const std::string& material) {
  return variation.model ? project::with_rock_model(to, *variation.model)
                         : vary(to, variation.kind, variation.factor, material).project;
}

std::vector<std::size_t> kinds_of(const Project& project, const std::string& material, std::string_view where) {
  Problems problems;
  check_material(project, material, where, problems);
  if (problems.has_errors()) throw BadInput(std::move(problems));
  std::vector<std::size_t> kinds;
  for (std::size_t kind = 0; kind < factor_kinds.size(); ++kind)
    if (!vary(project, kind, 1 + factor_kinds[kind].usual_step, material).changes.empty()) kinds.push_back(kind);
  return kinds;
}

std::vector<Variation> variations_of(const Project& project, const FactorChoice& choice, std::string_view where,
                                     Problems& warnings) {
  Problems problems;
  const auto steps = chosen_steps(choice, where, problems);
  check_material(project, choice.material, where, problems);
  if (problems.has_errors()) throw BadInput(std::move(problems));
  std::vector<Variation> variations;
  if (choice.models) variations = other_models(project, warnings);
  for (const auto& [kind, share] : steps) {
    for (const double factor : {1 - share, 1 + share}) {
      Varying one = varied(project, kind, factor, choice.material);
      Variation variation = one.take();
      if (variation.changes.empty()) {
        if (factor > 1 || !choice.steps) continue;
        problems.add({.where = std::string(where),
                      .what = fmt::format("this project has no {}", factor_kinds[kind].key),
                      .why = "it is not given, 0, from a file, or not of its rock model"});
      } else if (!one.why_not().empty()) {
        warnings.add({.severity = Severity::warning,
                      .where = std::string(where),
                      .what = fmt::format("{} {} is left out", factor_kinds[kind].title, step_text(variation)),
                      .why = one.why_not()});
      } else {
        if (factor_kinds[kind].key == "mass" && factor > 1) warn_of_other_sizes(project, warnings);
        variations.push_back(std::move(variation));
      }
    }
  }
  if (problems.has_errors()) throw BadInput(std::move(problems));
  if (variations.empty()) {
    throw BadInput(Problem{
        .where = std::string(where), .what = "there is nothing to vary", .why = "the project has none of the factors"});
  }
  return variations;
}

}  // namespace talus::what_if
