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
constexpr std::string_view own_keys[] = {"key", "meaning", "source"};

std::string text_of(const toml::table& from, std::string_view key) { return from[key].value_or(std::string()); }

const Table& material_table() {
  for (const Table& table : tables()) {
    if (table.key == "material") return table;
  }
  throw std::logic_error("no table [[material]] is declared");
}

std::vector<LibraryMaterial> read_library() {
  const Document document(material_library_text(), "materials.toml");
  const toml::table& root = document.root();
  Problems problems;
  ValueReader reader(document, problems);
  std::vector<LibraryMaterial> library;
  for (const toml::node& node : *root["material"].as_array()) {
    toml::table values = *node.as_table();
    LibraryMaterial& entry = library.emplace_back();
    entry.key = text_of(values, "key");
    entry.meaning = text_of(values, "meaning");
    const auto source = root["source"][text_of(values, "source")];
    entry.source = source["text"].value_or(std::string());
    entry.checked = source["checked"].value_or(std::string());
    for (const std::string_view key : own_keys) values.erase(key);
    for (const auto& [key, value] : values) entry.given.emplace_back(key.str());
    values.insert("name", entry.key);
    reader.read(material_table(), values, &entry.material, entry.key);
  }
  // The file is embedded in the program.
  if (problems.has_errors()) throw std::logic_error(problems.text());
  return library;
}

std::string property(const LibraryMaterial& entry, std::string_view key) {
  const Setting& declared = setting("material", key);
  Material copy = entry.material;  // slots are not const
  const auto slot = declared.slot(&copy);
  const auto* distribution = std::get_if<Distribution*>(&slot);
  return distribution ? in_words(**distribution) : "";
}

}  // namespace

const std::vector<LibraryMaterial>& material_library() {
  static const std::vector<LibraryMaterial> library = read_library();
  return library;
}

std::string in_words(const Distribution& property) {
  if (property.kind == DistributionKind::none) return fmt::format("{}", property.mean);
  if (property.kind == DistributionKind::uniform && property.rel_min && property.rel_max) {
    return fmt::format("{:.6g} to {:.6g}", property.mean - *property.rel_min, property.mean + *property.rel_max);
  }
  const std::string_view kind = word(property.kind);
  if (!property.std_dev) return fmt::format("{} ({})", property.mean, kind);
  return fmt::format("{} ({}, sd {})", property.mean, kind, *property.std_dev);
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

`talus materials` prints this table. Where a source gives a range, all values in it are equally likely. What a source
does not give (friction, roughness, a spread) has the default of [the project file](project-file.md).

These values are only a starting point: restitution depends on the speed, the angle and the size of the rock as much as
on the ground, and the tables do not agree with each other. Calibrate them with what is known of the site.

)";
  std::vector<std::string> given;
  for (const Setting& declared : material_table().settings) {
    for (const LibraryMaterial& entry : material_library()) {
      if (std::find(entry.given.begin(), entry.given.end(), declared.key) == entry.given.end()) continue;
      given.emplace_back(declared.key);
      break;
    }
  }
  std::vector<std::string> sources;
  page += "| `like` | ground |";
  for (const std::string& key : given) page += fmt::format(" {} |", key);
  page += " source |\n| --- | --- |";
  for (std::size_t k = 0; k < given.size(); ++k) page += " --- |";
  page += " --- |\n";
  for (const LibraryMaterial& entry : material_library()) {
    auto source = std::find(sources.begin(), sources.end(), entry.source);
    if (source == sources.end()) source = sources.insert(source, entry.source);
    page += fmt::format("| `{}` | {} |", entry.key, entry.meaning);
    for (const std::string& key : given) {
      const bool has = std::find(entry.given.begin(), entry.given.end(), key) != entry.given.end();
      page += fmt::format(" {} |", has ? property(entry, key) : "");
    }
    page += fmt::format(" [{}] |\n", source - sources.begin() + 1);
  }
  page += '\n';
  for (std::size_t k = 0; k < sources.size(); ++k) {
    for (const LibraryMaterial& entry : material_library()) {
      if (entry.source != sources[k]) continue;
      page += fmt::format("{}. {}. *{}.*\n", k + 1, entry.source, entry.checked);
      break;
    }
  }
  return page;
}

}  // namespace talus::project
