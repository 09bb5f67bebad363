#pragma once
// The rules across several keys of a project file. Rules that need the terrain itself (is a seeder above it?) are in
// the room `model`.

#include <unordered_set>

#include "talus/core/problems.hpp"
#include "talus/project/document.hpp"
#include "talus/project/project.hpp"

namespace talus::project {

/// `refused` are the values that were reported and are therefore not in the project. `asks_a_line`: see Overrides.
void check(const Project& project, const Document& document, const std::unordered_set<const toml::node*>& refused,
           bool asks_a_line, Problems& problems);

}  // namespace talus::project
