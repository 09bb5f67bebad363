#pragma once
// Projects as text.

#include <string>

#include "talus/project/read.hpp"

namespace talus::what_if {

inline project::Project read(const std::string& text) { return project::read_project_text(text, "slope.toml").project; }

}  // namespace talus::what_if
