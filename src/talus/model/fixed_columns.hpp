#pragma once
// What a sample of parameters was found with: the laws and fixed values of its study, as columns that a project must
// agree with. Their names are `fixed:PATH`, or `fixed:PATH@SITE` for each site if the sites of the study differ.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "talus/files/data_table.hpp"
#include "talus/project/project.hpp"

namespace talus::project {

/// A setting by its path, and its value as text.
struct FixedSetting {
  std::string path, value;
};

/// The laws of a project, and what else of its materials and forests differs from `as_written`, but for the settings in
/// `varied`. Limits of the computation are no laws.
[[nodiscard]] std::vector<FixedSetting> fixed_settings(const Project& project, const Project* as_written,
                                                       std::span<const std::string> varied);

/// The name of the column of a setting; `sites`: those that have the value, none if all do.
[[nodiscard]] std::string fixed_column(std::string_view path, std::span<const std::string> sites);
[[nodiscard]] bool is_fixed_column(std::string_view name);

/// Compares the fixed columns of a table with a project, row by row.
class FixedColumns {
 public:
  /// `site`: that of the table's sites which the project is; empty: not known.
  FixedColumns(const DataTable& table, const Project& project, std::string site);
  /// Refuses a row in which the settings are not those of the project, or not those of the rows before.
  void check(DataTable& table);

 private:
  struct Column {
    std::size_t number;
    std::string path, first;  // the value of the first row
    std::vector<std::string> sites;
    bool is_there = false;  // in the project
    std::string own;        // the project's value
  };
  [[nodiscard]] bool agrees(const DataTable& table, const Column& column) const;
  void refuse(DataTable& table, const Column& column) const;

  const Project& project_;
  std::string site_;
  std::vector<Column> columns_;
  bool is_first_ = true;
};

}  // namespace talus::project
