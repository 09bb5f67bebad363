#include "talus/project/factor_set.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

#include "talus/core/nearest.hpp"
#include "talus/files/names_in_words.hpp"
#include "talus/project/named_files.hpp"
#include "talus/project/read_table.hpp"
#include "talus/project/values.hpp"

namespace talus::project {

namespace {

constexpr std::size_t most_factors = 20;  // so that no product of them overflows

template <class Item>
const Item* find_key(const std::vector<Item>& list, std::string_view key) {
  const auto found = std::ranges::find(list, key, &Item::key);
  return found == list.end() ? nullptr : &*found;
}

Row added_row(FactorSet& set, std::string_view table, int line) {
  const auto with_line = [line](auto& list) {
    list.emplace_back().line = line;
    return Row(&list.back());
  };
  if (table == "source") return with_line(set.sources);
  if (table == "factor") return with_line(set.factors);
  return &set;
}

/// Rules across the keys of a set.
class SetRules {
 public:
  SetRules(const FactorSet& set, const Document& document, Problems& problems)
      : set_(set), document_(document), file_(document.file()), problems_(problems) {}

  void check() {
    check_unique(set_.sources, "source");
    check_unique(set_.factors, "factor");
    for (std::size_t k = 0; k < set_.factors.size(); ++k) check(set_.factors[k], k);
    if (!set_.clearance_source.empty()) check_source(0, "", "clearance_source", set_.clearance_source);
    if (set_.factors.size() > most_factors) {
      refuse(set_.factors[most_factors].line, "", fmt::format("the set has {} factors", set_.factors.size()),
             fmt::format("expected at most {}", most_factors), "");
    }
  }

 private:
  void refuse(int line, std::string where, std::string what, std::string why, std::string hint) {
    problems_.add({.file = file_,
                   .line = line,
                   .where = std::move(where),
                   .what = std::move(what),
                   .why = std::move(why),
                   .hint = std::move(hint)});
  }

  template <class Item>
  void check_unique(const std::vector<Item>& list, std::string_view kind) {
    for (const Item& item : list) {
      if (item.key.empty() || find_key(list, item.key) == &item) continue;
      refuse(item.line, "", fmt::format("two {}s have the key \"{}\"", kind, item.key),
             fmt::format("the first begins in line {}", find_key(list, item.key)->line), "Give each its own key");
    }
  }

  /// Whether a factor's row has a value, right or wrong.
  [[nodiscard]] bool gives_value(std::size_t factor) const {
    const toml::array* rows = document_.root()["factor"].as_array();
    const toml::table* row = rows && factor < rows->size() ? (*rows)[factor].as_table() : nullptr;
    return row && row->contains("value");
  }

  void check(const Factor& factor, std::size_t number) {
    if (factor.key.empty()) return;  // missing or refused
    const std::string where = fmt::format("factor \"{}\"", factor.key);
    for (const std::string& quantity : factor.multiplies) {
      if (std::ranges::find(multiplied_quantities, quantity) != multiplied_quantities.end()) continue;
      const auto near = nearest(quantity, multiplied_quantities);
      refuse(factor.line, where, fmt::format("multiplies \"{}\"", quantity),
             fmt::format("a factor can multiply {}", fmt::join(multiplied_quantities, ", ")),
             near ? fmt::format("Did you mean \"{}\"?", *near) : "");
    }
    if (!factor.source.empty()) check_source(factor.line, where, "source", factor.source);
    if (gives_value(number)) return;
    if (!is_factor_key(factor.key)) {
      refuse(factor.line, where, "value is missing", "[design] has no key of this name, so the project cannot give it",
             "");
    }
    if (factor.value_with_sel) refuse(factor.line, where, "value is missing", "value_with_sel is given", "");
  }

  void check_source(int line, const std::string& where, std::string_view key, const std::string& name) {
    if (set_.find_source(name) != nullptr) return;
    std::vector<std::string> names;
    for (const FactorSource& source : set_.sources) names.push_back(source.key);
    refuse(line, where, fmt::format("{} is \"{}\"", key, name),
           fmt::format("no [[source]] has this key; the set has {}", talus::listed(names)), meant(name, names));
  }

  const FactorSet& set_;
  const Document& document_;
  const std::string& file_;
  Problems& problems_;
};

std::vector<FactorSet> read_embedded() {
  std::vector<FactorSet> sets;
  for (const StandardFile& file : standard_files()) {
    sets.push_back(read_factor_set(Document(file.text, std::string(file.path))));
  }
  return sets;
}

}  // namespace

bool is_factor_key(std::string_view key) { return std::ranges::find(factor_keys, key) != factor_keys.end(); }

const Factor* FactorSet::find(std::string_view key) const { return find_key(factors, key); }

const FactorSource* FactorSet::find_source(std::string_view key) const { return find_key(sources, key); }

const std::vector<FactorSet>& factor_sets() {
  static const std::vector<FactorSet> sets = read_embedded();
  return sets;
}

FactorSet read_factor_set(const Document& document) {
  FactorSet set;
  Problems problems;
  ValueReader reader(document, problems, factor_set_tables());
  for (const Table& table : factor_set_tables()) {
    read_table(
        table, document, reader, [&](int line) { return added_row(set, table.key, line); }, "a set of factors",
        problems);
  }
  SetRules(set, document, problems).check();
  problems = problems.in_order_of(document.file());
  if (problems.has_errors()) throw BadInput(std::move(problems));
  return set;
}

std::optional<FactorSet> factor_set_of(const Project& project) {
  return project.design ? factor_set_of(*project.design, project.file.parent_path()) : std::nullopt;
}

std::optional<FactorSet> factor_set_of(const Design& design, const std::filesystem::path& folder) {
  if (!design.standard_file.empty()) {
    const std::filesystem::path file = folder / design.standard_file;
    return read_factor_set(Document(text_of_file(file), file.string()));
  }
  if (design.standard == DesignStandard::none) return std::nullopt;
  const auto found = std::ranges::find(factor_sets(), word(design.standard), &FactorSet::name);
  if (found == factor_sets().end()) throw std::logic_error("a standard has no set of factors");
  return *found;
}

std::optional<double> value_of(const Factor& factor, const Design& design) {
  if (is_factor_key(factor.key)) {
    Design copy = design;  // slots are not const
    const Slot slot = setting("design", factor.key).slot(&copy);
    if (const auto given = *std::get<std::optional<double>*>(slot)) return given;
  }
  return design.energy_level == DesignLevel::sel && factor.value_with_sel ? factor.value_with_sel : factor.value;
}

std::string factor_table(const FactorSet& set) {
  std::string text = "| symbol | key | multiplies | default | usual values | source | could not be read |\n";
  text += "| --- | --- | --- | --- | --- | --- | --- |\n";
  const auto number_of = [&](const std::string& key) {
    return static_cast<std::size_t>(set.find_source(key) - set.sources.data()) + 1;
  };
  const auto value = [](const Factor& factor) {
    if (!factor.value) return std::string("none: an input");
    const std::string sel = factor.value_with_sel ? fmt::format("; with SEL {}", *factor.value_with_sel) : "";
    return fmt::format("{}{}", *factor.value, sel);
  };
  for (const Factor& factor : set.factors) {
    text += fmt::format("| {} | `{}`: {} | {} | {} | {} | [{}] | {} |\n", factor.symbol, factor.key, factor.meaning,
                        fmt::join(factor.multiplies, ", "), value(factor), factor.usual, number_of(factor.source),
                        factor.not_read);
  }
  const std::string least = set.upper_clearance_m > 0 ? fmt::format("{}", set.upper_clearance_m) : "none: an input";
  const std::string block = set.clears_half_the_block ? ", and at least half the block" : "";
  const std::string percentile =
      set.design_percentile ? fmt::format("{}", *set.design_percentile) : std::string("none: an input");
  text += fmt::format("| f | `upper_clearance_m`: the clearance above the height [m] | | {}{} | | {} | {} |\n", least,
                      block, set.clearance_source.empty() ? "" : fmt::format("[{}]", number_of(set.clearance_source)),
                      set.clearance_not_read);
  text += fmt::format("| p | `design_percentile` [%] | | {} | | | |\n\n", percentile);
  text += fmt::format("{}. {}.\n\n", set.title, set.not_read);
  for (std::size_t k = 0; k < set.sources.size(); ++k) {
    text += fmt::format("{}. {}. {}.\n", k + 1, set.sources[k].text, set.sources[k].checked);
  }
  return text;
}

}  // namespace talus::project
