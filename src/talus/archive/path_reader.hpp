#pragma once
// Reads paths.csv one path after the other, in memory that holds one.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "talus/archive/run_folder.hpp"

namespace talus {

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
  TableReader<PathEventRow> row_;
  Path path_;
};

// What all readers of paths ask of a row: its values but for the spin; and what they refuse.
[[nodiscard]] PathEventRow path_row(const TableReader<PathEventRow>& row);
[[noreturn]] void refuse_other_rock(const TableReader<PathEventRow>& row, std::uint64_t rock, std::uint64_t unfinished);
[[noreturn]] void refuse_unfinished_path(const std::filesystem::path& file, std::uint64_t rock);

}  // namespace talus
