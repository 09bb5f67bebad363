#include "talus/archive/column_statistics.hpp"

#include <algorithm>
#include <array>

#include "talus/archive/foot_stretch.hpp"
#include "talus/archive/run_folder.hpp"
#include "talus/archive/table_columns.hpp"
#include "talus/core/check.hpp"
#include "talus/core/vec.hpp"
#include "talus/files/csv_reader.hpp"

namespace talus::io {

namespace {

constexpr std::size_t of_endpoints(std::string_view name) { return place_of(endpoint_columns, name); }
constexpr std::size_t of_hits(std::string_view name) { return place_of(barrier_columns, name); }

constexpr std::string_view velocity = "velocity_m_s", station = "station_m";

template <std::size_t n>
std::size_t column_of(const std::array<std::string_view, n>& columns, std::string_view name) {
  const auto found = std::find(columns.begin(), columns.end(), name);
  TALUS_PROMISE(found != columns.end(), "the table has the column");
  return static_cast<std::size_t>(found - columns.begin());
}

/// What numbers of a column are counted next to: the origin, if they are positions.
double origin_of(const RunFacts& facts, std::string_view column) {
  constexpr std::array<std::string_view, 3> positions{"x_m", "y_m", "z_m"};
  const auto found = std::ranges::find(positions, column);
  return found == positions.end() ? 0 : facts.summary.origin_m[static_cast<std::size_t>(found - positions.begin())];
}

bool is_one_of(const std::vector<std::string>& names, std::string_view name) {
  return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
}

std::uint64_t rock_in(const CsvReader& row, std::size_t column) {
  return static_cast<std::uint64_t>(row.whole_number(column));
}

/// Which rocks hit one of some barriers; asked in the order of the rocks.
class RocksThatHit {
 public:
  RocksThatHit(const std::filesystem::path& folder, const std::vector<std::string>& barriers) : barriers_(barriers) {
    if (barriers.empty()) return;
    row_.emplace(folder / "barriers.csv", barrier_columns);
    has_row_ = row_->next();
  }
  [[nodiscard]] bool contain(std::uint64_t rock) {
    if (!row_) return true;
    bool hit = false;
    for (; has_row_ && rock_in(*row_, of_hits("rock")) <= rock; has_row_ = row_->next())
      hit = hit || (rock_in(*row_, of_hits("rock")) == rock && is_one_of(barriers_, row_->text(of_hits("barrier"))));
    return hit;
  }

 private:
  const std::vector<std::string>& barriers_;
  std::optional<CsvReader> row_;
  bool has_row_ = false;
};

/// Calls visit(row) for each row of endpoints.csv whose rock passes.
template <class Visit>
void for_rocks(const std::filesystem::path& folder, const RunFacts& facts, const RockFilter& filter, Visit&& visit) {
  CsvReader row(folder / "endpoints.csv", endpoint_columns);
  RocksThatHit hitting(folder, filter.barriers);
  const bool asks_for_energy = filter.least_energy_J || filter.most_energy_J;
  while (row.next()) {
    const std::uint64_t rock = rock_in(row, of_endpoints("rock"));
    if (!hitting.contain(rock) || !is_one_of(filter.end_reasons, row.text(of_endpoints("end_reason"))) ||
        !is_one_of(filter.seeders, row.text(of_endpoints("seeder"))) ||
        (!filter.sources.empty() && !is_one_of(filter.sources, facts.source_of(rock))))
      continue;
    if (asks_for_energy) {
      const double energy = row.number(of_endpoints("max_ke_J"));
      if (energy < filter.least_energy_J.value_or(energy) || energy > filter.most_energy_J.value_or(energy)) continue;
    }
    visit(row);
  }
}

double number_of_hit(const CsvReader& row, const BarrierFacts& barrier, std::string_view column) {
  constexpr std::size_t x = of_hits("x_m"), vx = of_hits("vx_m_s");
  if (column == velocity) return Vec3(row.number(vx), row.number(vx + 1), row.number(vx + 2)).norm();
  if (column == station) return station_of(barrier.line_xyz, barrier.stations, row.number(x), row.number(x + 1));
  return row.number(column_of(barrier_columns, column));
}

}  // namespace

bool RockFilter::is_empty() const {
  return end_reasons.empty() && seeders.empty() && sources.empty() && barriers.empty() && !least_energy_J &&
         !most_energy_J;
}

const std::vector<NumberColumn>& endpoint_numbers() {
  static const std::vector<NumberColumn> numbers{{"x_m", "m"},         {"y_m", "m"},        {"z_m", "m"},
                                                 {"runout_xy_m", "m"}, {"runout_z_m", "m"}, {"runout_total_m", "m"},
                                                 {"time_s", "s"},      {"events", ""},      {"mass_kg", "kg"},
                                                 {"radius_m", "m"},    {"max_ke_J", "J"},   {"max_bounce_m", "m"}};
  return numbers;
}

const std::vector<NumberColumn>& barrier_numbers() {
  static const std::vector<NumberColumn> numbers{{"time_s", "s"},
                                                 {"x_m", "m"},
                                                 {"y_m", "m"},
                                                 {"z_m", "m"},
                                                 {station, "m"},
                                                 {"impact_height_m", "m"},
                                                 {"vx_m_s", "m/s"},
                                                 {"vy_m_s", "m/s"},
                                                 {"vz_m_s", "m/s"},
                                                 {velocity, "m/s"},
                                                 {"angle_deg", "°"},
                                                 {"ke_translational_J", "J"},
                                                 {"ke_rotational_J", "J"},
                                                 {"ke_total_J", "J"}};
  return numbers;
}

Tally endpoint_statistics(const std::filesystem::path& folder, const RunFacts& facts, std::string_view column,
                          const RockFilter& filter) {
  const std::size_t at = column_of(endpoint_columns, column);
  Tally tally(facts.planned_rocks(), origin_of(facts, column));
  for_rocks(folder, facts, filter, [&](const CsvReader& row) { tally.add(row.number(at)); });
  return tally;
}

Tally barrier_statistics(const std::filesystem::path& folder, const RunFacts& facts, std::string_view barrier,
                         std::string_view column, const RockFilter& filter) {
  Tally tally(facts.planned_rocks(), origin_of(facts, column));
  CsvReader row(folder / "barriers.csv", barrier_columns);
  const auto known = std::ranges::find(facts.barriers, barrier, &BarrierFacts::name);
  TALUS_PROMISE(known != facts.barriers.end(), "the run has the barrier");
  const auto add = [&] {
    if (row.text(of_hits("barrier")) == barrier) tally.add(number_of_hit(row, *known, column));
  };
  if (filter.is_empty()) {
    while (row.next()) add();
    return tally;
  }
  bool has_row = row.next();
  for_rocks(folder, facts, filter, [&](const CsvReader& endpoint) {
    const std::uint64_t rock = rock_in(endpoint, of_endpoints("rock"));
    for (; has_row && rock_in(row, of_hits("rock")) <= rock; has_row = row.next())
      if (rock_in(row, of_hits("rock")) == rock) add();
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

}  // namespace talus::io
