#pragma once
// Reads the table of a seeder: text, or points of a vector file with attributes.

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "talus/campaign/model.hpp"
#include "talus/core/problems.hpp"
#include "talus/project/project.hpp"

namespace talus::project {

struct ReleaseTableContext {
  const Project& project;
  const Model& model;                                     // with its terrain
  std::function<SourceId(const std::string&)> source_of;  // the number of a source, by name
};

struct ReadReleases {
  ReleaseTable table;
  /// Of each row of the table the line or the number of the feature in the file, for messages.
  std::vector<std::int64_t> origins;
  const char* origin_kind = "line";  // or "feature"
  std::string columns;               // which were used, and which not, for the report
};

/// Reads the rows; those of one source follow each other, otherwise they are in the order of the file. The columns are
/// those of release_columns.hpp. Whether the places are on the terrain is not checked. Throws BadInput with all
/// problems of the columns, or with the first problems of the rows.
[[nodiscard]] ReadReleases read_release_table(const Seeder& seeder, const FromTable& table,
                                              const ReleaseTableContext& context, Problems& warnings);

}  // namespace talus::project
