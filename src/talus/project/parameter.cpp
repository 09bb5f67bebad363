#include "talus/project/parameter.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <type_traits>

#include "talus/core/nearest.hpp"
#include "talus/project/echo.hpp"
#include "talus/project/setting_paths.hpp"

namespace talus::project {

namespace {

/// Settings that a prepared site takes from the numbers alone.
constexpr std::array tables_of_numbers{"material", "forest", "analysis", "seeder", "shape", "barrier"};
constexpr std::array fixed_settings{"seeder.rocks",
                                    "seeder.rocks_per_cell",
                                    "seeder.cell_m",
                                    "seeder.mask_value",
                                    "seeder.min_slope_deg",
                                    "seeder.max_slope_deg",
                                    "seeder.height_above_m",
                                    "shape.corners",
                                    "shape.power",
                                    "shape.sides",
                                    "shape.length_ratio",
                                    "barrier.height_m",
                                    "barrier.inclination_deg",
                                    "barrier.normal_restitution",
                                    "barrier.tangential_restitution",
                                    "analysis.energy_datum_m"};
/// Of [[forest]], all but its place.
constexpr std::array<std::string_view, 3> of_forests{"density", "drag_kg_s", "height_m"};
constexpr const char* allowed =
    "a study varies numbers of [[material]], [[forest]] and [analysis], sizes and velocities of [[seeder]], b_over_a "
    "and c_over_b of [[shape]], and capacity_kJ of [[barrier]]";

/// The number in a member, or the distribution around it; both null if it is another kind of member or is not set.
struct Place {
  double* number = nullptr;
  Distribution* distribution = nullptr;
  bool is_number = false;  // of a kind that has numbers
};

Place place_of(const Slot& slot) {
  if (auto* const* const number = std::get_if<double*>(&slot)) return {*number, nullptr, true};
  if (auto* const* const number = std::get_if<std::optional<double>*>(&slot))
    return {**number ? &***number : nullptr, nullptr, true};
  return {nullptr, distribution_in(slot), is_random_property(slot)};
}

/// Of a row of a table whose rows have names; else empty.
std::string name_of(const Table& table, const Row& row) {
  const Setting* const name = table.find("name");
  const auto* const text = name == nullptr ? nullptr : std::get<std::string*>(name->slot(row));
  return text == nullptr ? "" : *text;
}

/// The rows of `table` that a part of a path names: `*`, a name or a zero-based number.
std::vector<std::size_t> rows_named(const Table& table, const std::vector<Row>& rows, const std::string& part) {
  std::vector<std::size_t> found;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (part == "*" || name_of(table, rows[k]) == part) found.push_back(k);
  }
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), number);
  if (found.empty() && error == std::errc{} && end == part.data() + part.size() && number < rows.size()) {
    found.push_back(number);
  }
  return found;
}

std::string names_of(const Table& table, const std::vector<Row>& rows) {
  std::string names;
  for (const Row& row : rows) names += fmt::format("{}\"{}\"", names.empty() ? "" : ", ", name_of(table, row));
  return names.empty() ? "there are none" : "the project has " + names;
}

}  // namespace

Prior::Prior(const Distribution& distribution, Bounds legal)
    : distribution_(distribution), sampler_(distribution, legal) {}

Prior Prior::uniform(double least, double most) {
  const double half = (most - least) / 2;
  Prior prior({least + half, DistributionKind::uniform, std::nullopt, half, half}, {least, most});
  return prior;
}

double Prior::value(double u) const {
  constexpr double edge = 1e-12;  // draws are defined between 0 and 1
  return sampler_.draw(std::clamp(u, edge, 1 - edge));
}

double Prior::share_below(double wanted) const {
  double low = 0, high = 1;
  if (wanted <= value(low)) return low;
  if (wanted >= value(high)) return high;
  constexpr double accuracy = 1e-12;
  while (high - low > accuracy) {
    const double middle = (low + high) / 2;
    (value(middle) < wanted ? low : high) = middle;
  }
  return (low + high) / 2;
}

std::string Prior::text() const {
  if (distribution_.kind == DistributionKind::uniform) return fmt::format("{:.4g} to {:.4g}", value(0), value(1));
  std::string text = fmt::format("{}, mean {:.4g}", word(distribution_.kind), distribution_.mean);
  if (distribution_.std_dev) text += fmt::format(", std_dev {:.4g}", *distribution_.std_dev);
  return text + fmt::format(", within {:.4g} to {:.4g}", value(0), value(1));
}

bool needs_no_terrain(std::string_view path) {
  const auto parts = parts_of(path);
  if (!parts || parts->size() < 2) return false;
  if (parts->front() == "output") return !(*parts)[1].starts_with("runout_");  // the others are not of the model
  if (std::ranges::find(tables_of_numbers, parts->front()) == tables_of_numbers.end()) return false;
  const Table& owner = project::table(parts->front());
  const std::size_t at = owner.repeated ? 2 : 1;
  if (parts->size() <= at) return false;
  const Setting* setting = owner.find((*parts)[at]);
  if (setting == nullptr ||
      std::ranges::find(fixed_settings, fmt::format("{}.{}", owner.key, setting->key)) != fixed_settings.end())
    return false;
  if (owner.key == "material") return setting->key != "name";
  if (owner.key == "forest") return std::ranges::find(of_forests, setting->key) != of_forests.end();
  if (owner.key == "analysis") return true;
  Project blank;  // of seeders and barriers: sizes, velocities and capacities
  return place_of(setting->slot(owner.add(blank))).is_number;
}

std::optional<SettingNumber> SettingNumber::find(const Project& project, std::string_view path, const Problem& about,
                                                 Problems& problems) {
  const auto refuse = [&](std::string what, std::string why, std::string hint = {}) {
    Problem problem = about;
    problem.what = std::move(what);
    problem.why = std::move(why);
    problem.hint = std::move(hint);
    problems.add(std::move(problem));
    return std::nullopt;
  };
  const auto parts = parts_of(path);
  // Unless the place of the problem says it.
  const std::string which = about.where.find(path) == std::string::npos ? fmt::format("\"{}\" ", path) : "";
  if (!parts || parts->size() < 2) {
    return refuse(which + "is not the path of a setting", "expected table.key or table.name.key",
                  "For example material.Scree.normal_restitution");
  }
  const std::string& table_key = parts->front();
  const auto& all = project::tables();
  const auto table = std::ranges::find(all, table_key, &Table::key);
  if (table == all.end() || table->key.empty() ||
      std::ranges::find(tables_of_numbers, table_key) == tables_of_numbers.end()) {
    const auto near =
        nearest(table_key, std::vector<std::string_view>(tables_of_numbers.begin(), tables_of_numbers.end()));
    return refuse(fmt::format("{}cannot be varied", which), allowed,
                  near ? fmt::format("Did you mean {}?", *near) : "");
  }
  SettingNumber found;
  found.path_ = path;
  found.table_ = &*table;
  Project copy = project;
  const std::vector<Row> rows = table->rows(copy);
  std::size_t next = 1;
  if (table->repeated) {
    found.rows_ = rows_named(*table, rows, (*parts)[next++]);
    if (found.rows_.empty()) {
      return refuse(fmt::format("{}names no [[{}]]", which, table_key), names_of(*table, rows),
                    "Use a name, a number from 0, or * for all");
    }
  } else {
    found.rows_ = {0};
  }
  if (next >= parts->size()) return refuse(fmt::format("{}has no key", which), "expected table.name.key");
  const std::string& key = (*parts)[next++];
  found.setting_ = table->find(key);
  if (found.setting_ == nullptr) {
    std::vector<std::string_view> keys;
    for (const Setting& setting : table->settings) keys.push_back(setting.key);
    const auto near = nearest(key, keys);
    return refuse(fmt::format("{}is no setting", which), fmt::format("{} has no key {}", table->heading(), key),
                  near ? fmt::format("Did you mean {}?", *near) : "");
  }
  const std::string full = fmt::format("{}.{}", table_key, key);
  if (std::ranges::find(fixed_settings, full) != fixed_settings.end()) {
    return refuse(fmt::format("{}cannot be varied", which), allowed);
  }
  found.unit_ = found.setting_->unit;
  found.range_ = found.setting_->range;
  for (const std::size_t row : found.rows_) {
    const Place place = place_of(found.setting_->slot(rows[row]));
    if (!place.is_number) return refuse(fmt::format("{}cannot be varied", which), allowed);
    if (place.number == nullptr && place.distribution == nullptr) {
      return refuse(fmt::format("{}is not given in the project", which), "a study varies numbers that are",
                    "Give it a value there");
    }
    for (const std::string_view other : table->excluded_by(key)) {
      const Place excluding = place_of(table->find(other)->slot(rows[row]));
      const bool is_optional = !std::holds_alternative<Distribution*>(table->find(other)->slot(rows[row])) &&
                               !std::holds_alternative<double*>(table->find(other)->slot(rows[row]));
      if (is_optional && (excluding.number != nullptr || excluding.distribution != nullptr)) {
        return refuse(fmt::format("{}has no effect", which), fmt::format("the project gives {} instead", other));
      }
    }
    if (next < parts->size() && place.distribution == nullptr) {
      return refuse(fmt::format("{} has no parts", fmt::join(parts->begin(), parts->begin() + next, ".")),
                    "it is a plain number");
    }
  }
  if (next < parts->size()) {
    const std::string& part = (*parts)[next++];
    const Setting* of_part = distribution_table().find(part);
    if (part == "std_dev") {
      found.part_ = Part::std_dev;
    } else if (part == "rel_min") {
      found.part_ = Part::rel_min;
    } else if (part == "rel_max") {
      found.part_ = Part::rel_max;
    } else if (part != "mean") {
      return refuse(fmt::format("{}is not a number", which), "expected mean, std_dev, rel_min or rel_max");
    }
    if (found.part_ != Part::whole) found.range_ = of_part->range;
  }
  if (next < parts->size()) return refuse(fmt::format("{}has too many parts", which), "");
  if (found.part_ != Part::whole) {
    for (const std::size_t row : found.rows_) {
      if (place_of(found.setting_->slot(rows[row])).distribution->kind != DistributionKind::none) continue;
      return refuse(fmt::format("{}has no effect", which), "the property is a plain number in the project",
                    "Give it a distribution there");
    }
  }
  if (const auto models = models_of(*found.setting_);
      !models.empty() && std::ranges::find(models, word(project.analysis.model)) == models.end()) {
    Problem problem = about;
    problem.severity = Severity::warning;
    problem.what = fmt::format("{}has no effect", which);
    problem.why = fmt::format("analysis.model is \"{}\"", word(project.analysis.model));
    problems.add(std::move(problem));
  }
  return found;
}

std::optional<std::string> SettingNumber::set(Project& project, double value) const {
  if (!range_.contains(value)) return fmt::format("{} is {:.6g}; expected {}", path_, value, range_.text());
  const std::vector<Row> rows = table_->rows(project);
  for (const std::size_t row : rows_) {
    const Place place = place_of(setting_->slot(rows[row]));
    if (place.number != nullptr) *place.number = value;
    if (place.distribution == nullptr) continue;
    const Distribution before = *place.distribution;
    switch (part_) {
      case Part::whole:
        place.distribution->mean = value;
        break;
      case Part::std_dev:
        place.distribution->std_dev = value;
        break;
      case Part::rel_min:
        place.distribution->rel_min = value;
        break;
      case Part::rel_max:
        place.distribution->rel_max = value;
        break;
    }
    if (const auto why = why_unusable(*place.distribution, project::bounds(setting_->range))) {
      *place.distribution = before;
      return fmt::format("with {} = {:.6g}, {} {}", path_, value, setting_->key, *why);
    }
  }
  return std::nullopt;
}

double SettingNumber::value_in(const Project& project) const {
  Project copy = project;
  const Place place = place_of(setting_->slot(table_->rows(copy)[rows_.front()]));
  if (place.number != nullptr) return *place.number;
  const Distribution& distribution = *place.distribution;
  switch (part_) {
    case Part::whole:
      break;
    case Part::std_dev:
      return distribution.std_dev.value_or(0);
    case Part::rel_min:
      return distribution.rel_min.value_or(0);
    case Part::rel_max:
      return distribution.rel_max.value_or(0);
  }
  return distribution.mean;
}

std::optional<Distribution> SettingNumber::distribution_in(const Project& project) const {
  Project copy = project;
  const Place place = place_of(setting_->slot(table_->rows(copy)[rows_.front()]));
  if (part_ != Part::whole || place.distribution == nullptr || place.distribution->kind == DistributionKind::none)
    return std::nullopt;
  return *place.distribution;
}

bool SettingNumber::shares_a_number_with(const SettingNumber& other) const {
  return setting_ == other.setting_ && part_ == other.part_ &&
         std::ranges::any_of(rows_, [&](std::size_t row) { return std::ranges::count(other.rows_, row) > 0; });
}

std::vector<std::string> SettingNumber::overrides(const Project& project) const {
  Project copy = project;
  const std::vector<Row> rows = table_->rows(copy);
  std::vector<std::string> overrides;
  for (const std::size_t row : rows_) {
    const auto value = written(setting_->slot(rows[row]), project.is_2d());
    if (!value) continue;
    std::string text;
    if (value->is_object()) {
      for (const auto& [key, part] : value->items())
        text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", key, part.dump());
      text = "{ " + text + " }";
    } else {
      text = value->dump();
    }
    const std::string entry = table_->repeated ? fmt::format("{}.", row) : "";
    overrides.push_back(fmt::format("{}.{}{}={}", table_->key, entry, setting_->key, text));
  }
  return overrides;
}

}  // namespace talus::project
