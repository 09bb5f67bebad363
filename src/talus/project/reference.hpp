#pragma once
// The page docs/project-file.md, generated from the declaration of the settings.

#include <string>

namespace talus::project {

[[nodiscard]] std::string reference_page();

}  // namespace talus::project
