#pragma once
// Functions from a row of a table to the member that a setting fills.

#include <functional>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "talus/project/settings.hpp"

namespace talus::project::declared {

/// The slot of a member of the row's struct; with `Struct`, which is derived from `Owner`, of what it inherits.
template <class Struct = void, class Owner, class Member>
std::function<Slot(Row)> member(Member Owner::*pointer) {
  using RowStruct = std::conditional_t<std::is_void_v<Struct>, Owner, Struct>;
  return [pointer](const Row& row) -> Slot { return &(row.as<RowStruct>().*pointer); };
}

/// The slot of a member of a part of the row's struct.
template <class Owner, class Part, class Member>
std::function<Slot(Row)> member(Part Owner::*part, Member Part::*pointer) {
  return [part, pointer](const Row& row) -> Slot { return &(row.as<Owner>().*part.*pointer); };
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
