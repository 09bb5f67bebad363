#include "talus/project/setting_paths.hpp"

#include <algorithm>
#include <functional>
#include <numeric>

namespace talus::project {

namespace {

bool is_bare(std::string_view key) {
  return !key.empty() && std::all_of(key.begin(), key.end(), [](char letter) {
    return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') || (letter >= '0' && letter <= '9') ||
           letter == '_' || letter == '-';
  });
}

std::string_view key_of(const toml::table& table, const toml::node& value) {
  for (const auto& [key, node] : table)
    if (&node == &value) return key.str();
  return {};
}

}  // namespace

std::optional<std::vector<std::string>> parts_of(std::string_view path) {
  std::vector<std::string> parts(1);
  bool quoted_part = false;
  for (const char letter : path) {
    if (letter == '"') {
      quoted_part = !quoted_part;
    } else if (letter == '.' && !quoted_part) {
      parts.emplace_back();
    } else {
      parts.back() += letter;
    }
  }
  if (quoted_part) return std::nullopt;
  for (const std::string& part : parts) {
    if (part.empty()) return std::nullopt;
  }
  return parts;
}

SettingPaths::SettingPaths(const toml::table& root) : root_(root) {
  for (const auto& [key, node] : root) add(node, none, 0);
  by_address_.resize(entries_.size());
  std::iota(by_address_.begin(), by_address_.end(), 0U);
  std::sort(by_address_.begin(), by_address_.end(),
            [&](std::uint32_t a, std::uint32_t b) { return std::less<>()(entries_[a].node, entries_[b].node); });
}

void SettingPaths::add(const toml::node& node, std::uint32_t parent, std::uint32_t number) {
  const auto entry = static_cast<std::uint32_t>(entries_.size());
  entries_.push_back({&node, parent, number});
  if (const toml::table* table = node.as_table()) {
    for (const auto& [key, value] : *table) add(value, entry, 0);
  } else if (const toml::array* list = node.as_array()) {
    for (std::uint32_t k = 0; k < list->size(); ++k) add((*list)[k], entry, k);
  }
}

std::string SettingPaths::below(std::string path, std::string_view key) {
  if (!path.empty()) path += '.';
  return is_bare(key) || key.empty() ? path.append(key) : path.append("\"").append(key).append("\"");
}

std::string SettingPaths::path(std::uint32_t entry) const {
  const auto& [node, parent, number] = entries_[entry];
  const toml::node& holder = parent == none ? root_ : *entries_[parent].node;
  std::string before = parent == none ? std::string() : path(parent);
  const toml::table* table = holder.as_table();
  return below(std::move(before), table ? key_of(*table, *node) : std::string_view(std::to_string(number)));
}

std::string SettingPaths::of(const toml::node& node) const {
  const auto found = std::lower_bound(
      by_address_.begin(), by_address_.end(), &node,
      [&](std::uint32_t entry, const toml::node* address) { return std::less<>()(entries_[entry].node, address); });
  return found != by_address_.end() && entries_[*found].node == &node ? path(*found) : std::string();
}

std::string SettingPaths::on_line(std::uint32_t line) const {
  for (std::uint32_t k = 0; k < entries_.size(); ++k) {
    const toml::node& node = *entries_[k].node;
    // A list of tables has no line.
    if (node.source().begin.line == line && !node.is_array_of_tables()) return path(k);
  }
  return {};
}

std::string SettingPaths::of_text(std::string_view text) const {
  for (std::uint32_t k = 0; k < entries_.size(); ++k) {
    const auto* value = entries_[k].node->as_string();
    if (value && value->get() == text) return path(k);
  }
  return {};
}

}  // namespace talus::project
