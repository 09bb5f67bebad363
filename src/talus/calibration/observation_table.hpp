#pragma once
// Tables of observations from text files that people and other programs write.

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "talus/core/problems.hpp"

namespace talus::calibration {

/// A column that is read: its name, with its unit, and other names for it.
struct ObservedColumn {
  std::string_view name;
  std::vector<std::string_view> others;

  /// Whether `text` is one of its names; `Mass [kg]` is mass_kg (plain_column_name).
  [[nodiscard]] bool is_named(std::string_view text) const;
};

/// Refuses columns of a quantity that is read, but in another unit or without one, and names that were mistyped
/// (mistyped_column.hpp); warns of names that may have been. Others are not read. `place`: of the names, for messages.
void check_column_names(const Problem& place, std::span<const std::string> columns,
                        const std::vector<ObservedColumn>& known, Problems& problems, Problems& warnings);

/// A text file with a line of column names. Values are separated by commas, semicolons or tabs, the same in the whole
/// file, and may be quoted; with semicolons and tabs, numbers may have decimal commas. Empty lines and comments (#) are
/// skipped.
class ObservationTable {
 public:
  /// Throws BadInput if the file cannot be read, has no rows, or has rows with another number of values than columns.
  explicit ObservationTable(const std::filesystem::path& file);

  [[nodiscard]] std::size_t rows() const { return rows_.size(); }
  [[nodiscard]] const std::vector<std::string>& columns() const { return columns_; }
  [[nodiscard]] std::optional<std::size_t> find(const ObservedColumn& column) const;
  /// As check_column_names.
  void check_columns(const std::vector<ObservedColumn>& known, Problems& problems, Problems& warnings) const;
  /// Whether a column is named for a longitude or latitude.
  [[nodiscard]] bool is_in_degrees() const;
  [[nodiscard]] const std::string& text(std::size_t row, std::size_t column) const { return rows_[row].values[column]; }
  /// The number of a value; nullopt, with a problem, if it is not a finite number.
  [[nodiscard]] std::optional<double> number(std::size_t row, std::size_t column, Problems& problems) const;
  /// A problem at a row.
  [[nodiscard]] Problem at(std::size_t row) const;
  [[nodiscard]] const std::string& file() const { return file_; }

 private:
  struct Row {
    int line;
    std::vector<std::string> values;
  };
  std::string file_;
  char separator_ = ',';
  std::vector<std::string> columns_;
  std::vector<Row> rows_;
};

}  // namespace talus::calibration
