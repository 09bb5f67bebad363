#pragma once
// The rows of one rock in a table of a run, found without reading all of it: tables are in the order of the rocks.

#include <cstdint>
#include <filesystem>
#include <vector>

#include "talus/files/csv_table.hpp"

namespace talus {

/// Goes to where a row begins that has no row of the rock before it, or to the first row. `column` is that of the rock.
void go_near_rock(CsvReader& row, const std::filesystem::path& file, std::size_t column, std::uint64_t rock);

/// Its rows in a table of a run's folder, in their order; none where the table has none. Throws BadInput where the file
/// is no such table.
template <TableRow Row>
[[nodiscard]] std::vector<Row> rows_of_rock(const std::filesystem::path& folder, std::uint64_t rock) {
  const std::filesystem::path file = folder / Row::file_name;
  TableReader<Row> row(file);
  go_near_rock(row.csv(), file, place_of(&Row::rock), rock);
  std::vector<Row> rows;
  while (row.next()) {
    const std::uint64_t current = row.template get<&Row::rock>();
    if (current > rock) break;
    if (current == rock) rows.push_back(row.whole());
  }
  return rows;
}

}  // namespace talus
