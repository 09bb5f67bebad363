#pragma once
// A server with a finished run.

#include "server/served_runs.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "support/run_columns.hpp"
#include "talus/archive/run_folder.hpp"
#include "talus/files/csv_reader.hpp"

namespace talus::testing_tools {

using Texts = std::vector<std::string>;

/// 75 rocks of two sources in 3D, with a fence and a collector, maps and a design (run_files.hpp).
class ServedResults : public ServedRuns {
 protected:
  ServedResults() {
    const test::Workplace work;
    text_ = text_of(test::write_slope_with_barrier(work));
    id_ = begin(text_);
    EXPECT_EQ(wait_for(id_, "done")["state"], "done");
    folder_ = folder_of(id_);
  }
  [[nodiscard]] Reply of(const std::string& what) const { return get("/api/runs/" + id_ + what); }
  [[nodiscard]] std::vector<Texts> rows_of(const char* name, std::span<const std::string_view> columns) const {
    std::vector<Texts> rows;
    CsvReader row(folder_ / name, columns);
    while (row.next()) {
      Texts& texts = rows.emplace_back();
      for (std::size_t k = 0; k < columns.size(); ++k) texts.emplace_back(row.text(k));
    }
    return rows;
  }
  [[nodiscard]] std::vector<Texts> endpoints() const { return rows_of("endpoints.csv", endpoint_columns); }
  [[nodiscard]] std::vector<Texts> hits() const { return rows_of("barriers.csv", barrier_columns); }

  std::string text_, id_;
  std::filesystem::path folder_;
};

}  // namespace talus::testing_tools
