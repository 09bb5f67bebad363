#pragma once
// Reads paths.csv one path after the other, in memory that holds one.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "talus/archive/run_folder.hpp"
#include "talus/files/csv_reader.hpp"

namespace talus::io {

class PathReader {
 public:
  /// Throws BadInput where the file is none or has other columns.
  explicit PathReader(const std::filesystem::path& file);

  /// Goes to the next path of a rock that is wanted, in the order of the file; false after the last. Throws BadInput on
  /// rows that are not paths.
  [[nodiscard]] bool next(const std::function<bool(std::uint64_t rock)>& wants);
  [[nodiscard]] const Path& path() const { return path_; }

 private:
  std::filesystem::path file_;
  CsvReader row_;
  Path path_;
};

/// The path that rows of such a file make (rock_rows.hpp); expects at least one. Throws BadInput where they are no
/// path.
[[nodiscard]] Path path_of(const std::vector<std::vector<std::string>>& rows);

/// The state in a column of the current row; throws BadInput where it is none.
[[nodiscard]] PathState state_in(const CsvReader& row, std::size_t column);

}  // namespace talus::io
