#pragma once
// Reads all rows of a table of a file.

#include <functional>
#include <string_view>

#include "talus/core/problems.hpp"
#include "talus/project/document.hpp"
#include "talus/project/settings.hpp"
#include "talus/project/values.hpp"

namespace talus::project {

/// `add(line)` returns the row to read into, a new one for each [[key]]; it is not called for a table that the file
/// does not have. `file_kind`, for messages: "a project".
void read_table(const Table& table, const Document& document, ValueReader& reader, const std::function<Row(int)>& add,
                std::string_view file_kind, Problems& problems);

}  // namespace talus::project
