#include "talus/run/run_size.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <string_view>

#include "talus/archive/result_tables.hpp"
#include "talus/campaign/simulate.hpp"
#include "talus/maps/map_files.hpp"
#include "talus/maps/map_list.hpp"
#include "talus/run/run_results.hpp"

namespace talus::project {

namespace {

constexpr std::uint64_t most_simulated = 32;
constexpr std::uint64_t part_of_run = 64;  // the estimate simulates at most one rock in this many
constexpr double large_bytes = 1e9;
// Per value of a map's cell: bytes with compression and overviews (3.9 on rough ground, 2 to 3 on a smooth slope), and
// seconds of one thread.
constexpr double bytes_a_value = 3.5, seconds_a_value = 4e-7;
constexpr double infinity = std::numeric_limits<double>::infinity();

template <class Work>
double seconds_of(Work&& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

struct Counter : TextSink {
  void write(std::string_view text) override { bytes += static_cast<double>(text.size()); }
  double bytes = 0;
};

/// Measures the text of a table in which all rocks have rows.
class Sized {
 public:
  Sized(std::string_view file_name, const Model& model) {
    const auto table = std::ranges::find(result_tables(), file_name, &ResultTable::file_name);
    table_ = table->make(TableContext::of(model), TableRocks(model.rocks(), {.impacts = {}}), counter_);
    part_ = table_->new_part();
  }
  void see(const RockRecord& record, const RockLog& log) {
    seconds_ += seconds_of([&] { part_->see(record, log); });
  }
  double bytes() {
    table_->commit(*part_);
    return counter_.bytes;
  }
  [[nodiscard]] double seconds() const { return seconds_; }

 private:
  Counter counter_;
  std::unique_ptr<Observer> table_;
  std::unique_ptr<ObserverPart> part_;
  double seconds_ = 0;  // for making the text
};

/// Measures the maps of some rocks.
class SizedMaps {
 public:
  SizedMaps(const Project& project, const Model& model) {
    const bool is_section = std::holds_alternative<Profile>(*model.surface);
    if (!is_section && !can_write_maps()) return;
    maps_ = map_observer(project, model);
    if (!maps_) return;
    part_ = maps_->new_part();
    values_a_cell_ = static_cast<double>(map_kinds(map_selection(project, model)).size());
    if (maps_->is_split())
      values_a_cell_ *= 2;  // the maps of all sources have at least as many values as those of all rocks
    if (is_section) return;
    std::visit(
        [&](const auto& surface) {
          const Box bounds = surface.bounds();
          const Vec2 size = (bounds.high - bounds.low).xy(), cell = maps_->maps().grid().cell();
          most_cells_ = (std::ceil(size.x() / cell.x()) + 1) * (std::ceil(size.y() / cell.y()) + 1);
        },
        *model.surface);
  }
  [[nodiscard]] bool are_made() const { return maps_ != nullptr; }
  void see(const RockRecord& record, const RockLog& log) {
    if (maps_) part_->see(record, log);
  }
  const Maps& add() {
    maps_->commit(*part_);
    part_ = maps_->new_part();
    return maps_->maps();
  }
  /// The number of cells that `rocks` rocks touch, extrapolated from `few`.
  double cells(double few, double rocks) {
    if (!maps_) return 0;
    double touched = 0, by_one = 0, by_two = 0;
    for (const MapTile* tile : add().tiles()) {
      for (std::int32_t k = 0; k < Maps::tile_side * Maps::tile_side; ++k) {
        const auto tally = tile->find(k % Maps::tile_side, k / Maps::tile_side);
        if (!tally) continue;
        ++touched;
        by_one += tally->passages() == 1 ? 1 : 0;
        by_two += tally->passages() == 2 ? 1 : 0;
      }
    }
    return std::min(most_cells_, expected_touched(few, touched, by_one, by_two, rocks));
  }
  [[nodiscard]] double values_a_cell() const { return values_a_cell_; }

 private:
  std::unique_ptr<MapObserver> maps_;
  std::unique_ptr<ObserverPart> part_;
  double values_a_cell_ = 0, most_cells_ = infinity;
};

std::string time_text(double seconds) {
  constexpr double minute = 60, hour = 3600, day = 24 * hour;
  if (seconds < 2 * minute) return fmt::format("{:.0f} s", std::max(1.0, seconds));
  if (seconds < 2 * hour) return fmt::format("{:.0f} min", seconds / minute);
  if (seconds < 2 * day) return fmt::format("{:.0f} h", seconds / hour);
  return fmt::format("{:.0f} days", seconds / day);
}

}  // namespace

std::string size_text(double bytes) {
  if (bytes < 1e7) return fmt::format("{:.1f} MB", bytes / 1e6);
  return bytes < 1e9 ? fmt::format("{:.0f} MB", bytes / 1e6) : fmt::format("{:.1f} GB", bytes / 1e9);
}

double expected_touched(double few, double touched, double by_one, double by_two, double rocks) {
  if (by_one == 0 || rocks <= few) return touched;
  const double unseen = (few - 1) / few * by_one * (by_one - 1) / (2 * (by_two + 1));
  return touched + unseen * -std::expm1((rocks - few) * std::log1p(-by_one / (few * unseen + by_one)));
}

RunSize expected_size(const Project& project, const Model& model, const RockRange& rocks,
                      const std::atomic<bool>* stop) {
  const std::uint64_t simulated = std::min(most_simulated, rocks.count() / part_of_run);
  if (simulated == 0) return {};
  const auto is_stopped = [&] { return stop != nullptr && stop->load(std::memory_order_relaxed); };
  const TableRocks tables = table_rocks(project, model.rocks());
  Sized endpoints(EndpointRow::file_name, model), paths(PathEventRow::file_name, model);
  Sized barriers(HitRow::file_name, model), impacts(ImpactRow::file_name, model);
  SizedMaps maps(project, model);
  Simulator simulator(model);
  const auto rock = [&](std::uint64_t k) { return rocks.first + (rocks.count() / simulated) * k; };
  for (std::uint64_t k = 0; k < simulated && !is_stopped(); ++k) {
    const RockRecord record = simulator.simulate(rock(k), true, maps.are_made(), tables.impacts() > 0);
    maps.see(record, simulator.log());
    endpoints.see(record, simulator.log());
    paths.see(record, simulator.log());
    barriers.see(record, simulator.log());
    impacts.see(record, simulator.log());
  }
  const double cells = maps.cells(static_cast<double>(simulated), static_cast<double>(rocks.count()));
  // A second pass for the time, because the first rocks of a thread and new cells are slower.
  const double seconds = seconds_of([&] {
    for (std::uint64_t k = 0; k < simulated && !is_stopped(); ++k) {
      const RockRecord record = simulator.simulate(rock(k), false, maps.are_made());
      maps.see(record, simulator.log());
    }
    if (maps.are_made()) (void)maps.add();
  });

  const double each = 1 / static_cast<double>(simulated);
  const auto with_end = static_cast<double>(tables.endpoints_before(rocks.last) - tables.endpoints_before(rocks.first));
  const auto with_path = static_cast<double>(tables.paths_before(rocks.last) - tables.paths_before(rocks.first));
  const auto with_impacts = static_cast<double>(tables.impacts_before(rocks.last) - tables.impacts_before(rocks.first));
  const auto count = static_cast<double>(rocks.count());
  return {.endpoints_bytes = endpoints.bytes() * each * with_end,
          .barriers_bytes = barriers.bytes() * each * count,
          .paths_bytes = paths.bytes() * each * with_path,
          .impacts_bytes = impacts.bytes() * each * with_impacts,
          .maps_bytes = cells * maps.values_a_cell() * bytes_a_value,
          .processor_seconds = each * ((seconds + barriers.seconds()) * count + endpoints.seconds() * with_end +
                                       paths.seconds() * with_path + impacts.seconds() * with_impacts) +
                               cells * maps.values_a_cell() * seconds_a_value};
}

std::optional<std::string> large_run_text(const RunSize& size, int threads) {
  if (size.bytes() <= large_bytes) return std::nullopt;
  struct Part {
    double bytes;
    const char* name;
    std::string smaller;
  };
  std::string parts, smaller;
  for (const auto& [bytes, name, setting] :
       {Part{size.paths_bytes, "paths.csv", fmt::format("output.paths = {}", *Output{}.path_limit)},
        Part{size.endpoints_bytes, "endpoints.csv", "output.endpoints = \"none\""},
        Part{size.impacts_bytes, "impacts.csv", "output.impacts = 100"}, Part{size.barriers_bytes, "barriers.csv", ""},
        Part{size.maps_bytes, "maps", "fewer output.maps"}}) {
    constexpr double worth_naming = 0.05;
    if (bytes < worth_naming * size.bytes()) continue;
    parts += fmt::format("{}{} {}", parts.empty() ? "" : ", ", name, size_text(bytes));
    if (!setting.empty()) smaller += fmt::format("{}{}", smaller.empty() ? "; less with " : " or ", setting);
  }
  return fmt::format("The results will take about {} ({}), the run about {} on {} {} if the disk keeps up{}",
                     size_text(size.bytes()), parts, time_text(size.processor_seconds / threads), threads,
                     threads == 1 ? "thread" : "threads", smaller);
}

}  // namespace talus::project
