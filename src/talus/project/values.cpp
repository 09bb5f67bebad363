#include "talus/project/values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>

#include "talus/core/nearest.hpp"
#include "talus/project/decimal_comma.hpp"
#include "talus/project/doubtful_draws.hpp"
#include "talus/project/material_library.hpp"

namespace talus::project {
namespace {

/// `a, b or c`, each in double quotes.
std::string quoted_list(std::span<const std::string_view> words, std::string_view last = " or ") {
  std::string out;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) out += i + 1 == words.size() ? last : ", ";
    out += fmt::format("\"{}\"", words[i]);
  }
  return out;
}

/// Whether the value is a number in quotes.
bool reads_as_number(const toml::node& node) {
  const auto* text = node.as_string();
  if (!text || text->get().empty()) return false;
  char* end = nullptr;
  std::strtod(text->get().c_str(), &end);
  return *end == '\0';
}

std::string number_hint(const toml::node& node) {
  if (reads_as_number(node)) return "Leave out the quotes";
  const auto* text = node.as_string();
  const std::string number = text ? with_decimal_point(text->get()) : "";
  return number.empty() ? "" : fmt::format("Write {}, without quotes", number);
}

std::string reason(const Range& range, double value) {
  const std::string_view why = value > range.least ? range.too_high : range.too_low;
  return fmt::format("{}{}expected {}", why, why.empty() ? "" : "; ", range.text());
}

std::string kind_of_number(std::string_view kind, const Range& range) {
  return range.is_everything() ? std::string(kind) : fmt::format("{}, {}", kind, range.text());
}

std::string slip_hint(const Setting& setting, double value) {
  const std::optional<double> meant = setting.slip ? setting.slip(value) : std::nullopt;
  return meant && setting.range.contains(*meant) ? fmt::format("Did you mean {}?", number_text(*meant)) : "";
}

}  // namespace

std::optional<bool> is_2d(const toml::table& root) {
  const toml::table* terrain = root["terrain"].as_table();
  if (!terrain) return std::nullopt;
  if (terrain->contains("section")) return !terrain->contains("width_m");
  const std::vector<std::string_view> ways = table("terrain").keys_of_ways();
  const bool is_known = std::ranges::any_of(ways, [&](std::string_view key) { return terrain->contains(key); });
  return is_known ? std::optional(false) : std::nullopt;
}

static bool is_control(unsigned char c) { return c < ' ' || c == 127; }

std::string name_of_row(const Table& table, const toml::table& row, std::size_t index) {
  if (table.key.empty()) return "";
  if (!table.repeated) return table.heading();
  const auto name = row["name"].value<std::string>();
  if (!name || name->empty()) return fmt::format("{} {}", table.key, index + 1);
  const bool is_printable = std::none_of(name->begin(), name->end(), is_control);
  return fmt::format("{} {}", table.key, is_printable ? fmt::format("\"{}\"", *name) : quoted(*row.get("name")));
}

std::string counted(std::size_t count, std::string_view one, std::string_view several) {
  return fmt::format("{} {}", count, count == 1 ? one : several);
}

std::vector<std::size_t> repeated(const std::vector<double>& list) {
  std::set<double> before;
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (!before.insert(list[i]).second) places.push_back(i);
  }
  return places;
}

std::string number_text(double value) {
  constexpr double exact = 9007199254740992.0;  // 2^53: whole numbers up to here are doubles
  if (std::abs(value) < exact && value == std::floor(value)) return fmt::format("{:.0f}", value);
  return fmt::format("{}", value);
}

ValueReader::ValueReader(const Document& document, Problems& problems, const std::vector<Table>& tables)
    : document_(document),
      problems_(problems),
      tables_(tables),
      dimension_is_known_(is_2d(document.root()).has_value()),
      two_dimensional_(is_2d(document.root()).value_or(false)) {}

void ValueReader::read(const Table& table, const toml::table& from, Row row, const std::string& where) {
  read_rows(table, from, row, where, "");
}

void ValueReader::read_rows(const Table& table, const toml::table& from, Row row, const std::string& where,
                            const std::string& lead) {
  const RowKeys keys{document_, table, from, where, problems_, tables_};
  keys.refuse_unknown(lead);
  keys.refuse_exclusive();
  for (const Setting& setting : table.settings) {
    const toml::node* node = from.get(setting.key);
    if (!node) {
      if (!setting.required || is_mistyped(table, from, setting.key)) continue;
      Problem problem = document_.at(Spot(&from, &from, setting.key));
      problem.where = where;
      problem.what = fmt::format("{}{} is missing", lead, setting.key);
      if (!setting.range.is_everything()) problem.why = fmt::format("expected {}", setting.range.text());
      problems_.add(std::move(problem));
      continue;
    }
    const Value value{setting, *node, from, where, fmt::format("{}{}", lead, setting.key)};
    if (!std::visit([&](auto slot) { return into(value, slot); }, setting.slot(row))) refused_.insert(node);
  }
}

bool ValueReader::refuse(const Value& value, std::string what, std::string why, std::string hint) {
  Problem problem = document_.at(value.node);
  problem.where = value.where;
  problem.what = std::move(what);
  problem.why = std::move(why);
  problem.hint = std::move(hint);
  problems_.add(std::move(problem));
  return false;
}

bool ValueReader::refuse_kind(const Value& value, const std::string& expected, std::string hint) {
  return refuse(value, fmt::format("{} is {}", value.name, quoted(value.node)), "expected " + expected,
                std::move(hint));
}

void ValueReader::doubt(const Value& value, double number) {
  const std::optional<Doubt> doubt = value.setting.doubt ? value.setting.doubt(number) : std::nullopt;
  if (doubt) warn(value, fmt::format("{} is {}", value.name, number_text(number)), doubt->why, doubt->hint);
}

void ValueReader::warn(const Value& value, std::string what, std::string why, std::string hint) {
  Problem problem = document_.at(value.node, Severity::warning);
  problem.where = value.where;
  problem.what = std::move(what);
  problem.why = std::move(why);
  problem.hint = std::move(hint);
  problems_.add(std::move(problem));
}

bool ValueReader::into(const Value& value, bool* member) {
  if (const auto* truth = value.node.as_boolean()) {
    *member = truth->get();
    return true;
  }
  const auto* text = value.node.as_string();
  const bool in_quotes = text && (text->get() == "true" || text->get() == "false");
  return refuse_kind(value, "true or false", in_quotes ? "Leave out the quotes" : "");
}

bool ValueReader::into(const Value& value, double* member) {
  const Range& range = value.setting.range;
  const std::optional<double> given = number_in(value.node);
  if (!given) return refuse_kind(value, kind_of_number("a number", range), number_hint(value.node));
  const double number = *given;
  if (!std::isfinite(number) && !range.contains(number)) return refuse_kind(value, "a finite number");
  if (!range.contains(number)) {
    return refuse(value, fmt::format("{} is {}", value.name, number_text(number)), reason(range, number),
                  slip_hint(value.setting, number));
  }
  doubt(value, number);
  *member = number + 0.0;  // turns -0 into 0, also in names made from it
  return true;
}

bool ValueReader::into(const Value& value, std::optional<double>* member) {
  double number = 0;
  if (!into(value, &number)) return false;
  *member = number;
  return true;
}

bool ValueReader::into(const Value& value, std::int64_t* member) {
  const Range& range = value.setting.range;
  if (const auto* real = value.node.as_floating_point()) {
    const bool is_whole = std::isfinite(real->get()) && real->get() == std::floor(real->get());
    std::string hint = is_whole && std::abs(real->get()) < 1e15
                           ? fmt::format("Write {:.0f}, without a decimal point or an exponent", real->get())
                           : "";
    return refuse_kind(value, kind_of_number("a whole number", range), std::move(hint));
  }
  const auto* number = value.node.as_integer();
  if (!number) return refuse_kind(value, kind_of_number("a whole number", range), number_hint(value.node));
  if (!range.contains(static_cast<double>(number->get()))) {
    return refuse(value, fmt::format("{} is {}", value.name, number->get()),
                  reason(range, static_cast<double>(number->get())));
  }
  *member = number->get();
  return true;
}

bool ValueReader::into(const Value& value, std::optional<std::int64_t>* member) {
  std::int64_t number = 0;
  if (!into(value, &number)) return false;
  *member = number;
  return true;
}

bool ValueReader::into(const Value& value, std::uint64_t* member) {
  std::int64_t number = 0;
  if (!into(value, &number)) return false;  // the range of the setting excludes negative numbers
  *member = static_cast<std::uint64_t>(number);
  return true;
}

bool ValueReader::into(const Value& value, std::string* member) {
  const auto* text = value.node.as_string();
  if (!text) return refuse_kind(value, "a text in quotes");
  if (text->get().empty()) return refuse_kind(value, "a text that is not empty");
  if (std::any_of(text->get().begin(), text->get().end(), is_control)) {
    return refuse_kind(value, "a text without line breaks or other invisible characters",
                       "In double quotes \\t and \\n are such characters: write paths with /, or in single quotes");
  }
  *member = text->get();
  return true;
}

bool ValueReader::into(const Value& value, std::filesystem::path* member) {
  std::string text;
  if (!into(value, &text)) return false;
  *member = text;
  const Problem here = document_.at(value.node);
  named_files_.push_back({text, here.file, here.line, value.where, value.name, here.path});
  return true;
}

bool ValueReader::into(const Value& value, std::array<double, 3>* member) { return into<double, 3>(value, member); }

template <class Number, std::size_t count>
bool ValueReader::into(const Value& value, std::array<Number, count>* member) {
  const toml::array* list = value.node.as_array();
  if (!list || list->size() != count) {
    return refuse_kind(value, count == 2 ? "a pair [x, z]" : "three numbers [..., ..., ...]");
  }
  bool good = true;
  for (std::size_t i = 0; i < count; ++i) {
    const Value part{value.setting, (*list)[i], value.row, value.where, fmt::format("{}[{}]", value.name, i)};
    good = into(part, &(*member)[i]) && good;
  }
  return good;
}

template <class Item>
bool ValueReader::into(const Value& value, std::vector<Item>* member) {
  const toml::array* list = value.node.as_array();
  if (!list) return refuse_kind(value, "a list [...]");
  if (const std::size_t most = value.setting.most_entries; most > 0 && list->size() > most) {
    return refuse(value, fmt::format("{} has {} entries", value.name, list->size()),
                  fmt::format("expected at most {}", most));
  }
  std::vector<Item> items(list->size());
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < list->size(); ++i) {
    const Value entry{value.setting, (*list)[i], value.row, value.where, fmt::format("{}[{}]", value.name, i)};
    if (into(entry, &items[i])) continue;
    if (++wrong == most_reported && i + 1 < list->size()) {
      return refuse(value, fmt::format("{} was read only up to entry {}", value.name, i),
                    fmt::format("{} of its entries are wrong so far", wrong));
    }
  }
  if (wrong > 0) return false;
  *member = std::move(items);
  return true;
}

bool ValueReader::into(const Value& value, FilesSlot slot) {
  if (!value.node.is_array()) {
    if (!value.node.is_string()) return refuse_kind(value, "a file name in quotes, or a list of them");
    return into(value, &slot.files->emplace_back());
  }
  if (value.node.as_array()->empty()) return refuse_kind(value, "one file or more");
  return into(value, slot.files);
}

template <class Enumeration>
requires std::is_enum_v<Enumeration>
bool ValueReader::into(const Value& value, Enumeration* member) {
  const std::span<const std::string_view> known = words<Enumeration>();
  const std::string expected = quoted_list(known);
  const auto* text = value.node.as_string();
  if (!text) return refuse_kind(value, expected);
  if (const auto read = value_of<Enumeration>(text->get())) {
    *member = *read;
    return true;
  }
  const auto near = nearest(text->get(), known);
  return refuse_kind(value, expected, near ? fmt::format("Did you mean \"{}\"?", *near) : "");
}

bool ValueReader::into(const Value& value, Distribution* member) {
  const Range& range = value.setting.range;
  Distribution read;
  const toml::table* parts = value.node.as_table();
  if (!parts && !value.node.is_number()) {
    return refuse_kind(value, "a number or { mean = ..., distribution = ..., ... }", number_hint(value.node));
  }
  const std::size_t before = problems_.list().size();
  const auto has_new_errors = [&] {
    return std::any_of(problems_.list().begin() + static_cast<std::ptrdiff_t>(before), problems_.list().end(),
                       [](const Problem& problem) { return problem.severity == Severity::error; });
  };
  if (parts) {
    read_rows(distribution_table(), *parts, &read, value.where, value.name + ' ');
    check_parts(value, *parts, read.kind);
    if (read.kind == DistributionKind::empirical) {
      if (has_new_errors()) return false;
      *member = read;
      return true;
    }
    const bool has_kind = parts->contains("distribution");
    for (const std::string_view key : {"std_dev", "rel_min", "rel_max"}) {
      if (has_kind || !parts->contains(key)) continue;
      refuse(value, fmt::format("{} has {} but no distribution", value.name, key), "it would have no effect",
             "Add distribution = \"normal\", or another kind");
      break;
    }
  }
  const toml::node& mean_node = parts && parts->contains("mean") ? *parts->get("mean") : value.node;
  const Value mean{value.setting, mean_node, value.row, value.where, parts ? value.name + " mean" : value.name};
  // The mean was read as a part above; here it is checked against the range of the property.
  if (refused_.contains(&mean_node)) return false;
  if (mean_node.is_number() && !into(mean, &read.mean)) return false;
  if (has_new_errors()) return false;
  if (const auto why = why_unusable(read, bounds(range)))
    return refuse(value, fmt::format("{} {}", value.name, *why), "");
  if (auto doubt = doubt_of_draws(value.name, read, bounds(range))) {
    warn(value, std::move(doubt->what), std::move(doubt->why), std::move(doubt->hint));
  }
  if (read.std_dev && is_given_by_its_limits(read)) {
    warn(value, fmt::format("std_dev of {} has no effect", value.name),
         fmt::format("the {} distribution takes its width from rel_min and rel_max", word(read.kind)),
         "Leave out std_dev, or the limits");
  }
  *member = read;
  return true;
}

void ValueReader::check_parts(const Value& value, const toml::table& parts, DistributionKind kind) {
  const bool is_empirical = kind == DistributionKind::empirical;
  const std::string_view needed = is_empirical ? "file" : "mean";
  if (!parts.contains(needed) && !is_mistyped(distribution_table(), parts, needed)) {
    Problem problem = document_.at(Spot(&parts, &parts, needed));
    problem.where = value.where;
    problem.what = fmt::format("{} {} is missing", value.name, needed);
    problems_.add(std::move(problem));
  }
  for (const Setting& setting : distribution_table().settings) {
    const toml::node* node = parts.get(setting.key);
    if (!node || setting.key == "distribution") continue;
    const bool is_of_sample = setting.key == "file" || setting.key == "column" || setting.key == "weight_column";
    if (is_of_sample == is_empirical) continue;
    const Value part{value.setting, *node, value.row, value.where, fmt::format("{} {}", value.name, setting.key)};
    if (is_empirical) {
      refuse(part, fmt::format("{} is given for a sample", part.name), "the file has its values, and none is cut off",
             "Leave it out");
    } else {
      refuse(part, fmt::format("{} is given without a sample", part.name), "it would have no effect",
             "Write distribution = \"empirical\"");
    }
  }
}

bool ValueReader::into(const Value& value, std::optional<Distribution>* member) {
  Distribution read;
  if (!into(value, &read)) return false;
  *member = read;
  return true;
}

bool ValueReader::into(const Value& value, MapSubjects* member) {
  if (value.node.is_boolean()) {
    bool all = false;
    (void)into(value, &all);
    *member = all ? all_map_subjects : MapSubjects();
    return true;
  }
  if (!value.node.is_array()) {
    const auto* text = value.node.as_string();
    const std::string given = text ? text->get() : "";
    const bool is_name = std::ranges::find(map_subject_names, given) != map_subject_names.end();
    const std::string hint = given == "true" || given == "false" ? "Leave out the quotes"
                             : is_name                           ? fmt::format("Write [\"{}\"]", given)
                                                                 : "";
    return refuse_kind(value, fmt::format("true, false or a list of {}", quoted_list(map_subject_names, " and ")),
                       hint);
  }
  std::vector<MapSubject> list;
  if (!into(value, &list)) return false;
  MapSubjects subjects;
  bool good = true;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const auto place = static_cast<std::size_t>(list[i]);
    if (subjects[place]) {
      const Value entry{value.setting, value.node.as_array()->at(i), value.row, value.where,
                        fmt::format("{}[{}]", value.name, i)};
      good =
          refuse(entry, fmt::format("{} is {}", entry.name, quoted(entry.node)), "it is listed twice", "Leave it out");
    }
    subjects.set(place);
  }
  if (good) *member = subjects;
  return good;
}

bool ValueReader::into(const Value& value, LawsSlot slot) {
  LawSet laws{};
  if (!into(value, &laws)) return false;
  *slot.analysis = Analysis::of_laws(laws);
  return true;
}

bool ValueReader::into(const Value& value, LibrarySlot slot) {
  std::string key;
  if (!into(value, &key)) return false;
  if (const LibraryMaterial* entry = material_library().find(key)) {
    std::string name = std::move(slot.material->name);
    *slot.material = entry->material;
    slot.material->name = std::move(name);
    slot.material->like = key;
    return true;
  }
  std::vector<std::string_view> known;
  for (const LibraryMaterial& entry : material_library().materials) known.push_back(entry.key);
  const auto near = nearest(key, known);
  return refuse(value, fmt::format("{} is {}", value.name, quoted(value.node)),
                fmt::format("the library has {}", plain_list(known, " and ")),
                near ? fmt::format("Did you mean \"{}\"?", *near) : "");
}

}  // namespace talus::project
