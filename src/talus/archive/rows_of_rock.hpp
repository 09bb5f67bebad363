#pragma once
// Which rows a rock has in each table.

#include "talus/archive/result_tables.hpp"

namespace talus {

/// What most tables need: a row for what every log has.
struct RowsOfAnyRun {
  static bool are_wanted(const TableRocks&) { return true; }
  static bool need_path(const TableRocks&, std::uint64_t) { return false; }
  static bool need_impacts(const TableRocks&, std::uint64_t) { return false; }
};

/// The rows of one rock in a table: calls visit(record, ...) for each of them, with what `fill` makes the row of; and
/// says whether the rock's log must have its path or its impacts for that, and whether a run has the table at all.
template <class Row>
struct RowsOfRock;

template <>
struct RowsOfRock<EndpointRow> : RowsOfAnyRun {
  template <class Visit>
  static void visit(const TableRocks& rocks, const RockRecord& record, const RockLog&, Visit&& visit) {
    if (rocks.has_endpoint(record.rock)) visit(record);
  }
};

template <>
struct RowsOfRock<PathEventRow> : RowsOfAnyRun {
  static bool need_path(const TableRocks& rocks, std::uint64_t rock) { return rocks.has_path(rock); }
  template <class Visit>
  static void visit(const TableRocks& rocks, const RockRecord& record, const RockLog& log, Visit&& visit) {
    if (!rocks.has_path(record.rock)) return;
    for (std::size_t k = 0; k < log.rows.size(); ++k) visit(record, k, log.rows[k]);
  }
};

template <>
struct RowsOfRock<ImpactRow> : RowsOfAnyRun {
  static bool are_wanted(const TableRocks& rocks) { return rocks.impacts() > 0; }
  static bool need_impacts(const TableRocks& rocks, std::uint64_t rock) { return rocks.has_impacts(rock); }
  template <class Visit>
  static void visit(const TableRocks& rocks, const RockRecord& record, const RockLog& log, Visit&& visit) {
    if (!rocks.has_impacts(record.rock)) return;
    std::uint64_t number = 0;
    for (const Impact& impact : log.impacts) visit(record, ++number, impact);
  }
};

template <>
struct RowsOfRock<HitRow> : RowsOfAnyRun {
  template <class Visit>
  static void visit(const TableRocks&, const RockRecord& record, const RockLog& log, Visit&& visit) {
    for (const Passage& hit : log.hits) visit(record, hit);
  }
};

}  // namespace talus
