#pragma once
// The tables of a run folder: endpoints.csv, paths.csv, barriers.csv. Text is made by the threads that compute the
// rocks and only appended by the one that commits.

#include <optional>
#include <string>
#include <vector>

#include "talus/campaign/model.hpp"
#include "talus/io/csv_text.hpp"
#include "talus/io/output_file.hpp"
#include "talus/results/record.hpp"

namespace talus {

/// What the tables need to know of the model: everything else is in the records.
struct TableContext {
  LocalFrame frame;
  double gravity = standard_gravity;           // [m/s2]
  double energy_datum = 0;                     // the user's z [m]
  std::vector<std::string> seeders, barriers;  // their names

  [[nodiscard]] static TableContext of(const Model& model);
};

/// One row a rock.
class EndpointsTable : public Observer {
 public:
  EndpointsTable(const std::filesystem::path& file, TableContext context);
  [[nodiscard]] bool wants_rows(std::uint64_t) const override { return false; }
  [[nodiscard]] std::unique_ptr<ObserverPart> new_part() const override;
  void commit(ObserverPart& part) override;
  void finish() { file_.commit(); }

 private:
  OutputFile file_;
  TableContext context_;
};

/// The rows of a path: of all rocks, or of `limit` of them, evenly spread over their numbers.
class PathsTable : public Observer {
 public:
  PathsTable(const std::filesystem::path& file, TableContext context, std::uint64_t rocks,
             std::optional<std::uint64_t> limit);
  [[nodiscard]] bool wants_rows(std::uint64_t rock) const override;
  [[nodiscard]] std::unique_ptr<ObserverPart> new_part() const override;
  void commit(ObserverPart& part) override;
  void finish() { file_.commit(); }

 private:
  OutputFile file_;
  TableContext context_;
  std::uint64_t rocks_, limit_;
};

/// One row a hit.
class BarriersTable : public Observer {
 public:
  BarriersTable(const std::filesystem::path& file, TableContext context);
  [[nodiscard]] bool wants_rows(std::uint64_t) const override { return false; }
  [[nodiscard]] std::unique_ptr<ObserverPart> new_part() const override;
  void commit(ObserverPart& part) override;
  void finish() { file_.commit(); }

 private:
  OutputFile file_;
  TableContext context_;
};

/// A path's row as the table has it, for those who show a path elsewhere; `memory` (may be null) of the rows before.
void append_path_row(std::string& text, const TableContext& context, const RockRecord& record, std::size_t event,
                     const PathRow& row, CsvMemory* memory = nullptr);
[[nodiscard]] std::string_view path_header();

}  // namespace talus
