// The part of ValueReader for positions, lines on plan and directions, in 2D and 3D.

#include <fmt/format.h>

#include <cmath>

#include "talus/meshing/cleaning.hpp"
#include "talus/meshing/plan_polygon.hpp"
#include "talus/project/values.hpp"

namespace talus::project {

std::optional<ValueReader::Position> ValueReader::position(const Value& value) {
  if (!dimension_is_known_) return std::nullopt;
  const std::size_t plan = two_dimensional_ ? 1 : 2;  // coordinates before z
  const bool has_height = value.row.contains("height_above_m");
  const std::string form =
      has_height ? (two_dimensional_ ? "[x]" : "[x, y]") : (two_dimensional_ ? "[x, z]" : "[x, y, z]");
  const toml::array* list = value.node.as_array();
  const std::string expected = fmt::format("{} in a {} analysis", form, two_dimensional_ ? "2D" : "3D");
  if (!list || list->size() < plan || list->size() > plan + 1) {
    const bool has_y = two_dimensional_ && list && list->size() == 3;
    refuse_kind(value, expected, has_y ? "Leave out y, or give terrain.width_m for 3D" : "");
    return std::nullopt;
  }
  if (list->size() == plan && !has_height) {
    refuse_kind(value, expected, "For a height above the terrain, leave out z and give height_above_m");
    return std::nullopt;
  }
  Position read;
  bool good = true;
  for (std::size_t i = 0; i < list->size(); ++i) {
    const toml::node& node = (*list)[i];
    const Value part{value.setting, node, value.row, value.where, fmt::format("{}[{}]", value.name, i)};
    if (i == plan && node.is_string()) {
      read.on_surface = node.value<std::string>() == "surface";
      if (!read.on_surface) good = refuse_kind(part, "a number or \"surface\"");
    } else {
      good = into(part, &read.point[two_dimensional_ && i == 1 ? 2 : i]) && good;
    }
  }
  if (good && has_height && list->size() > plan && !read.on_surface) {
    good = refuse(value, fmt::format("{} has z, and height_above_m is given", value.name), "both give the height",
                  "Leave one of them out");
  }
  return good ? std::optional(read) : std::nullopt;
}

bool ValueReader::into(const Value& value, PositionSlot slot) {
  const std::optional<Position> read = position(value);
  if (!read) return false;
  slot.seeder->at_points = {{read->point}, read->on_surface && !value.row.contains("height_above_m")};
  return true;
}

bool ValueReader::into(const Value& value, PointsSlot slot) {
  const toml::array* list = value.node.as_array();
  if (!list || list->size() < 2) return refuse_kind(value, "a list of two or more positions");
  std::vector<Position> positions;
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < list->size() && wrong < most_reported; ++i) {
    const Value entry{value.setting, (*list)[i], value.row, value.where, fmt::format("{}[{}]", value.name, i)};
    const std::optional<Position> read = position(entry);
    if (read) positions.push_back(*read);
    wrong += read ? 0 : 1;
  }
  if (wrong > 0) return false;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const Value entry{value.setting, (*list)[i], value.row, value.where, fmt::format("{}[{}]", value.name, i)};
    if (positions[i].on_surface != positions[0].on_surface && !value.row.contains("height_above_m")) {
      return refuse(entry, fmt::format("{} is {}", entry.name, quoted(entry.node)),
                    "z is either \"surface\" for all points of a line or a number for all");
    }
    if (i > 0 && positions[i].point == positions[i - 1].point) {
      return refuse(entry, fmt::format("{} is {}", entry.name, quoted(entry.node)), "it repeats the previous point",
                    "Leave it out");
    }
  }
  AtPoints& at = slot.seeder->at_points;
  at.points.clear();
  for (const Position& read : positions) at.points.push_back(read.point);
  at.z_is_surface = positions[0].on_surface && !value.row.contains("height_above_m");
  return true;
}

bool ValueReader::into(const Value& value, DirectionSlot slot) {
  if (value.node.value<std::string_view>() == "downslope") {
    slot.direction->reset();
    return true;
  }
  if (!dimension_is_known_) return false;
  const toml::array* list = value.node.as_array();
  const bool is_pair = two_dimensional_ && list && list->size() == 2;
  if (!list || (list->size() != 3 && !is_pair)) {
    return refuse_kind(value, two_dimensional_ ? "[x, z] in a 2D analysis, or \"downslope\""
                                               : "[x, y, z] in a 3D analysis, or \"downslope\"");
  }
  std::array<double, 3> read{};
  bool good = true;
  for (std::size_t i = 0; i < list->size(); ++i) {
    const Value part{value.setting, (*list)[i], value.row, value.where, fmt::format("{}[{}]", value.name, i)};
    good = into(part, &read[is_pair && i == 1 ? 2 : i]) && good;
  }
  if (!good) return false;
  constexpr double shortest = 1e-9;  // the square of a much shorter one underflows
  if (std::hypot(read[0], read[1], read[2]) < shortest) return refuse_kind(value, "a direction whose length is not 0");
  if (two_dimensional_ && read[1] != 0) return refuse_kind(value, "y to be 0 in a 2D analysis");
  if (read[2] != 0 && !value.row.contains("speed_m_s") && !value.row.contains("table")) {
    return refuse(value, fmt::format("{} is {}", value.name, quoted(value.node)),
                  "it is the direction of the horizontal velocity; expected z to be 0",
                  "For a velocity that points up or down, give speed_m_s");
  }
  *slot.direction = read;
  return true;
}

bool ValueReader::plan_coordinate(const Value& value, double* member) {
  if (!into(value, member)) return false;
  if (std::abs(*member) <= largest_coordinate_m) return true;
  return refuse(value, fmt::format("{} is {}", value.name, quoted(value.node)),
                fmt::format("coordinates lie within {:g} m", largest_coordinate_m));
}

std::optional<std::vector<std::array<double, 2>>> ValueReader::plan_points(const Value& value) {
  const toml::array& list = *value.node.as_array();
  std::vector<std::array<double, 2>> read(list.size());
  for (std::size_t i = 0; i < list.size(); ++i) {
    const Value entry{value.setting, list[i], value.row, value.where, fmt::format("{}[{}]", value.name, i)};
    const toml::array* pair = entry.node.as_array();
    if (!pair || pair->size() != 2) {
      refuse_kind(entry, "a point on plan, [x, y]");
      return std::nullopt;
    }
    bool good = true;
    for (std::size_t k = 0; k < 2; ++k) {
      const Value part{value.setting, (*pair)[k], value.row, value.where, fmt::format("{}[{}]", entry.name, k)};
      good = plan_coordinate(part, &read[i][k]) && good;
    }
    if (!good) return std::nullopt;
    if (i > 0 && read[i] == read[i - 1]) {
      refuse(entry, fmt::format("{} is {}", entry.name, quoted(entry.node)), "it repeats the previous point",
             "Leave it out");
      return std::nullopt;
    }
  }
  return read;
}

bool ValueReader::into(const Value& value, PlanPolygonSlot slot) {
  const toml::array* list = value.node.as_array();
  if (!list || list->size() < 3) return refuse_kind(value, "three or more points on plan, [[x, y], [x, y], [x, y]]");
  auto read = plan_points(value);
  if (!read) return false;
  if (read->size() > 3 && read->front() == read->back()) read->pop_back();
  std::vector<Vec2> ring;
  for (const auto& [x, y] : *read) ring.emplace_back(x, y);
  constexpr std::size_t most_vertices = 10000;  // larger polygons belong in a file
  if (ring.size() > most_vertices) {
    return refuse(value, fmt::format("{} has {} points", value.name, ring.size()),
                  fmt::format("expected at most {}", most_vertices), "Put it in a file and name the file in polygons");
  }
  if (const auto crossing = self_crossing(ring)) {
    return refuse(value, fmt::format("{} crosses or touches itself", value.name),
                  fmt::format("at or near ({:.10g}, {:.10g})", crossing->x(), crossing->y()),
                  "Give its corners in order, once around");
  }
  *slot.polygon = std::move(*read);
  return true;
}

bool ValueReader::into(const Value& value, PlanPointSlot slot) {
  if (!dimension_is_known_) return false;
  const toml::array* list = value.node.as_array();
  const std::size_t coordinates = two_dimensional_ ? 1 : 2;
  if (!list || list->size() != coordinates)
    return refuse_kind(value, two_dimensional_ ? "[x] in a 2D analysis" : "a point on plan, [x, y], in a 3D analysis");
  std::array<double, 2> read{};
  bool good = true;
  for (std::size_t k = 0; k < coordinates; ++k) {
    const Value part{value.setting, (*list)[k], value.row, value.where, fmt::format("{}[{}]", value.name, k)};
    good = plan_coordinate(part, &read[k]) && good;
  }
  if (good) *slot.point = read;
  return good;
}

bool ValueReader::into(const Value& value, PlanLineSlot slot) {
  if (!dimension_is_known_) return false;
  const toml::array* list = value.node.as_array();
  if (two_dimensional_ && !(list && !list->empty() && (*list)[0].is_array())) {
    if (list && list->size() != 1) return refuse_kind(value, "x in a 2D analysis");
    const toml::node& node = list ? (*list)[0] : value.node;
    double x = 0;
    if (!plan_coordinate(Value{value.setting, node, value.row, value.where, value.name}, &x)) return false;
    *slot.line = {{x, 0}};
    return true;
  }
  if (!list || list->size() < 2) return refuse_kind(value, "two or more points on plan, [[x, y], [x, y]]");
  auto read = plan_points(value);
  if (!read) return false;
  for (const auto& point : *read) {
    if (!two_dimensional_ || point[0] == read->front()[0]) continue;
    return refuse_kind(value, "x in a 2D analysis; these points differ in x");
  }
  *slot.line = two_dimensional_ ? std::vector<std::array<double, 2>>{{read->front()[0], 0}} : std::move(*read);
  return true;
}

}  // namespace talus::project
