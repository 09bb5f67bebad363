#pragma once
// Reads paths.csv path by path, with one path in memory.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "talus/archive/run_folder.hpp"

namespace talus {

class PathReader {
 public:
  /// Throws BadInput if there is no file, or if it has other columns.
  explicit PathReader(const std::filesystem::path& file);

  /// Goes to the next path of a selected rock, in the order of the file; false after the last. Throws BadInput on rows
  /// that are not a path.
  [[nodiscard]] bool next(const std::function<bool(std::uint64_t rock)>& wants);
  [[nodiscard]] const Path& path() const { return path_; }

 private:
  std::filesystem::path file_;
  TableReader<PathEventRow> row_;
  Path path_;
};

// Shared by the readers of paths: the values of a row without its spin; and the problems that they report.
[[nodiscard]] PathEventRow path_row(const TableReader<PathEventRow>& row);
[[noreturn]] void refuse_other_rock(const TableReader<PathEventRow>& row, std::uint64_t rock, std::uint64_t unfinished);
[[noreturn]] void refuse_unfinished_path(const std::filesystem::path& file, std::uint64_t rock);

}  // namespace talus
