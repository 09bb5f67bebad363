#pragma once
// The declarations of the settings and of the file formats for the workbench's page and for reports.

#include <string>

namespace talus::project {

/// web/src/generated/schema.ts: the schema of schema.hpp as a TypeScript constant, whose type has every key and every
/// word; and the list of file_formats.hpp. A test checks that the file is up to date.
[[nodiscard]] std::string schema_module();

/// web/src/generated/reportSettings.ts: the conditions and the defaults of that schema, without its texts, for reports. A
/// test checks that the file is up to date.
[[nodiscard]] std::string report_settings();

}  // namespace talus::project
