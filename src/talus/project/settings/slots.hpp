#pragma once
// Functions from a row of a table to the member that a setting fills.

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "talus/project/settings.hpp"

namespace talus::project::declared {

template <class Struct, class Member>
std::function<Slot(Row)> member(Member Struct::*pointer) {
  return [pointer](Row row) -> Slot { return &(std::get<Struct*>(row)->*pointer); };
}

template <class Struct>
std::function<Slot(Row)> plan_polygon_slot() {
  return [](Row row) -> Slot { return PlanPolygonSlot{&std::get<Struct*>(row)->polygon}; };
}

/// For a table with exactly one row: the functions `add` and `rows` of its declaration.
template <class Struct>
auto one_row(Struct Project::*table) {
  return std::pair{[table](Project& project) -> Row { return &(project.*table); },
                   [table](Project& project) { return std::vector<Row>{&(project.*table)}; }};
}

template <class Struct>
Row added(std::vector<Struct>& list) {
  return &list.emplace_back();
}

template <class Struct>
std::vector<Row> all(std::vector<Struct>& list) {
  std::vector<Row> rows;
  for (Struct& item : list) rows.push_back(&item);
  return rows;
}

}  // namespace talus::project::declared
