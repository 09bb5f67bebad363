#pragma once
// Counts of findings with the places of the first few, and their words in reports.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "talus/core/vec.hpp"

namespace talus {

/// How many were found, and where the first few are.
struct Findings {
  static constexpr std::size_t most_examples = 3;

  std::size_t count = 0;
  std::vector<Vec3> examples;  // global coordinates [m]

  void add(const Vec3& where);
  /// ", for example at (1.000, 2.000, 3.000)"; empty if nothing was found.
  [[nodiscard]] std::string places() const;
};

/// "1 facet", "2 facets".
[[nodiscard]] std::string counted(std::size_t count, std::string_view one, std::string_view many);

}  // namespace talus
