#pragma once
// The tables of a run folder: endpoints.csv, paths.csv, barriers.csv. How a rock becomes text is told here; where the
// text goes is the sink's affair (text_sink.hpp): to a file, or to another process that has the file.

#include <optional>
#include <string>
#include <vector>

#include "talus/archive/table_columns.hpp"
#include "talus/archive/table_rocks.hpp"
#include "talus/campaign/model.hpp"
#include "talus/files/text_sink.hpp"
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

/// A table: what rocks say of themselves becomes text in the threads that compute them, and the text of a block goes
/// to the sink when the block is committed.
class TableObserver : public Observer {
 public:
  /// The sink must outlive it; it is given rows only, never the header.
  TableObserver(TableContext context, TextSink& sink) : context_(std::move(context)), sink_(sink) {}
  void commit(ObserverPart& part) override;

  /// The name of its file, and the first line there.
  [[nodiscard]] virtual std::string_view file_name() const = 0;
  [[nodiscard]] virtual std::string header() const = 0;

 protected:
  [[nodiscard]] const TableContext& context() const { return context_; }

 private:
  TableContext context_;
  TextSink& sink_;
};

/// One row a rock, of those that have one.
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

/// The rows of a path, of the rocks that have one there.
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

/// One row a hit.
class BarriersTable : public TableObserver {
 public:
  using TableObserver::TableObserver;
  [[nodiscard]] bool wants_rows(std::uint64_t) const override { return false; }
  [[nodiscard]] std::unique_ptr<ObserverPart> new_part() const override;
  [[nodiscard]] std::string_view file_name() const override { return HitRow::file_name; }
  [[nodiscard]] std::string header() const override { return header_of<HitRow>(); }
};

// What rocks say of themselves as rows, into one that is used again and again.
void fill(EndpointRow& row, const TableContext& context, const RockRecord& record);
void fill(PathEventRow& row, const TableContext& context, const RockRecord& record, std::size_t event,
          const PathRow& seen);
void fill(HitRow& row, const TableContext& context, const RockRecord& record, const BarrierHit& hit);

}  // namespace talus
