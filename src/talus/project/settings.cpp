#include "talus/project/settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "talus/core/check.hpp"
#include "talus/project/settings/tables.hpp"

namespace talus::project {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Large and small powers of ten as 1e12 and 1e-9, other numbers in full.
std::string limit_text(double limit) {
  const double size = std::abs(limit);
  if (size == 0 || !std::isfinite(size) || (size > 1e-3 && size < 1e6)) return fmt::format("{}", limit);
  const double power = std::round(std::log10(size));
  if (size != std::pow(10, power)) return fmt::format("{}", limit);
  return fmt::format("{}1e{}", limit < 0 ? "-" : "", power);
}

}  // namespace

bool Range::contains(double value) const {
  if (std::isnan(value)) return false;
  if (std::isinf(value)) return infinite_allowed && value > 0;
  return (least_excluded ? value > least : value >= least) && (most_excluded ? value < most : value <= most);
}

bool Range::is_everything() const { return least == -infinity && most == infinity; }

std::string Range::text() const {
  if (is_everything()) return "any number";
  const std::string from = limit_text(least), to = limit_text(most);
  if (most == infinity) return least_excluded ? fmt::format("more than {}", from) : fmt::format("{} or more", from);
  if (!least_excluded && !most_excluded) return fmt::format("{} to {}", from, to);
  if (!least_excluded) return fmt::format("{} to less than {}", from, to);
  return fmt::format("more than {}, {} {}", from, most_excluded ? "less than" : "up to", to);
}

std::span<const std::string_view> models_of(const Setting& setting) {
  for (const Need& need : setting.applies_when) {
    const auto& [key, kind, values] = need.any_of.front();
    if (need.any_of.size() == 1 && kind == Condition::Kind::one_of && key == "analysis.model") return values;
  }
  return {};
}

std::string meaning_of(const Setting& setting) {
  const auto models = models_of(setting);
  if (models.empty()) return std::string(setting.meaning);
  const bool is_of_points = models.front() == word(RockModel::lumped_mass);
  const char* const lead = is_of_points                                      ? "Lumped mass"
                           : models.size() > 1                               ? "Rigid sphere and body"
                           : models.front() == word(RockModel::rigid_sphere) ? "Rigid sphere"
                                                                             : "Rigid body";
  return fmt::format("{}: {}", lead, setting.meaning);
}

bool is_random_property(const Slot& slot) {
  return std::holds_alternative<Distribution*>(slot) || std::holds_alternative<std::optional<Distribution>*>(slot) ||
         std::holds_alternative<SizeSlot>(slot);
}

Distribution* distribution_in(const Slot& slot) {
  if (auto* const* const plain = std::get_if<Distribution*>(&slot)) return *plain;
  if (const auto* const size = std::get_if<SizeSlot>(&slot))
    return *size->size && (*size->size)->of == size->of ? &(*size->size)->distribution : nullptr;
  auto* const* const given = std::get_if<std::optional<Distribution>*>(&slot);
  return given && **given ? &***given : nullptr;
}

const Setting* Table::find(std::string_view setting) const {
  const auto found = std::find_if(settings.begin(), settings.end(), [&](const Setting& s) { return s.key == setting; });
  return found == settings.end() ? nullptr : &*found;
}

std::vector<std::string_view> Table::excluded_by(std::string_view setting) const {
  std::vector<std::string_view> excluded;
  for (const Choice& choice : choices) {
    const auto has = [&](const auto& way) { return std::ranges::find(way, setting) != way.end(); };
    if (std::ranges::none_of(choice, has)) continue;
    for (const auto& way : choice) {
      if (!has(way)) excluded.insert(excluded.end(), way.begin(), way.end());
    }
  }
  return excluded;
}

std::vector<std::string_view> Table::keys_of_ways() const {
  std::vector<std::string_view> keys;
  for (const auto& way : choices.front()) keys.insert(keys.end(), way.begin(), way.end());
  return keys;
}

std::string Table::heading() const { return fmt::format(fmt::runtime(repeated ? "[[{}]]" : "[{}]"), key); }

const std::vector<Table>& tables() {
  using namespace declared;
  static const std::vector<Table> list{
      head_table(), analysis_table(), sampling_table(), terrain_table(), material_table(), ground_table(),
      area_table(), forest_table(),   shape_table(),    seeder_table(),  barrier_table(),  collector_table(),
      kit_table(),  design_table(),   output_table(),   report_table(),  layer_table()};
  return list;
}

const Table& distribution_table() {
  static const Table table = declared::distribution_table();
  return table;
}

const Table& table(std::string_view key) {
  const auto found = std::ranges::find(tables(), key, &Table::key);
  if (found != tables().end()) return *found;
  TALUS_PROMISE(false, "the table is declared");
  throw std::logic_error(fmt::format("no table {} is declared", key));
}

const Setting& setting(std::string_view of, std::string_view key) {
  if (const Setting* found = table(of).find(key)) return *found;
  TALUS_PROMISE(false, "the setting is declared");
  throw std::logic_error(fmt::format("no setting {}.{} is declared", of, key));
}

Bounds bounds(const Range& range) {
  const Bounds widest;
  if (!range.limits_draws) return widest;
  return {std::max(range.least, widest.least), std::min(range.most, widest.most)};
}

Bounds bounds(std::string_view table, std::string_view key) { return bounds(setting(table, key).range); }

}  // namespace talus::project