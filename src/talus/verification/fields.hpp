#pragma once
// Reads the keys of the tables of a case.toml and collects problems.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "talus/core/nearest.hpp"
#include "talus/core/problems.hpp"
#include "talus/project/document.hpp"

namespace talus::verification {

/// A hint with the nearest of the known words, if one is near.
[[nodiscard]] inline std::string suggestion(std::string_view word, std::span<const std::string_view> known) {
  const auto near = nearest(word, known);
  return near ? fmt::format("Did you mean {}?", *near) : "";
}

/// Reads the keys of one table of a case.toml; `finish` reports keys that were not read.
class Fields {
 public:
  Fields(const project::Document& document, const toml::table& from, std::string where, Problems& problems)
      : document_(document), from_(from), where_(std::move(where)), problems_(problems) {}

  [[nodiscard]] const toml::node* find(std::string_view key) {
    known_.push_back(key);
    return from_.get(key);
  }
  [[nodiscard]] const toml::node* need(std::string_view key) {
    const toml::node* node = find(key);
    if (!node) report(from_, fmt::format("{} is missing", key), "it is required here");
    return node;
  }
  std::string text(std::string_view key) {
    const toml::node* node = need(key);
    return node ? text_of(*node, key) : std::string();
  }
  std::string text_or(std::string_view key, std::string fallback) {
    const toml::node* node = find(key);
    return node ? text_of(*node, key) : fallback;
  }
  std::vector<std::string> texts(std::string_view key, bool required) {
    std::vector<std::string> list;
    const toml::node* node = required ? need(key) : find(key);
    if (!node) return list;
    const toml::array* array = node->as_array();
    if (!array) {
      report(*node, fmt::format("{} is {}", key, project::quoted(*node)), "expected a list of texts");
      return list;
    }
    for (const toml::node& item : *array) list.push_back(text_of(item, key));
    return list;
  }
  std::optional<double> number(std::string_view key) {
    const toml::node* node = find(key);
    return node ? number_of(*node, key) : std::nullopt;
  }
  std::optional<std::int64_t> whole_number(std::string_view key, std::int64_t least) {
    const toml::node* node = find(key);
    if (!node) return std::nullopt;
    const auto value = node->value_exact<std::int64_t>();
    if (!value || *value < least) {
      report(*node, fmt::format("{} is {}", key, project::quoted(*node)),
             fmt::format("expected a whole number of {} or more", least));
      return std::nullopt;
    }
    return value;
  }
  /// The value of a word, as given by `read`; reports a word that it does not know.
  template <class Enumeration>
  std::optional<Enumeration> one_of(const std::string& word, std::string_view key,
                                    std::optional<Enumeration> (*read)(std::string_view),
                                    std::span<const std::string_view> known, const toml::node& node) {
    const auto value = read(word);
    if (!value) {
      report(node, fmt::format("{} is \"{}\"", key, word), fmt::format("expected one of {}", fmt::join(known, ", ")),
             suggestion(word, known));
    }
    return value;
  }
  template <class Each>
  void tables(std::string_view key, bool required, Each&& each) {
    const toml::node* node = required ? need(key) : find(key);
    if (!node) return;
    const toml::array* array = node->as_array();
    if (!array) {
      report(*node, fmt::format("{} is not a list of tables", key), fmt::format("expected [[{}]]", key));
      return;
    }
    for (const toml::node& item : *array) {
      const toml::table* table = item.as_table();
      if (table) {
        each(*table);
      } else {
        report(item, fmt::format("{} contains {}", key, project::quoted(item)), "expected a table");
      }
    }
  }
  void report(const toml::node& node, std::string what, std::string why, std::string hint = {}) {
    Problem problem = document_.at(node);
    problem.where = where_;
    problem.what = std::move(what);
    problem.why = std::move(why);
    problem.hint = std::move(hint);
    problems_.add(std::move(problem));
  }
  void finish() {
    for (const auto& [key, node] : from_) {
      if (std::ranges::find(known_, key.str()) != known_.end()) continue;
      report(node, fmt::format("there is no key {}", key.str()),
             fmt::format("expected one of {}", fmt::join(known_, ", ")), suggestion(key.str(), known_));
    }
  }
  [[nodiscard]] const toml::table& from() const { return from_; }
  [[nodiscard]] const project::Document& document() const { return document_; }
  [[nodiscard]] Problems& problems() { return problems_; }
  [[nodiscard]] const std::string& where() const { return where_; }

 private:
  std::string text_of(const toml::node& node, std::string_view key) {
    if (const auto value = node.value_exact<std::string>()) return *value;
    report(node, fmt::format("{} is {}", key, project::quoted(node)), "expected a text");
    return {};
  }
  std::optional<double> number_of(const toml::node& node, std::string_view key) {
    const auto value = project::number_in(node);
    if (value && *value >= 0) return value;
    report(node, fmt::format("{} is {}", key, project::quoted(node)), "expected a number, not negative");
    return std::nullopt;
  }

  const project::Document& document_;
  const toml::table& from_;
  std::string where_;
  Problems& problems_;
  std::vector<std::string_view> known_;
};

}  // namespace talus::verification
