#include "talus/project/schema.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "talus/project/echo.hpp"
#include "talus/project/material_library.hpp"
#include "talus/project/settings.hpp"

namespace talus::project {
namespace {

using Json = nlohmann::ordered_json;

Json with_range(Json type, const Range& range) {
  if (std::isfinite(range.least)) type[range.least_excluded ? "exclusiveMinimum" : "minimum"] = range.least;
  if (std::isfinite(range.most)) type[range.most_excluded ? "exclusiveMaximum" : "maximum"] = range.most;
  return type;
}

Json list_of(Json items, std::size_t least) {
  return {{"type", "array"}, {"items", std::move(items)}, {"minItems", least}};
}

Json tuple_of(const Json& item, std::size_t least, std::size_t most) {
  return {{"type", "array"}, {"items", item}, {"minItems", least}, {"maxItems", most}};
}

Json table_schema(const Table& table);

/// The JSON type of a member.
struct Typed {
  const Range& range;

  Json number() const { return with_range({{"type", "number"}}, range); }
  Json whole() const { return with_range({{"type", "integer"}}, range); }
  Json text() const { return {{"type", "string"}, {"minLength", 1}}; }

  Json operator()(const bool*) const { return {{"type", "boolean"}}; }
  Json operator()(const double*) const { return number(); }
  Json operator()(const std::optional<double>*) const { return number(); }
  Json operator()(const std::int64_t*) const { return whole(); }
  Json operator()(const std::uint64_t*) const { return whole(); }
  Json operator()(const std::string*) const { return text(); }
  Json operator()(const std::filesystem::path*) const {
    Json file = text();
    file["x-file"] = true;
    return file;
  }
  Json operator()(const std::array<double, 3>*) const { return tuple_of(number(), 3, 3); }
  Json operator()(const Distribution*) const {
    Json parts = table_schema(distribution_table());
    parts["properties"]["mean"].update(number());
    return {{"anyOf", {number(), std::move(parts)}}};
  }
  Json operator()(const std::optional<Distribution>*) const {
    return (*this)(static_cast<const Distribution*>(nullptr));
  }
  Json operator()(const std::vector<std::array<double, 2>>*) const { return list_of(tuple_of(number(), 2, 2), 1); }
  Json operator()(const std::vector<std::array<double, 3>>*) const { return list_of(tuple_of(number(), 3, 3), 1); }
  Json operator()(const std::vector<std::array<std::int64_t, 3>>*) const { return list_of(tuple_of(whole(), 3, 3), 1); }
  Json operator()(const std::vector<std::vector<std::array<double, 3>>>*) const {
    return list_of(list_of(tuple_of(number(), 3, 3), 4), 1);
  }
  Json operator()(const std::vector<std::string>*) const { return list_of(text(), 1); }
  Json operator()(const std::vector<std::int64_t>*) const { return list_of(whole(), 1); }
  Json operator()(const std::vector<double>*) const { return list_of(number(), 0); }
  Json operator()(const std::optional<std::vector<double>>*) const { return list_of(number(), 0); }
  Json operator()(const std::map<std::int32_t, std::string>*) const {
    return {{"type", "object"},
            {"propertyNames", {{"pattern", "^-?[0-9]+$"}}},
            {"additionalProperties", text()},
            {"minProperties", 1}};
  }
  Json operator()(const std::optional<std::int64_t>*) const { return whole(); }
  Json operator()(const std::map<std::string, std::string>*) const {
    return {{"type", "object"}, {"additionalProperties", text()}, {"minProperties", 1}};
  }
  Json operator()(const MapSubjects*) const {
    Json names = list_of({{"enum", Json(words<MapSubject>())}}, 0);
    names["uniqueItems"] = true;
    return {{"anyOf", Json::array({Json{{"type", "boolean"}}, std::move(names)})}};
  }
  Json operator()(PlanPolygonSlot) const { return list_of(tuple_of(number(), 2, 2), 3); }
  Json operator()(SizeSlot) const { return (*this)(static_cast<const Distribution*>(nullptr)); }
  Json operator()(LawsSlot) const { return {{"enum", Json(words<LawSet>())}}; }
  Json operator()(LibrarySlot) const {
    Json keys = Json::array();
    for (const LibraryMaterial& entry : material_library().materials) keys.push_back(entry.key);
    return {{"enum", std::move(keys)}};
  }
  template <class Enumeration>
  requires std::is_enum_v<Enumeration> Json operator()(const Enumeration*) const {
    return {{"enum", Json(words<Enumeration>())}};
  }
  Json position() const { return tuple_of({{"anyOf", Json::array({number(), Json{{"const", "surface"}}})}}, 1, 3); }
  Json operator()(PositionSlot) const { return position(); }
  Json operator()(PointsSlot) const { return list_of(position(), 2); }
  Json operator()(PlanLineSlot) const {
    const Json plain = number();
    return {{"anyOf", Json::array({plain, tuple_of(plain, 1, 1), list_of(tuple_of(plain, 2, 2), 2)})}};
  }
  Json operator()(PlanPointSlot) const { return tuple_of(number(), 1, 2); }
  Json operator()(DirectionSlot) const {
    return {{"anyOf", Json::array({tuple_of(number(), 2, 3), Json{{"const", "downslope"}}})}};
  }
  Json operator()(LimitSlot) const { return {{"anyOf", Json::array({Json{{"enum", {"all", "none"}}}, whole()})}}; }
  Json operator()(SectionSlot slot) const {
    return {{"anyOf", Json::array({(*this)(slot.vertices), (*this)(slot.file)})}};
  }
  Json operator()(FilesSlot) const {
    Json file = (*this)(static_cast<const std::filesystem::path*>(nullptr));
    return {{"anyOf", Json::array({file, list_of(file, 1)})}};
  }
  Json operator()(MapCellSlot) const { return {{"anyOf", Json::array({Json{{"const", "terrain"}}, number()})}}; }
};

/// The JSON type of a setting. (The blank row only provides the type of its member.)
Json type_of(const Table& table, const Setting& setting) {
  Project blank;
  Distribution blank_distribution;
  const Row row = table.add ? table.add(blank) : Row(&blank_distribution);
  return std::visit(Typed{setting.range}, setting.slot(row));
}

/// A list of needs, each a list of alternatives: `[[{"key": "points", "given": true}, {"key": "lines", "given":
/// true}]]`.
Json conditions(const Setting& setting) {
  Json needs = Json::array();
  for (const Need& need : setting.applies_when) {
    Json any_of = Json::array();
    for (const auto& [key, kind, values] : need.any_of) {
      Json condition{{"key", std::string(key)}};
      if (kind == Condition::Kind::one_of || kind == Condition::Kind::none_of) {
        condition[kind == Condition::Kind::one_of ? "is" : "not"] = values;
      } else {
        condition["given"] = kind == Condition::Kind::given;
      }
      any_of.push_back(std::move(condition));
    }
    needs.push_back(std::move(any_of));
  }
  return needs;
}

Json topic_json(const Topic& topic) {
  return {{"document", std::string(topic.document)}, {"heading", std::string(topic.heading)}};
}

Json table_schema(const Table& table) {
  Json properties = Json::object();
  Json required = Json::array();
  for (const Setting& setting : table.settings) {
    Json property = type_of(table, setting);
    property["description"] = meaning_of(setting);
    if (setting.most_entries > 0) property["maxItems"] = setting.most_entries;
    if (!setting.unit.empty()) property["x-unit"] = std::string(setting.unit);
    if (auto value = default_of(table, setting); value && setting.without_it.empty() && *value != "inf") {
      property["default"] = std::move(*value);
      const auto rocfall = default_of(table, setting, LawSet::rocfall);
      if (rocfall && *rocfall != property["default"])
        property["x-default-by-laws"] = {{word(LawSet::rocfall), *rocfall}};
    } else if (!setting.without_it.empty()) {
      property["x-without-it"] = std::string(setting.without_it);
    }
    if (setting.range.infinite_allowed) property["x-infinite"] = true;
    if (const auto excluded = table.excluded_by(setting.key); !excluded.empty()) property["x-excludes"] = excluded;
    if (!setting.applies_when.empty()) property["x-applies-when"] = conditions(setting);
    if (!setting.always_accepted.empty()) property["x-asks-nothing"] = setting.always_accepted;
    if (!setting.title.empty()) property["x-title"] = std::string(setting.title);
    if (!setting.group.empty()) property["x-group"] = std::string(setting.group);
    if (!setting.topic.document.empty()) property["x-topic"] = topic_json(setting.topic);
    if (!setting.source.empty()) property["x-source"] = std::string(setting.source);
    if (setting.required) required.push_back(std::string(setting.key));
    properties[std::string(setting.key)] = std::move(property);
  }
  Json out{{"type", "object"}, {"description", std::string(table.meaning)}};
  out["properties"] = std::move(properties);
  out["additionalProperties"] = false;
  if (!table.choices.empty()) out["x-choices"] = table.choices;
  for (const auto& [title, folded] : table.groups) {
    out["x-groups"].push_back({{"title", std::string(title)}, {"folded", folded}});
  }
  if (!table.topic.document.empty()) out["x-topic"] = topic_json(table.topic);
  if (!required.empty()) out["required"] = std::move(required);
  return out;
}

}  // namespace

Json schema() {
  Json out;
  Json required = Json::array();
  for (const Table& table : tables()) {
    Json described = table_schema(table);
    if (table.key.empty()) {
      out = Json{{"$schema", "http://json-schema.org/draft-07/schema#"}, {"title", "Talus project"}};
      out.update(described);
      out["description"] = "A project file of Talus, an open rockfall simulator.";
      continue;
    }
    if (table.repeated) {
      described = list_of(std::move(described), table.required ? 1 : 0);
    }
    if (table.required) required.push_back(std::string(table.key));
    out["properties"][std::string(table.key)] = std::move(described);
  }
  out["required"] = std::move(required);
  return out;
}

}  // namespace talus::project
