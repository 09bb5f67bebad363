#include "talus/archive/run_description.hpp"

#include <algorithm>

#include "talus/archive/design_json.hpp"
#include "talus/core/bytes.hpp"
#include "talus/files/json_text.hpp"
#include "talus/results/ensemble.hpp"

namespace talus {

using Json = nlohmann::ordered_json;

namespace {

Json names_of(const MapSubjects& subjects) {
  Json names = Json::array();
  for (std::size_t k = 0; k < subjects.size(); ++k) {
    if (subjects[k]) names.push_back(map_subject_names[k]);
  }
  return names;
}

MapSubjects subjects_from(const Json& names) {
  MapSubjects subjects;
  for (const Json& name : names) {
    const auto found = std::ranges::find(map_subject_names, name.get_ref<const std::string&>());
    expect_bytes(found != map_subject_names.end(), "the description's maps have an unknown subject");
    subjects.set(static_cast<std::size_t>(found - map_subject_names.begin()));
  }
  expect_bytes(subjects.any(), "the description's maps have no subject");
  return subjects;
}

/// Everything except the parts that may be long.
Json head_of(const RunDescription& description) {
  Json json;
  json["name"] = description.name;
  json["fingerprint"] = description.fingerprint;
  json["paths_revision"] = description.paths_revision;
  json["sample"] = description.sample;
  json["rocks"] = description.rocks;
  json["barriers"] = description.barriers;
  json["crs_wkt"] = description.crs_wkt;
  json["sources"] = description.sources;
  json["wants_maps"] = description.wants_maps;
  json["wants_envelopes"] = description.wants_envelopes;
  json["wants_geopackage"] = description.wants_geopackage;
  json["wants_report"] = description.wants_report;
  if (description.store_bytes) {
    json["store_bytes"] = *description.store_bytes;
    json["store_rocks"] = description.store_rocks;
  }
  json["warnings"] = description.warnings.texts;
  if (!description.warnings.kinds.empty()) json["warning_kinds"] = json_of(description.warnings.kinds);
  if (const auto& maps = description.maps) {
    json["maps"] = {{"origin", {maps->origin.x(), maps->origin.y()}},
                    {"cell", {maps->cell.x(), maps->cell.y()}},
                    {"by_source", maps->by_source},
                    {"subjects", names_of(maps->selection.subjects)},
                    {"percentiles", maps->selection.percentiles},
                    {"means", maps->selection.means}};
  }
  if (const auto& maps = description.maps; maps && maps->ensembles > 0) {
    json["maps"]["ensembles"] = maps->ensembles;
    json["maps"]["bands"] = names_of(maps->selection.bands);
  }
  if (description.design) json["design"] = plan_json(*description.design);
  json["inputs"] = json_of(description.inputs);
  return json;
}

std::string text_of(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

}  // namespace

std::string json_text(const RunDescription& description) {
  std::string text = text_of(head_of(description));
  text.back() = ',';
  return text + R"("project":)" + text_of(description.project) + R"(,"model":)" + text_of(description.model) + '}';
}

namespace {

/// Checks that the barriers and sources of the sums are those of the model.
void check_model(const RunDescription& description) {
  const Json& model = description.model;
  for (const char* key : {"seed", "energy_datum_m", "origin_m", "terrain", "barriers", "sources", "releases"})
    (void)model.at(key);
  const Json& origin = model.at("origin_m");
  expect_bytes(origin.is_array() && origin.size() == 3 &&
                   std::ranges::all_of(origin, [](const Json& x) { return x.is_number(); }),
               "the description's origin is damaged");
  expect_bytes(model.at("barriers").is_array() && model.at("barriers").size() == description.barriers,
               "the description's barriers disagree");
  for (const Json& barrier : model.at("barriers")) (void)barrier.at("name").get_ref<const std::string&>();
  expect_bytes(description.project.is_object(), "the description has no project");
}

RunDescription read(const Json& json) {
  RunDescription description;
  json.at("name").get_to(description.name);
  json.at("fingerprint").get_to(description.fingerprint);
  description.paths_revision = json.value("paths_revision", std::uint64_t{0});
  json.at("sample").get_to(description.sample);
  json.at("rocks").get_to(description.rocks);
  json.at("barriers").get_to(description.barriers);
  json.at("crs_wkt").get_to(description.crs_wkt);
  json.at("sources").get_to(description.sources);
  json.at("wants_maps").get_to(description.wants_maps);
  description.wants_envelopes = json.value("wants_envelopes", false);
  json.at("wants_geopackage").get_to(description.wants_geopackage);
  json.at("wants_report").get_to(description.wants_report);
  if (json.contains("store_bytes")) {
    description.store_bytes = json.at("store_bytes").get<std::uint64_t>();
    json.at("store_rocks").get_to(description.store_rocks);
  }
  json.at("warnings").get_to(description.warnings.texts);
  if (json.contains("warning_kinds")) read_json(json.at("warning_kinds"), {}, description.warnings.kinds);
  description.project = json.at("project");
  description.model = json.at("model");
  if (json.contains("maps")) {
    const Json& given = json.at("maps");
    MapPlan& maps = description.maps.emplace();
    const auto pair = [&](const char* key) {
      return Vec2(given.at(key).at(0).get<double>(), given.at(key).at(1).get<double>());
    };
    maps.origin = pair("origin");
    maps.cell = pair("cell");
    expect_bytes(maps.cell.x() > 0 && maps.cell.y() > 0, "the description's maps have no cells");
    given.at("by_source").get_to(maps.by_source);
    if (given.contains("subjects")) maps.selection.subjects = subjects_from(given.at("subjects"));
    given.at("percentiles").get_to(maps.selection.percentiles);
    maps.selection.means = given.value("means", true);
    if (given.contains("ensembles")) {
      given.at("ensembles").get_to(maps.ensembles);
      maps.selection.bands = subjects_from(given.at("bands"));
      expect_bytes((maps.selection.bands & ~(maps.selection.subjects & banded_map_subjects)).none() &&
                       maps.ensembles > 1 && maps.ensembles <= most_ensembles,
                   "the description's maps have bands that they cannot have");
    }
  }
  if (json.contains("inputs")) read_json(json.at("inputs"), {}, description.inputs);
  if (json.contains("design")) description.design = plan_from(json.at("design"), description.barriers);
  check_model(description);
  return description;
}

}  // namespace

Vec3 origin_of(const RunDescription& description) {
  const Json& origin = description.model.at("origin_m");
  return {origin.at(0).get<double>(), origin.at(1).get<double>(), origin.at(2).get<double>()};
}

TableRocks rocks_in_tables(const RunDescription& description) {
  const auto limit = [&](const char* key, const char* without_it) -> TableRocks::Limit {
    const Json::json_pointer place(std::string("/output/") + key);
    const Json value = description.project.contains(place) ? description.project.at(place) : Json(without_it);
    if (value == "all") return std::nullopt;
    return value == "none" ? 0 : value.get<std::uint64_t>();
  };
  return TableRocks(
      description.rocks,
      {.endpoints = limit("endpoints", "all"), .paths = limit("paths", "all"), .impacts = limit("impacts", "none")});
}

RunDescription description_from(std::string_view json_text) {
  expect_bytes(depth_of_json(json_text) <= deepest_json, "the description of the run is damaged");
  try {
    return read(Json::parse(json_text));
  } catch (const nlohmann::json::exception&) {
    throw BadBytes("the description of the run is damaged");
  } catch (const BadField&) {
    throw BadBytes("the description of the run is damaged");
  }
}

}  // namespace talus
