#pragma once
// Writes endpoints.csv, paths.csv, impacts.csv and barriers.csv: turns rocks into rows of text. Where the text goes is
// decided by the sink (text_sink.hpp): into a file, or to the process that has the file.

#include <memory>
#include <span>
#include <string>
#include <string_view>
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
  double gravity = standard_gravity;                      // [m/s2]
  double energy_datum = 0;                                // z in user coordinates [m]
  std::vector<std::string> seeders, barriers, materials;  // their names
  RunoutFrame runout_frame;                               // local
  std::uint64_t ensembles = 0;                            // 0: all rocks have the same parameters
  bool has_blocks = false;                                // some rocks have shapes
  const TerrainParts* parts = nullptr;                    // of impacts; null: the numbers of source()

  /// The model must outlive the context.
  [[nodiscard]] static TableContext of(const Model& model);
};

/// A table of a run. Rows become text in the threads that simulate the rocks; the text of a block goes to the sink when
/// the block is committed.
struct ResultTable {
  std::string_view file_name;
  std::string (*header)(const TableContext& context);  // the first line of the file
  /// Whether a run with these rocks in its tables has the file.
  bool (*is_wanted)(const TableRocks& rocks);
  /// The sink must outlive the observer. It is given rows only, never the header.
  std::unique_ptr<Observer> (*make)(const TableContext& context, const TableRocks& rocks, TextSink& sink);
};

/// One for each of ResultRows, in that order.
[[nodiscard]] std::span<const ResultTable> result_tables();
/// Those that a run has, in that order.
[[nodiscard]] std::vector<const ResultTable*> tables_with(const TableRocks& rocks);

// Fill a row, which can be reused, from a record.
void fill(EndpointRow& row, const TableContext& context, const RockRecord& record);
void fill(PathEventRow& row, const TableContext& context, const RockRecord& record, std::size_t event,
          const PathRow& seen);
/// `number` from 1.
void fill(ImpactRow& row, const TableContext& context, const RockRecord& record, std::uint64_t number,
          const Impact& impact);
void fill(HitRow& row, const TableContext& context, const RockRecord& record, const Passage& hit);

}  // namespace talus
