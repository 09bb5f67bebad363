#pragma once
// Which of Talus' TOML files one is: a command that gets another says so, instead of listing every table as unknown.

#include "talus/project/document.hpp"

namespace talus::project {

enum class TomlKind { project, calibration, sensitivity };

/// Throws BadInput if the file's tables are those of another kind alone.
void expect_kind(const Document& document, TomlKind expected);

}  // namespace talus::project
