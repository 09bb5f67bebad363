#include "talus/project/reference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "talus/project/applies.hpp"
#include "talus/project/echo.hpp"
#include "talus/project/settings.hpp"
#include "talus/project/values.hpp"

namespace talus::project {
namespace {

std::string words_text(std::span<const std::string_view> list) {
  std::string out;
  for (const std::string_view word : list) out += fmt::format("{}`\"{}\"`", out.empty() ? "" : ", ", word);
  return out;
}

/// The type of a member, for readers.
struct Named {
  std::string operator()(const bool*) const { return "true or false"; }
  std::string operator()(const double*) const { return "number"; }
  std::string operator()(const std::optional<double>*) const { return "number"; }
  std::string operator()(const std::int64_t*) const { return "whole number"; }
  std::string operator()(const std::uint64_t*) const { return "whole number"; }
  std::string operator()(const std::string*) const { return "text"; }
  std::string operator()(const std::filesystem::path*) const { return "path of a file"; }
  std::string operator()(const std::array<double, 3>*) const { return "three numbers"; }
  std::string operator()(const Distribution*) const { return "number or distribution"; }
  std::string operator()(const std::optional<Distribution>*) const { return "number or distribution"; }
  std::string operator()(const std::vector<std::array<double, 2>>*) const { return "list of pairs"; }
  std::string operator()(const std::vector<std::array<double, 3>>*) const { return "list of triples"; }
  std::string operator()(const std::vector<std::array<std::int64_t, 3>>*) const { return "list of triples"; }
  std::string operator()(const std::vector<std::vector<std::array<double, 3>>>*) const {
    return "list of lists of triples";
  }
  std::string operator()(const std::vector<std::string>*) const { return "list of texts"; }
  std::string operator()(const std::vector<std::int64_t>*) const { return "list of whole numbers"; }
  std::string operator()(const std::vector<double>*) const { return "list of numbers"; }
  std::string operator()(const std::optional<std::vector<double>>*) const { return "list of numbers"; }
  std::string operator()(const std::map<std::int32_t, std::string>*) const { return "table of texts by whole numbers"; }
  std::string operator()(const std::optional<std::int64_t>*) const { return "whole number"; }
  std::string operator()(const std::map<std::string, std::string>*) const { return "table of texts by texts"; }
  std::string operator()(const MapSubjects*) const {
    return "true, false or list of " + words_text(words<MapSubject>());
  }
  std::string operator()(PlanPolygonSlot) const { return "list of pairs"; }
  std::string operator()(SizeSlot) const { return (*this)(static_cast<const Distribution*>(nullptr)); }
  std::string operator()(LibrarySlot) const { return "text"; }
  std::string operator()(LawsSlot) const { return words_text(words<LawSet>()); }
  template <class Enumeration>
  requires std::is_enum_v<Enumeration> std::string operator()(const Enumeration*) const {
    return words_text(words<Enumeration>());
  }
  std::string operator()(PositionSlot) const { return "position"; }
  std::string operator()(PointsSlot) const { return "list of positions"; }
  std::string operator()(PlanLineSlot) const { return "number or list of pairs"; }
  std::string operator()(PlanPointSlot) const { return "one or two numbers"; }
  std::string operator()(DirectionSlot) const { return "two or three numbers, or `\"downslope\"`"; }
  std::string operator()(LimitSlot) const { return "`\"all\"`, `\"none\"` or whole number"; }
  std::string operator()(SectionSlot) const { return "list of pairs, or path of a file"; }
  std::string operator()(FilesSlot) const { return "path of a file, or list of paths"; }
  std::string operator()(MapCellSlot) const { return "number or `\"terrain\"`"; }
};

std::string type_text(const Table& table, const Setting& setting) {
  Project blank;
  Distribution blank_distribution;
  return std::visit(Named{}, setting.slot(table.add ? table.add(blank) : Row(&blank_distribution)));
}

std::string range_text(const Range& range) {
  if (range.is_everything()) return "";
  return range.infinite_allowed ? range.text() + ", or inf" : range.text();
}

std::string value_text(const nlohmann::ordered_json& value) {
  if (value == "inf") return "`inf`";
  if (value.is_number_float()) return fmt::format("`{}`", number_text(value.get<double>()));
  // A fixed property is written as a plain number.
  if (value.is_object() && value.value("distribution", "") == "none") return value_text(value["mean"]);
  if (value.is_array()) {
    std::string out;
    for (const auto& item : value) {
      const std::string text = value_text(item);
      out += (out.empty() ? "" : ", ") + text.substr(1, text.size() - 2);
    }
    return fmt::format("`[{}]`", out);
  }
  return fmt::format("`{}`", value.dump());
}

std::string default_text(const Table& table, const Setting& setting) {
  if (setting.required) return "required";
  if (!setting.without_it.empty()) return std::string(setting.without_it);
  const auto value = default_of(table, setting).value(), rocfall = default_of(table, setting, LawSet::rocfall).value();
  if (value == rocfall || setting.key == "laws") return value_text(value);
  return fmt::format("{}; {} with `laws = \"{}\"`", value_text(value), value_text(rocfall), word(LawSet::rocfall));
}

/// The default of a setting that is one of several, of which a project gives one.
bool is_one_of_several(const Setting& setting) {
  return setting.without_it.starts_with("one of ") && setting.without_it.ends_with(" is required");
}

/// Whether a need is said by the first words of a meaning: "Rigid body: ...".
bool is_said_by_lead(const Need& need) {
  return need.any_of.size() == 1 && need.any_of.front().key == "analysis.model" &&
         need.any_of.front().kind == Condition::Kind::one_of;
}

bool is_of_3d(const Need& need) {
  return need.any_of.size() == 2 && need.any_of[0].key == "terrain.section" &&
         need.any_of[0].kind == Condition::Kind::absent && need.any_of[1].key == "terrain.width_m" &&
         need.any_of[1].kind == Condition::Kind::given;
}

/// When a setting applies: "with `points` or `lines`; not with `width_m`".
std::string applies_text(const Table& table, const Setting& setting) {
  std::string out;
  for (const Need& need : setting.applies_when) {
    if (is_said_by_lead(need) || (is_of_3d(need) && setting.meaning.starts_with("3D: "))) continue;
    if (is_of_3d(need)) {
      out += out.empty() ? "in 3D" : "; in 3D";
      continue;
    }
    std::string any;
    for (const Condition& condition : need.any_of) {
      const bool is_without = condition.kind == Condition::Kind::absent;
      any += fmt::format("{}{} `{}`", any.empty() ? "" : " or ", is_without ? "without" : "with",
                         is_without ? std::string(condition.key) : in_words(table, condition));
    }
    out += (out.empty() ? "" : "; ") + any;
  }
  if (is_one_of_several(setting)) return out;  // and so excludes the others
  const auto excluded = table.excluded_by(setting.key);
  for (std::size_t k = 0; k < excluded.size(); ++k) {
    out += fmt::format("{}`{}`", k > 0 ? ", " : out.empty() ? "not with " : "; not with ", excluded[k]);
  }
  return out;
}

/// "number, m, 0 to 100".
std::string value_column(const Table& table, const Setting& setting) {
  std::string out = type_text(table, setting);
  for (const std::string& part : {std::string(setting.unit), range_text(setting.range)}) {
    if (!part.empty()) out += ", " + part;
  }
  return out;
}

/// What a setting means, when it applies, and its source.
std::string meaning_column(const Table& table, const Setting& setting) {
  std::string out = meaning_of(setting);
  constexpr std::string_view on_paths[]{" The path is relative to the project file.",
                                        " Paths are relative to the project file."};
  for (const std::string_view sentence : on_paths) {  // the page says it once
    if (const std::size_t at = out.find(sentence); at != std::string::npos) out.erase(at, sentence.size());
  }
  if (const std::string applies = applies_text(table, setting); applies.starts_with("not ")) {
    out += fmt::format(" N{}.", applies.substr(1));
  } else if (!applies.empty()) {
    out += fmt::format(" Applies {}.", applies);
  }
  if (setting.source != "Talus") out += fmt::format(" ({})", setting.source);
  for (std::size_t at = 0; (at = out.find('|', at)) != std::string::npos; at += 2) out.insert(at, 1, '\\');
  return out;
}

std::string rows_of(const Table& table) {
  std::string out;
  std::vector<std::string_view> choices;  // of which one is required
  for (const Setting& setting : table.settings) {
    if (is_one_of_several(setting) && std::ranges::find(choices, setting.without_it) == choices.end()) {
      choices.push_back(setting.without_it);
      out += fmt::format("O{}.\n\n", setting.without_it.substr(1));
    }
  }
  out += "| key | value | default | meaning |\n| --- | --- | --- | --- |\n";
  for (const Setting& setting : table.settings) {
    out += fmt::format("| `{}` | {} | {} | {} |\n", setting.key, value_column(table, setting),
                       is_one_of_several(setting) ? "see above" : default_text(table, setting),
                       meaning_column(table, setting));
  }
  return out;
}

}  // namespace

std::string reference_page() {
  std::string page = R"(# The project file

<!-- Generated from the declaration of the settings (src/talus/project/settings) by reference.cpp; do not edit.
     To renew it: TALUS_RENEW_REFERENCE=1 and run the test ReferencePage.IsNotStale. -->

A project is one TOML file. An unknown key is an error, and so is a value out of range: `talus check` shows all problems
at once, with file, line and key. Lengths are in metres, x and y on plan, z up. Paths of files are relative to the
project file. `talus new` writes a small commented project; [examples](../examples/tutorial-1/tutorial-1-2d.toml) come
with the program.

A section without `width_m` is analysed in 2D: positions then are [x, z]. Everything else is 3D, and positions are
[x, y, z].

On the command line, `--set table.key=value` overrides a key. The value is TOML; anything else, such as `../dem.tif` or
`EPSG:31287`, is taken as a text. List entries are addressed by number, starting from 0, or by name (in double quotes if
it contains a dot):
`--set analysis.gravity_m_s2=9.81 --set seeder.0.rocks=10 --set "material.Type One.normal_restitution.mean=0.4"`.
`--rocks N` sets the total number of rocks, which several seeders share in proportion to their numbers in the file.
`--seed S` is short for `--set sampling.seed=S`.

The column *value* has type, unit and range. A meaning ends with its source in brackets, unless that is Talus. *The
manual* is Rocscience's verification manual of RocFall3, *Lumped Mass and Rigid Body (Legacy Sphere)*.

## Random properties

)";
  page += std::string(distribution_table().meaning);
  page += R"(
Truncation renormalises the distribution: draws do not pile up at the limits. Whatever the limits, no draw leaves the
range of its property.

)";
  page += rows_of(distribution_table());
  for (const Table& table : tables()) {
    page += fmt::format("\n## {}\n\n{}\n\n", table.key.empty() ? "Before the first table" : '`' + table.heading() + '`',
                        table.meaning);
    page += rows_of(table);
  }
  return page;
}

}  // namespace talus::project
