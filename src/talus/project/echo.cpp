#include "talus/project/echo.hpp"

#include <cmath>
#include <type_traits>

namespace talus::project {
namespace {

using Json = nlohmann::ordered_json;
using Written = std::optional<Json>;

Json number(double value) { return std::isinf(value) ? Json(value > 0 ? "inf" : "-inf") : Json(value); }

Written table_of(const Table& table, Row row, bool two_dimensional) {
  Json out = Json::object();
  for (const Setting& setting : table.settings) {
    if (auto value = written(setting.slot(row), two_dimensional)) out[std::string(setting.key)] = std::move(*value);
  }
  return out;
}

/// A point of a seeder, in the form of the file.
Json position(const Seeder& seeder, const std::array<double, 3>& point, bool two_dimensional) {
  Json out = two_dimensional ? Json{point[0]} : Json{point[0], point[1]};
  if (seeder.height_above_m) return out;
  out.push_back(seeder.at_points.z_is_surface ? Json("surface") : Json(point[2]));
  return out;
}

struct Writer {
  bool two_dimensional;

  Written operator()(const bool* value) const { return *value; }
  Written operator()(const double* value) const { return number(*value); }
  Written operator()(const std::optional<double>* value) const {
    return *value ? Written(number(**value)) : std::nullopt;
  }
  Written operator()(const std::int64_t* value) const { return *value; }
  Written operator()(const std::uint64_t* value) const { return *value; }
  Written operator()(const std::string* value) const { return value->empty() ? Written() : Written(*value); }
  Written operator()(const std::filesystem::path* value) const {
    return value->empty() ? Written() : Written(value->string());
  }
  Written operator()(const std::optional<std::int64_t>* value) const { return *value ? Written(**value) : Written(); }
  Written operator()(const std::array<double, 3>* value) const { return *value; }
  Written operator()(Distribution* value) const {
    Written out = table_of(distribution_table(), value, two_dimensional);
    if (value->kind == DistributionKind::empirical) out->erase("mean");
    return out;
  }
  Written operator()(std::optional<Distribution>* value) const { return *value ? (*this)(&**value) : std::nullopt; }
  Written operator()(const std::vector<double>* value) const { return *value; }  // an empty list has a meaning
  Written operator()(const std::optional<std::vector<double>>* value) const {
    return *value ? Written(**value) : Written();
  }
  Written operator()(const std::map<std::string, std::string>* value) const {
    return value->empty() ? Written() : Written(Json(*value));
  }
  Written operator()(const std::map<std::int32_t, std::string>* value) const {
    if (value->empty()) return std::nullopt;
    Json out = Json::object();
    for (const auto& [number, text] : *value) out[std::to_string(number)] = text;
    return out;
  }
  Written operator()(const MapSubjects* value) const {
    if (value->all() || value->none()) return value->all();
    Json names = Json::array();
    for (std::size_t k = 0; k < value->size(); ++k) {
      if ((*value)[k]) names.push_back(map_subject_names[k]);
    }
    return names;
  }
  template <class Item>
  Written operator()(const std::vector<Item>* value) const {
    return value->empty() ? Written() : Written(*value);
  }
  template <class Enumeration>
  requires std::is_enum_v<Enumeration> Written operator()(const Enumeration* value) const { return word(*value); }
  Written operator()(PositionSlot slot) const {
    if (slot.seeder->type != SeederType::point || slot.seeder->at_points.points.empty()) return std::nullopt;
    return position(*slot.seeder, slot.seeder->at_points.points.front(), two_dimensional);
  }
  Written operator()(PointsSlot slot) const {
    if (slot.seeder->type != SeederType::line || slot.seeder->at_points.points.empty()) return std::nullopt;
    Json out = Json::array();
    for (const auto& point : slot.seeder->at_points.points)
      out.push_back(position(*slot.seeder, point, two_dimensional));
    return out;
  }
  Written operator()(PlanLineSlot slot) const {
    if (slot.line->empty()) return std::nullopt;
    return two_dimensional ? Json(slot.line->front()[0]) : Json(*slot.line);
  }
  Written operator()(PlanPointSlot slot) const {
    if (!*slot.point) return std::nullopt;
    return two_dimensional ? Json{(**slot.point)[0]} : Json(**slot.point);
  }
  Written operator()(PlanPolygonSlot slot) const { return (*this)(slot.polygon); }
  Written operator()(SizeSlot slot) const {
    Distribution* const given = distribution_in(slot);
    return given ? (*this)(given) : std::nullopt;
  }
  Written operator()(LawsSlot slot) const { return word(slot.analysis->laws); }
  Written operator()(LibrarySlot slot) const { return (*this)(&slot.material->like); }
  Written operator()(DirectionSlot slot) const {
    if (!*slot.direction) return Json("downslope");
    const auto& [x, y, z] = **slot.direction;
    return two_dimensional ? Json{x, z} : Json{x, y, z};
  }
  Written operator()(LimitSlot slot) const {
    const auto& limit = *slot.limit;
    return !limit ? Json("all") : *limit == 0 ? Json("none") : Json(*limit);
  }
  Written operator()(SectionSlot slot) const {
    return slot.file->empty() ? (*this)(slot.vertices) : (*this)(slot.file);
  }
  Written operator()(FilesSlot slot) const {
    if (slot.files->empty()) return std::nullopt;
    if (slot.files->size() == 1) return slot.files->front().string();
    Json out = Json::array();
    for (const std::filesystem::path& file : *slot.files) out.push_back(file.string());
    return out;
  }
  Written operator()(MapCellSlot slot) const {
    if (!*slot.size) return Json("terrain");
    if (**slot.size == 0) return std::nullopt;  // the terrain decides
    return Json(**slot.size);
  }
};

/// Of keys that exclude each other, removes those with a default in favour of the one that was given.
void drop_excluded(const Table& table, Json& row) {
  for (const Setting& setting : table.settings) {
    if (!row.contains(setting.key) || !default_of(table, setting)) continue;
    for (const std::string_view other : table.excluded_by(setting.key)) {
      const Setting* excluded = table.find(other);
      if (row.contains(other) && !default_of(table, *excluded)) row.erase(std::string(setting.key));
    }
  }
}

}  // namespace

Written written(const Slot& slot, bool two_dimensional) { return std::visit(Writer{two_dimensional}, slot); }

Written default_of(const Table& table, const Setting& setting, LawSet laws) {
  if (setting.required) return std::nullopt;
  if (!table.add) {
    Distribution blank;
    return written(setting.slot(&blank), false);
  }
  Project blank;
  blank.analysis = Analysis::of_laws(laws);
  return written(setting.slot(table.add(blank)), false);
}

Json echo(const Project& project) {
  Project copy = project;  // slots are not const
  Json out = Json::object();
  for (const Table& table : tables()) {
    Json list = Json::array();
    for (const Row& row : table.rows(copy)) {
      Json written_row = *table_of(table, row, project.is_2d());
      drop_excluded(table, written_row);
      list.push_back(std::move(written_row));
    }
    if (table.key.empty()) {
      out.update(list[0]);
    } else if (!table.repeated) {
      if (!list.empty()) out[std::string(table.key)] = std::move(list[0]);
    } else if (!list.empty()) {
      out[std::string(table.key)] = std::move(list);
    }
  }
  return out;
}

Json without_presentation(const Json& echo) {
  Json rest = Json::object();
  for (const auto& [key, value] : echo.items()) {
    if (key != "report" && key != "layer") rest[key] = value;
  }
  return rest;
}

namespace {

/// JSON as inline TOML.
std::string as_toml(const Json& value) {
  std::string out;
  if (value == "inf") return "inf";
  if (value.is_object()) {
    for (const auto& [key, item] : value.items()) {
      out += (out.empty() ? "" : ", ") + Json(key).dump() + " = " + as_toml(item);
    }
    return "{ " + out + " }";
  }
  if (value.is_array()) {
    for (const auto& item : value) out += (out.empty() ? "" : ", ") + as_toml(item);
    return '[' + out + ']';
  }
  return value.dump();
}

}  // namespace

std::string text_of_echo(const Json& echoed) {
  std::string out;
  for (const auto& [key, value] : echoed.items()) out += key + " = " + as_toml(value) + '\n';
  return out;
}

}  // namespace talus::project
