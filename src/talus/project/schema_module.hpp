#pragma once
// The declaration of the settings for the workbench's page.

#include <string>

namespace talus::project {

/// web/src/generated/schema.ts: the schema of schema.hpp as a TypeScript constant, whose type has every key and every
/// word. A test checks that the file is up to date.
[[nodiscard]] std::string schema_module();

}  // namespace talus::project
