#include "talus/project/row_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "talus/core/nearest.hpp"

namespace talus::project {
namespace {

constexpr std::size_t most_unknown = 100;  // keys of one table that are reported individually

std::vector<std::string_view> keys_of(const Table& table) {
  std::vector<std::string_view> keys;
  for (const Setting& setting : table.settings) keys.push_back(setting.key);
  return keys;
}

}  // namespace

std::string plain_list(std::span<const std::string_view> words, std::string_view last) {
  std::string out;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) out += i + 1 == words.size() ? last : ", ";
    out += words[i];
  }
  return out;
}

bool is_mistyped(const Table& table, const toml::table& row, std::string_view key) {
  const std::vector<std::string_view> known = keys_of(table);
  std::size_t unknown = 0;
  for (const auto& [other, node] : row) {
    if (table.find(other.str())) continue;
    if (++unknown > most_unknown) return false;
    if (nearest(other.str(), known) == key) return true;
  }
  return false;
}

void RowKeys::refuse_unknown(const std::string& lead) const {
  const std::vector<std::string_view> known = keys_of(table);
  std::size_t unknown = 0;
  for (const auto& [key, node] : from) {
    const std::string_view name = key.str();
    if (table.find(name)) continue;
    if (table.key.empty() &&
        std::any_of(tables.begin(), tables.end(), [&](const Table& other) { return other.key == name; })) {
      continue;
    }
    Problem problem = document.at(node);
    problem.where = where;
    if (++unknown > most_unknown) continue;
    if (table.key.empty() && node.is_table()) {
      problem.what = fmt::format("unknown table [{}]", name);
    } else if (table.key.empty() && node.is_array_of_tables()) {
      problem.what = fmt::format("unknown table [[{}]]", name);
    } else {
      problem.what = fmt::format("unknown key \"{}\"", name);
      if (!lead.empty()) problem.what += fmt::format(" of {}", lead.substr(0, lead.size() - 1));
    }
    if (table.key.empty()) {
      std::vector<std::string_view> names = known;
      for (const Table& other : tables) {
        if (!other.key.empty()) names.push_back(other.key);
      }
      if (const auto near = nearest(name, names)) {
        const auto meant = std::find_if(tables.begin(), tables.end(), [&](const Table& t) { return t.key == *near; });
        problem.hint = fmt::format("Did you mean {}?", meant == tables.end() ? std::string(*near) : meant->heading());
      } else {
        problem.why = fmt::format("expected one of {}", plain_list(names, " or "));
      }
    } else if (const auto near = nearest(name, known)) {
      problem.hint = fmt::format("Did you mean \"{}\"?", *near);
    } else {
      std::vector<std::string> homes;
      for (const Table& other : tables)
        if (!other.key.empty() && other.find(name)) homes.push_back(other.heading());
      if (!homes.empty()) {
        problem.hint = fmt::format("It belongs to {}",
                                   plain_list(std::vector<std::string_view>(homes.begin(), homes.end()), " and "));
      } else {
        problem.why = fmt::format("expected one of {}", plain_list(known, " or "));
      }
    }
    problems.add(std::move(problem));
  }
  if (unknown <= most_unknown) return;
  Problem others = document.at(from);
  others.where = where;
  others.what = fmt::format("{} more keys are unknown", unknown - most_unknown);
  problems.add(std::move(others));
}

void RowKeys::refuse_exclusive() const {
  std::vector<std::string_view> reported;
  const auto is_reported = [&](std::string_view key) {
    return std::find(reported.begin(), reported.end(), key) != reported.end();
  };
  for (const Setting& setting : table.settings) {
    if (!from.contains(setting.key) || is_reported(setting.key)) continue;
    std::vector<std::string_view> together{setting.key};
    for (const std::string_view other : table.excluded_by(setting.key)) {
      if (from.contains(other) && !is_reported(other)) together.push_back(other);
    }
    if (together.size() == 1) continue;
    reported.insert(reported.end(), together.begin(), together.end());
    Problem problem = document.at(*from.get(together[1]));
    problem.where = where;
    problem.what = fmt::format("{} are given together", plain_list(together, " and "));
    problem.why = "they exclude each other";
    problems.add(std::move(problem));
  }
}

}  // namespace talus::project
