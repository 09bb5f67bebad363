#include "talus/project/setting_paths.hpp"

#include <algorithm>

namespace talus::project {

namespace {

bool is_bare(std::string_view key) {
  return !key.empty() && std::all_of(key.begin(), key.end(), [](char letter) {
    return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') || (letter >= '0' && letter <= '9') ||
           letter == '_' || letter == '-';
  });
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

SettingPaths::SettingPaths(const toml::table& root) {
  for (const auto& [key, node] : root) add(node, none, 0, key.str());
}

void SettingPaths::add(const toml::node& node, std::uint32_t parent, std::uint32_t number, std::string_view key) {
  const auto entry = static_cast<std::uint32_t>(entries_.size());
  entries_.push_back({&node, parent, number, key});
  by_address_.emplace(&node, entry);
  // A list of tables has no line.
  if (!node.is_array_of_tables()) by_line_.emplace(node.source().begin.line, entry);
  if (const auto* text = node.as_string()) by_text_.emplace(text->get(), entry);
  if (const toml::table* table = node.as_table()) {
    for (const auto& [name, value] : *table) add(value, entry, 0, name.str());
  } else if (const toml::array* list = node.as_array()) {
    for (std::uint32_t k = 0; k < list->size(); ++k) add((*list)[k], entry, k, {});
  }
}

std::string SettingPaths::below(std::string path, std::string_view key) {
  if (!path.empty()) path += '.';
  return is_bare(key) || key.empty() ? path.append(key) : path.append("\"").append(key).append("\"");
}

std::string SettingPaths::path(std::uint32_t entry) const {
  const auto& [node, parent, number, key] = entries_[entry];
  std::string before = parent == none ? std::string() : path(parent);
  const bool is_in_list = parent != none && entries_[parent].node->is_array();
  return below(std::move(before), is_in_list ? std::string_view(std::to_string(number)) : key);
}

std::string SettingPaths::of(const toml::node& node) const {
  const auto found = by_address_.find(&node);
  return found != by_address_.end() ? path(found->second) : std::string();
}

std::string SettingPaths::on_line(std::uint32_t line) const {
  const auto found = by_line_.find(line);
  return found != by_line_.end() ? path(found->second) : std::string();
}

std::string SettingPaths::of_text(std::string_view text) const {
  const auto found = by_text_.find(text);
  return found != by_text_.end() ? path(found->second) : std::string();
}

}  // namespace talus::project
