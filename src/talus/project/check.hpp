#pragma once
// The rules across keys of a project file: what no single value can get wrong. Rules that need the terrain itself (is a
// seeder above it?) are with whoever builds it.

#include <unordered_set>

#include "talus/core/problems.hpp"
#include "talus/project/document.hpp"
#include "talus/project/project.hpp"

namespace talus::project {

/// `refused` are the values that are not in the project because they were reported already.
void check(const Project& project, const Document& document, const std::unordered_set<const toml::node*>& refused,
           Problems& problems);

}  // namespace talus::project
