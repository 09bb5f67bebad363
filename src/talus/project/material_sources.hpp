#pragma once
// Where the values of a project's materials come from.

#include <string>
#include <vector>

#include "talus/project/project.hpp"

namespace talus::project {

/// Values of a material that equal those of its library entry, and the source of these.
struct SourceOfValues {
  std::string material, like;
  std::vector<std::string> keys;  // of [[material]]
  std::string source;
};

/// Of all materials with `like`; one entry for each of their sources. Values that the project changes are left out.
[[nodiscard]] std::vector<SourceOfValues> sources_of_values(const Project& project);

}  // namespace talus::project
