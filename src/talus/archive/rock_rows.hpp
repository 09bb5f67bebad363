#pragma once
// The rows of one rock in a table of a run, found without reading all of it: tables are in the order of the rocks.

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace talus::io {

/// Its rows in one of the files of run_folder.hpp with these columns, one of which is `rock`: the texts of each, in the
/// order of the columns. None where the table has none. Throws BadInput where the file is no such table.
[[nodiscard]] std::vector<std::vector<std::string>> rows_of_rock(const std::filesystem::path& file,
                                                                 std::span<const std::string_view> columns,
                                                                 std::uint64_t rock);

}  // namespace talus::io
