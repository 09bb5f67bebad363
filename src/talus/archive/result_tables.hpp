#pragma once
// Writes endpoints.csv, paths.csv and barriers.csv: turns rocks into rows of text. Where the text goes is decided by
// the sink (text_sink.hpp): into a file, or to the process that has the file.

#include <optional>
#include <string>
#include <vector>

#include "talus/archive/table_columns.hpp"
#include "talus/archive/table_rocks.hpp"
#include "talus/campaign/model.hpp"
#include "talus/files/text_sink.hpp"
#include "talus/results/record.hpp"

namespace talus {

/// The facts of the model that tables need; everything else is in the records.
struct TableContext {
  LocalFrame frame;
  double gravity = standard_gravity;           // [m/s2]
  double energy_datum = 0;                     // z in user coordinates [m]
  std::vector<std::string> seeders, barriers;  // their names

  [[nodiscard]] static TableContext of(const Model& model);
};

/// A table. Rows become text in the threads that compute the rocks; the text of a block goes to the sink when the block
/// is committed.
class TableObserver : public Observer {
 public:
  /// The sink must outlive it; it gets rows only, never the header.
  TableObserver(TableContext context, TextSink& sink) : context_(std::move(context)), sink_(sink) {}
  void commit(ObserverPart& part) override;

  /// The name of its file, and the first line of the file.
  [[nodiscard]] virtual std::string_view file_name() const = 0;
  [[nodiscard]] virtual std::string header() const = 0;

 protected:
  [[nodiscard]] const TableContext& context() const { return context_; }

 private:
  TableContext context_;
  TextSink& sink_;
};

/// One row for each rock that the table contains.
class EndpointsTable : public TableObserver {
 public:
  EndpointsTable(TableContext context, TextSink& sink, const TableRocks& rocks);
  [[nodiscard]] bool wants_rows(std::uint64_t) const override { return false; }
  [[nodiscard]] std::unique_ptr<ObserverPart> new_part() const override;
  [[nodiscard]] std::string_view file_name() const override { return EndpointRow::file_name; }
  [[nodiscard]] std::string header() const override { return header_of<EndpointRow>(); }

 private:
  TableRocks rocks_;
};

/// The rows of the paths that the table contains.
class PathsTable : public TableObserver {
 public:
  PathsTable(TableContext context, TextSink& sink, const TableRocks& rocks);
  [[nodiscard]] bool wants_rows(std::uint64_t rock) const override { return rocks_.has_path(rock); }
  [[nodiscard]] std::unique_ptr<ObserverPart> new_part() const override;
  [[nodiscard]] std::string_view file_name() const override { return PathEventRow::file_name; }
  [[nodiscard]] std::string header() const override { return header_of<PathEventRow>(); }

 private:
  TableRocks rocks_;
};

/// One row for each hit.
class BarriersTable : public TableObserver {
 public:
  using TableObserver::TableObserver;
  [[nodiscard]] bool wants_rows(std::uint64_t) const override { return false; }
  [[nodiscard]] std::unique_ptr<ObserverPart> new_part() const override;
  [[nodiscard]] std::string_view file_name() const override { return HitRow::file_name; }
  [[nodiscard]] std::string header() const override { return header_of<HitRow>(); }
};

// Fill a row, which can be reused, from a record.
void fill(EndpointRow& row, const TableContext& context, const RockRecord& record);
void fill(PathEventRow& row, const TableContext& context, const RockRecord& record, std::size_t event,
          const PathRow& seen);
void fill(HitRow& row, const TableContext& context, const RockRecord& record, const BarrierHit& hit);

}  // namespace talus
