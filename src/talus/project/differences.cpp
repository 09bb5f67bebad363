#include "talus/project/differences.hpp"

#include <algorithm>
#include <set>
#include <unordered_map>

namespace talus::project {

namespace {

using Json = nlohmann::ordered_json;
using Settings = std::vector<std::pair<std::string, Json>>;

/// The names of the entries of a list of tables; empty unless all entries have different names.
std::vector<std::string> unique_names_of(const Json& list) {
  std::vector<std::string> names;
  std::set<std::string> seen;
  for (const Json& entry : list) {
    const auto name = entry.find("name");
    if (name == entry.end() || !name->is_string() || !seen.insert(name->get<std::string>()).second) break;
    names.push_back(*name);
  }
  if (names.size() != list.size()) names.clear();
  return names;
}

void flatten(const Json& json, const std::string& key, Settings& settings) {
  const auto below = [&](const std::string& name) { return key.empty() ? name : key + "." + name; };
  const auto is_table = [](const Json& entry) { return entry.is_object(); };
  if (json.is_object()) {
    for (const auto& [name, value] : json.items()) flatten(value, below(name), settings);
  } else if (json.is_array() && !json.empty() && std::all_of(json.begin(), json.end(), is_table)) {
    const std::vector<std::string> names = unique_names_of(json);
    for (std::size_t k = 0; k < json.size(); ++k) {
      Json entry = json[k];
      if (!names.empty()) entry.erase("name");
      flatten(entry, below(names.empty() ? std::to_string(k) : names[k]), settings);
    }
  } else {
    settings.emplace_back(key, json);
  }
}

Settings flat(const Json& project) {
  Settings settings;
  flatten(project, "", settings);
  return settings;
}

std::unordered_map<std::string, const Json*> by_key(const Settings& settings) {
  std::unordered_map<std::string, const Json*> index;
  for (const auto& [key, value] : settings) index.emplace(key, &value);
  return index;
}

}  // namespace

std::vector<Difference> differences(const Json& here, const Json& there) {
  const Settings ours = flat(here), theirs = flat(there);
  const auto our_index = by_key(ours), their_index = by_key(theirs);
  std::vector<Difference> found;
  for (const auto& [key, value] : ours) {
    const auto other = their_index.find(key);
    if (other == their_index.end()) {
      found.push_back({key, value, nullptr});
    } else if (value != *other->second) {
      found.push_back({key, value, *other->second});
    }
  }
  for (const auto& [key, value] : theirs)
    if (!our_index.contains(key)) found.push_back({key, nullptr, value});
  return found;
}

}  // namespace talus::project
