#include "talus/project/applies.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "talus/project/echo.hpp"
#include "talus/project/values.hpp"

namespace talus::project {
namespace {

/// The setting that a condition refers to.
struct Subject {
  const Table& table;
  std::string_view key;
};

Subject subject_of(const Table& table, std::string_view key) {
  const std::size_t dot = key.find('.');
  if (dot == std::string_view::npos) return {table, key};
  return {project::table(key.substr(0, dot)), key.substr(dot + 1)};
}

std::string text_of(const toml::node& node) {
  if (const auto* text = node.as_string()) return text->get();
  if (const auto number = number_in(node)) return number_text(*number);
  return quoted(node);
}

std::string text_of(const nlohmann::ordered_json& value) {
  if (value.is_string()) return value.get<std::string>();
  return value.is_number() ? number_text(value.get<double>()) : value.dump();
}

/// The laws that a project chooses.
LawSet laws_in(const toml::table& root) {
  const std::string_view given = root["analysis"]["laws"].value_or(std::string_view());
  return value_of<LawSet>(given).value_or(LawSet::talus);
}

std::string value_in_words(const Subject& subject, std::string_view value) {
  const auto standard = default_of(subject.table, *subject.table.find(subject.key));
  const bool is_bare = value == "true" || value == "false" || !standard || !standard->is_string();
  return is_bare ? std::string(value) : fmt::format("\"{}\"", value);
}

}  // namespace

std::string in_words(const Table& table, const Condition& condition) {
  const Subject subject = subject_of(table, condition.key);
  // Keys of the same row and of [analysis] are unambiguous without their table.
  const std::string_view key = subject.table.key == "analysis" ? subject.key : condition.key;
  std::string values;
  for (const std::string_view value : condition.values) {
    values += fmt::format("{}{}", values.empty() ? "" : " or ", value_in_words(subject, value));
  }
  switch (condition.kind) {
    case Condition::Kind::given:
      return std::string(key);
    case Condition::Kind::absent:
      return fmt::format("no {}", key);
    case Condition::Kind::one_of:
      return fmt::format("{} = {}", key, values);
    case Condition::Kind::none_of:
      return fmt::format("{} other than {}", key, values);
  }
  return "";
}

std::string in_words(const Table& table, const Need& need) {
  std::string out;
  for (const Condition& condition : need.any_of) {
    out += fmt::format("{}{}", out.empty() ? "" : " or ", in_words(table, condition));
  }
  return out;
}

NotMet message(const Table& table, const Setting& setting, const Need& need, std::string_view now) {
  const auto filled = [&](std::string_view text) {
    const std::size_t place = text.find("{}");
    std::string out(text);
    return place == std::string::npos ? out : out.replace(place, 2, now);
  };
  const bool is_error = need.otherwise == Otherwise::refused;
  const std::string needed = in_words(table, need);
  return {.severity = is_error ? Severity::error : Severity::warning,
          .what = fmt::format("{} {}", setting.key,
                              !need.what.empty() ? filled(need.what)
                              : is_error         ? fmt::format("is given without {}", needed)
                                                 : "has no effect"),
          .why = !need.why.empty() ? filled(need.why)
                 : is_error        ? "it would have no effect"
                                   : fmt::format("it needs {}", needed),
          .hint = std::string(need.hint)};
}

std::string ConditionCheck::text(const Table& table, const toml::table* row, std::string_view key) const {
  if (const toml::node* node = row ? row->get(key) : nullptr) return text_of(*node);
  const auto standard = default_of(table, *table.find(key), laws_in(root_));
  return standard ? text_of(*standard) : "";
}

bool ConditionCheck::is_true(const Table& table, const toml::table& row, const Condition& condition) const {
  const Subject subject = subject_of(table, condition.key);
  const bool is_of_row = &subject.table == &table;
  const toml::table* other = is_of_row ? &row : root_[subject.table.key].as_table();
  // Without a terrain its kind is unknown, and nothing is reported about it.
  if (!is_of_row && subject.table.key == "terrain" && !is_2d(root_)) return true;
  const bool is_given = other && other->contains(subject.key);
  if (condition.kind == Condition::Kind::given) return is_given;
  if (condition.kind == Condition::Kind::absent) return !is_given;
  if (is_given && refused_.contains(other->get(subject.key))) return true;
  const bool is_one =
      std::ranges::find(condition.values, text(subject.table, other, subject.key)) != condition.values.end();
  return is_one == (condition.kind == Condition::Kind::one_of);
}

bool ConditionCheck::is_met(const Table& table, const toml::table& row, const Need& need) const {
  return std::ranges::any_of(need.any_of, [&](const Condition& condition) { return is_true(table, row, condition); });
}

std::optional<NotMet> ConditionCheck::unmet(const Table& table, const toml::table& row, const Setting& setting) const {
  const toml::node* node = row.get(setting.key);
  if (!node || refused_.contains(node)) return std::nullopt;
  if (std::ranges::find(setting.always_accepted, text_of(*node)) != setting.always_accepted.end()) return std::nullopt;
  const auto failed =
      std::ranges::find_if(setting.applies_when, [&](const Need& need) { return !is_met(table, row, need); });
  if (failed == setting.applies_when.end() || failed->otherwise == Otherwise::kept) return std::nullopt;
  const Subject subject = subject_of(table, failed->any_of.front().key);
  const toml::table* other = &subject.table == &table ? &row : root_[subject.table.key].as_table();
  return message(table, setting, *failed, text(subject.table, other, subject.key));
}

}  // namespace talus::project
