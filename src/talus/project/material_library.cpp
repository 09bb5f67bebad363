#include "talus/project/material_library.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "talus/project/document.hpp"
#include "talus/project/settings.hpp"
#include "talus/project/values.hpp"

namespace talus::project {
namespace {

// The keys of an entry in addition to those of a [[material]].
constexpr std::string_view own_keys[] = {"key", "meaning", "source", "other_sources"};

std::string text_of(const toml::table& from, std::string_view key) { return from[key].value_or(std::string()); }

const Table& material_table() {
  for (const Table& table : tables()) {
    if (table.key == "material") return table;
  }
  throw std::logic_error("no table [[material]] is declared");
}

/// Numbers the sources in the order of their first use.
class Sources {
 public:
  Sources(const toml::table& root, std::vector<LibrarySource>& list) : root_(root), list_(list) {}

  std::size_t number(const std::string& name) {
    const auto known = std::ranges::find(names_, name);
    if (known != names_.end()) return static_cast<std::size_t>(known - names_.begin());
    const toml::table* source = root_["source"][name].as_table();
    if (!source) throw std::logic_error("materials.toml has no source " + name);
    names_.push_back(name);
    list_.push_back({text_of(*source, "text"), text_of(*source, "limits"), text_of(*source, "checked")});
    return names_.size() - 1;
  }

 private:
  const toml::table& root_;
  std::vector<LibrarySource>& list_;
  std::vector<std::string> names_;
};

MaterialLibrary read_library() {
  const Document document(material_library_text(), "materials.toml");
  const toml::table& root = document.root();
  Problems problems;
  ValueReader reader(document, problems);
  MaterialLibrary library;
  Sources sources(root, library.sources);
  for (const toml::node& node : *root["material"].as_array()) {
    toml::table values = *node.as_table();
    LibraryMaterial& entry = library.materials.emplace_back();
    entry.key = text_of(values, "key");
    entry.meaning = text_of(values, "meaning");
    const std::string source = text_of(values, "source");
    const toml::node* const other = values.get("other_sources");
    const toml::table others = other ? *other->as_table() : toml::table();
    for (const std::string_view key : own_keys) values.erase(key);
    for (const Setting& declared : material_table().settings) {
      if (!values.contains(declared.key)) continue;
      entry.given.push_back({std::string(declared.key), sources.number(others[declared.key].value_or(source))});
    }
    for (const auto& [key, name] : others) {
      if (!entry.find(key.str())) throw std::logic_error(entry.key + " has a source for a value that it does not give");
    }
    values.insert("name", entry.key);
    reader.read(material_table(), values, &entry.material, entry.key);
  }
  // The file is embedded in the program.
  if (problems.has_errors()) throw std::logic_error(problems.text());
  return library;
}

}  // namespace

const LibraryValue* LibraryMaterial::find(std::string_view setting_key) const {
  const auto found = std::ranges::find(given, setting_key, &LibraryValue::key);
  return found == given.end() ? nullptr : &*found;
}

const LibraryMaterial* MaterialLibrary::find(std::string_view key) const {
  const auto found = std::ranges::find(materials, key, &LibraryMaterial::key);
  return found == materials.end() ? nullptr : &*found;
}

std::vector<std::string> MaterialLibrary::given() const {
  std::vector<std::string> keys;
  for (const Setting& declared : material_table().settings) {
    const auto gives = [&](const LibraryMaterial& entry) { return entry.find(declared.key) != nullptr; };
    if (std::ranges::any_of(materials, gives)) keys.emplace_back(declared.key);
  }
  return keys;
}

const MaterialLibrary& material_library() {
  static const MaterialLibrary library = read_library();
  return library;
}

std::string in_words(const Distribution& property) {
  if (property.kind == DistributionKind::empirical) return fmt::format("as in {}", property.file.string());
  if (property.kind == DistributionKind::none) return fmt::format("{}", property.mean);
  if (property.kind == DistributionKind::uniform && property.rel_min && property.rel_max) {
    return fmt::format("{:.6g} to {:.6g}", property.mean - *property.rel_min, property.mean + *property.rel_max);
  }
  const std::string_view kind = word(property.kind);
  if (!property.std_dev) return fmt::format("{} ({})", property.mean, kind);
  return fmt::format("{} ({}, sd {})", property.mean, kind, *property.std_dev);
}

std::string in_words(const LibraryMaterial& entry, std::string_view key) {
  const LibraryValue* value = entry.find(key);
  if (!value) return "";
  Material copy = entry.material;  // slots are not const
  const auto slot = setting("material", key).slot(&copy);
  const auto* distribution = std::get_if<Distribution*>(&slot);
  const auto* number = std::get_if<double*>(&slot);
  if (!distribution && !number)
    throw std::logic_error(entry.key + " gives a value that is neither number nor distribution");
  return fmt::format("{} [{}]", distribution ? in_words(**distribution) : fmt::format("{}", **number),
                     value->source + 1);
}

std::string materials_page() {
  std::string page = R"(# The library of materials

<!-- Generated from src/talus/project/materials.toml by material_library.cpp; do not edit. To renew it:
     TALUS_RENEW_REFERENCE=1 and run the test MaterialsPage.IsNotStale. -->

Typical grounds, each with the values of a publication. A project refers to one and overrides what is known better:

```toml
[[material]]
name = "Scree"
like = "talus_cover"
friction_angle_deg = 34
```

`talus materials` prints this table. The number behind a value is that of its source, below. Where a source gives a
range, all values in it are equally likely. What no source gives (an empty cell) has the default of [the project
file](project-file.md); a warning says so where a rigid sphere would roll by a default.

**Limits.** These values are only a starting point. Restitution depends on the speed, the angle and the size of the rock
as much as on the ground, and the tables do not agree with each other; the sources say below for which rocks and which
model their numbers hold. Few were measured. Rolling friction and roughness move the ends of trajectories most: [values
of spheres](laws.md#values-of-spheres) and [values of roughness](laws.md#values-of-roughness) say how to choose them.
Calibrate them with what is known of the site.

)";
  const MaterialLibrary& library = material_library();
  const std::vector<std::string> given = library.given();
  page += "| `like` | ground |";
  for (const std::string& key : given) page += fmt::format(" {} |", key);
  page += "\n| --- | --- |";
  for (std::size_t k = 0; k < given.size(); ++k) page += " --- |";
  page += '\n';
  for (const LibraryMaterial& entry : library.materials) {
    page += fmt::format("| `{}` | {} |", entry.key, entry.meaning);
    for (const std::string& key : given) page += fmt::format(" {} |", in_words(entry, key));
    page += '\n';
  }
  page += '\n';
  for (std::size_t k = 0; k < library.sources.size(); ++k) {
    const LibrarySource& source = library.sources[k];
    page += fmt::format("{}. {}.\n   - Limits: {}.\n   - Checked: {}.\n", k + 1, source.text, source.limits,
                        source.checked);
  }
  return page;
}

}  // namespace talus::project
