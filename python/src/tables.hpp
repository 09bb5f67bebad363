#pragma once
// The tables of a run by their names in Python, in the order of ResultRows.

#include <array>
#include <string_view>
#include <tuple>

#include "talus/archive/table_columns.hpp"

namespace talus::python {

inline constexpr std::array<std::string_view, std::tuple_size_v<ResultRows>> table_names{"end_points", "barrier_hits",
                                                                                         "events", "impacts"};

/// Calls visit of the table of this name with a null pointer to its kind of row; false if there is none.
template <class Visit>
bool for_table(std::string_view name, Visit&& visit) {
  return [&]<std::size_t... k>(std::index_sequence<k...>) {
    const auto at = [&]<std::size_t place>(std::integral_constant<std::size_t, place>) {
      if (table_names[place] != name) return false;
      visit(static_cast<const std::tuple_element_t<place, ResultRows>*>(nullptr));
      return true;
    };
    return (at(std::integral_constant<std::size_t, k>()) || ...);
  }
  (std::make_index_sequence<table_names.size()>());
}

}  // namespace talus::python
