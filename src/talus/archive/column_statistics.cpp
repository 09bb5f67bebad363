#include "talus/archive/column_statistics.hpp"

#include <algorithm>
#include <array>
#include <iterator>

#include "talus/archive/foot_stretch.hpp"
#include "talus/archive/run_folder.hpp"
#include "talus/archive/table_columns.hpp"
#include "talus/core/check.hpp"
#include "talus/core/vec.hpp"

namespace talus {

namespace {

constexpr std::string_view velocity_column = "velocity_m_s", station_column = "station_m";

/// The zero-based place of a column in a table.
template <TableRow Row>
std::size_t place_of_column(std::string_view name) {
  const auto found = std::ranges::find(column_names<Row>, name);
  TALUS_PROMISE(found != column_names<Row>.end(), "the table must have the column");
  return static_cast<std::size_t>(found - column_names<Row>.begin());
}

/// The quantities of a table.
template <TableRow Row>
std::vector<NumberColumn> quantities_of() {
  std::vector<NumberColumn> quantities;
  for_columns<Row>([&](const auto& column) {
    if (column.kind == ColumnKind::quantity) quantities.push_back({column.name, column.unit});
  });
  return quantities;
}

void insert_after(std::string_view name, NumberColumn column, std::vector<NumberColumn>& columns) {
  columns.insert(std::next(std::ranges::find(columns, name, &NumberColumn::name)), column);
}

/// The origin for quantiles of a column: the local origin for positions, otherwise 0.
double origin_of(const RunFacts& facts, std::string_view column) {
  constexpr std::array<std::string_view, 3> positions{"x_m", "y_m", "z_m"};
  const auto found = std::ranges::find(positions, column);
  return found == positions.end() ? 0 : facts.summary.origin_m[static_cast<std::size_t>(found - positions.begin())];
}

bool is_one_of(const std::vector<std::string>& names, std::string_view name) {
  return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
}

/// Whether rocks hit one of the barriers; expects rocks in ascending order.
class RocksThatHit {
 public:
  RocksThatHit(const std::filesystem::path& folder, const std::vector<std::string>& barriers) : barriers_(barriers) {
    if (barriers.empty()) return;
    row_.emplace(folder / HitRow::file_name);
    has_row_ = row_->next();
  }
  [[nodiscard]] bool contain(std::uint64_t rock) {
    if (!row_) return true;
    bool hit = false;
    for (; has_row_ && row_->get<&HitRow::rock>() <= rock; has_row_ = row_->next())
      hit = hit || (row_->get<&HitRow::rock>() == rock && is_one_of(barriers_, row_->get<&HitRow::barrier>()));
    return hit;
  }

 private:
  const std::vector<std::string>& barriers_;
  std::optional<TableReader<HitRow>> row_;
  bool has_row_ = false;
};

/// Calls visit(row) for each row of endpoints.csv whose rock passes the filter.
template <class Visit>
void for_rocks(const std::filesystem::path& folder, const RunFacts& facts, const RockFilter& filter, Visit&& visit) {
  using R = EndpointRow;
  TableReader<R> row(folder / R::file_name);
  RocksThatHit hitting(folder, filter.barriers);
  const bool asks_for_energy = filter.least_energy_J || filter.most_energy_J;
  while (row.next()) {
    const std::uint64_t rock = row.get<&R::rock>();
    if (!hitting.contain(rock) || (filter.passes && !filter.passes(rock)) ||
        !is_one_of(filter.end_reasons, name(row.get<&R::end_reason>())) ||
        !is_one_of(filter.seeders, row.get<&R::seeder>()) ||
        (!filter.sources.empty() && !is_one_of(filter.sources, facts.source_of(rock))))
      continue;
    if (asks_for_energy) {
      const double energy = row.get<&R::max_ke_J>();
      if (energy < filter.least_energy_J.value_or(energy) || energy > filter.most_energy_J.value_or(energy)) continue;
    }
    visit(row);
  }
}

/// The value of a hit: a column of its row, or a quantity that follows from several.
class NumberOfHit {
 public:
  NumberOfHit(const BarrierFacts& barrier, std::string_view column) : barrier_(barrier), column_(column) {
    if (column != velocity_column && column != station_column) place_ = place_of_column<HitRow>(column);
  }
  [[nodiscard]] double operator()(const TableReader<HitRow>& row) const {
    if (column_ == velocity_column) return vector(row.get<&HitRow::velocity_m_s>()).norm();
    if (column_ == station_column) {
      const auto place = row.get<&HitRow::position_m>();
      return station_of(barrier_.line_xyz, barrier_.stations, place[0], place[1]);
    }
    return row.csv().number(place_);
  }

 private:
  const BarrierFacts& barrier_;
  std::string_view column_;
  std::size_t place_ = 0;
};

}  // namespace

bool RockFilter::is_empty() const {
  return end_reasons.empty() && seeders.empty() && sources.empty() && barriers.empty() && !least_energy_J &&
         !most_energy_J && !passes;
}

const std::vector<NumberColumn>& endpoint_numbers() {
  static const std::vector<NumberColumn> numbers = quantities_of<EndpointRow>();
  return numbers;
}

const std::vector<NumberColumn>& barrier_numbers() {
  static const std::vector<NumberColumn> numbers = [] {
    auto columns = quantities_of<HitRow>();
    insert_after("z_m", {station_column, "m"}, columns);
    insert_after("vz_m_s", {velocity_column, "m/s"}, columns);
    return columns;
  }();
  return numbers;
}

Tally endpoint_statistics(const std::filesystem::path& folder, const RunFacts& facts, std::string_view column,
                          const RockFilter& filter) {
  const std::size_t at = place_of_column<EndpointRow>(column);
  Tally tally(facts.planned_rocks(), origin_of(facts, column));
  for_rocks(folder, facts, filter, [&](const TableReader<EndpointRow>& row) {
    if (row.csv().has_value(at)) tally.add(row.csv().number(at));
  });
  return tally;
}

Tally barrier_statistics(const std::filesystem::path& folder, const RunFacts& facts, std::string_view barrier,
                         std::string_view column, const RockFilter& filter) {
  Tally tally(facts.planned_rocks(), origin_of(facts, column));
  TableReader<HitRow> row(folder / HitRow::file_name);
  const auto known = std::ranges::find(facts.barriers, barrier, &BarrierFacts::name);
  TALUS_PROMISE(known != facts.barriers.end(), "the run must have the barrier");
  const NumberOfHit number(*known, column);
  const auto add = [&] {
    if (row.get<&HitRow::barrier>() == barrier) tally.add(number(row));
  };
  if (filter.is_empty()) {
    while (row.next()) add();
    return tally;
  }
  bool has_row = row.next();
  for_rocks(folder, facts, filter, [&](const TableReader<EndpointRow>& endpoint) {
    const std::uint64_t rock = endpoint.get<&EndpointRow::rock>();
    for (; has_row && row.get<&HitRow::rock>() <= rock; has_row = row.next())
      if (row.get<&HitRow::rock>() == rock) add();
  });
  return tally;
}

std::vector<CumulativePoint> cumulative(const Tally& tally, std::size_t most_points) {
  const auto ascending = tally.sketch().ascending();
  std::vector<CumulativePoint> points;
  std::uint64_t below = 0;
  double next = 0;  // the number of values at which the next point is due
  const auto all = static_cast<double>(tally.count());
  for (std::size_t k = 0; k < ascending.size(); ++k) {
    below += ascending[k].count;
    const auto so_far = static_cast<double>(below);
    const bool is_end = k == 0 || k + 1 == ascending.size();
    if (!is_end && so_far < next) continue;
    points.push_back({ascending[k].value, so_far / all});
    next = so_far + all / static_cast<double>(most_points - 1);
  }
  return points;
}

}  // namespace talus
