#pragma once
// Values of attributes of vector files, as a project names them.

#include <string>

#include "talus/files/data_table.hpp"

namespace talus::project {

/// Whether a value of an attribute is the one that a project names. Numbers are compared as such: a file may write 2 as
/// 2.000.
[[nodiscard]] inline bool is_same_value(const std::string& of_file, const std::string& named, bool is_number) {
  if (of_file == named || !is_number) return of_file == named;
  const auto number = number_in_cell(of_file, false);
  return number && number_in_cell(named, false) == number;
}

}  // namespace talus::project
