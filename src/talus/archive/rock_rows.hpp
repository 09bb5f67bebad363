#pragma once
// The rows of one rock in a table of a run, found by bisection: tables are in the order of the rocks.

#include <cstdint>
#include <filesystem>
#include <vector>

#include "talus/files/csv_table.hpp"

namespace talus {

/// Goes to a place before the first row of the rock and close to it. `column` is the column of the rock.
void go_near_rock(CsvReader& row, const std::filesystem::path& file, std::size_t column, std::uint64_t rock);

/// The rows of a rock in a table of a run's folder, in their order. Throws BadInput if the file is not such a table.
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
