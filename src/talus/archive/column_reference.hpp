#pragma once
// The columns of a run's tables as text: for the documentation, and for the page.

#include <span>
#include <string>

#include "talus/files/csv_table.hpp"

namespace talus {

/// A Markdown table with a row for each column.
[[nodiscard]] std::string column_table(std::span<const ColumnText> columns);

/// A TypeScript module with the columns of the tables that the page shows.
[[nodiscard]] std::string columns_module();

}  // namespace talus
