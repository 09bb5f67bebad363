#pragma once
// Names of columns that were probably mistyped: a column that is not read because of a wrong letter may change the
// meaning of all that follows, so readers of tables refuse it instead of leaving it out.

#include <optional>
#include <span>
#include <string_view>

namespace talus {

/// The known name from which one or two wrong letters separate a column's name, both in the form of plain_column_name.
/// Short names are too often similar by chance (`block`, `rock`), and names with other words or numbers mean something
/// else (`diameter_2_m`, `diameter_m`): of those none is found. `known`: the names of columns that the table lacks.
[[nodiscard]] std::optional<std::string_view> mistyped_column(std::string_view name,
                                                              std::span<const std::string_view> known);

}  // namespace talus
