#include "talus/project/run_size.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "talus/campaign/simulate.hpp"
#include "talus/io/result_tables.hpp"

namespace talus::project {

namespace {

constexpr std::uint64_t most_simulated = 32;
constexpr std::uint64_t part_of_run = 64;  // that the estimate may simulate: one rock in so many
constexpr double large_bytes = 1e9;

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

/// The text of a table of some rocks, all of which are in it.
template <class Table>
class Sized {
 public:
  template <class... Rocks>
  explicit Sized(const Model& model, const Rocks&... rocks)
      : table_(TableContext::of(model), counter_, rocks...), part_(table_.new_part()) {}
  void see(const RockRecord& record, const RockLog& log) {
    seconds_ += seconds_of([&] { part_->see(record, log); });
  }
  double bytes() {
    table_.commit(*part_);
    return counter_.bytes;
  }
  [[nodiscard]] double seconds() const { return seconds_; }

 private:
  Counter counter_;
  Table table_;
  std::unique_ptr<ObserverPart> part_;
  double seconds_ = 0;  // that making the text took
};

std::string size_text(double bytes) {
  return bytes < 1e9 ? fmt::format("{:.0f} MB", bytes / 1e6) : fmt::format("{:.1f} GB", bytes / 1e9);
}

std::string time_text(double seconds) {
  constexpr double minute = 60, hour = 3600, day = 24 * hour;
  if (seconds < 2 * minute) return fmt::format("{:.0f} s", std::max(1.0, seconds));
  if (seconds < 2 * hour) return fmt::format("{:.0f} min", seconds / minute);
  if (seconds < 2 * day) return fmt::format("{:.0f} h", seconds / hour);
  return fmt::format("{:.0f} days", seconds / day);
}

}  // namespace

RunSize expected_size(const Model& model, const RockRange& rocks, const io::TableRocks& tables,
                      const std::atomic<bool>* stop) {
  const std::uint64_t simulated = std::min(most_simulated, rocks.count() / part_of_run);
  if (simulated == 0) return {};
  const auto is_stopped = [&] { return stop != nullptr && stop->load(std::memory_order_relaxed); };
  const io::TableRocks all(model.rocks());
  Sized<EndpointsTable> endpoints(model, all);
  Sized<PathsTable> paths(model, all);
  Sized<BarriersTable> barriers(model);
  Simulator simulator(model);
  const auto rock = [&](std::uint64_t k) { return rocks.first + (rocks.count() / simulated) * k; };
  for (std::uint64_t k = 0; k < simulated && !is_stopped(); ++k) {
    const RockRecord record = simulator.simulate(rock(k), true);
    endpoints.see(record, simulator.log());
    paths.see(record, simulator.log());
    barriers.see(record, simulator.log());
  }
  // Once more for the time: the first of a thread's rocks are slower than all others.
  const double seconds = seconds_of([&] {
    for (std::uint64_t k = 0; k < simulated && !is_stopped(); ++k) (void)simulator.simulate(rock(k), false);
  });

  const double each = 1 / static_cast<double>(simulated);
  const auto with_end = static_cast<double>(tables.endpoints_before(rocks.last) - tables.endpoints_before(rocks.first));
  const auto with_path = static_cast<double>(tables.paths_before(rocks.last) - tables.paths_before(rocks.first));
  const auto count = static_cast<double>(rocks.count());
  return {.endpoints_bytes = endpoints.bytes() * each * with_end,
          .barriers_bytes = barriers.bytes() * each * count,
          .paths_bytes = paths.bytes() * each * with_path,
          .processor_seconds = each * ((seconds + barriers.seconds()) * count + endpoints.seconds() * with_end +
                                       paths.seconds() * with_path)};
}

std::optional<std::string> large_run_text(const RunSize& size, int threads) {
  if (size.bytes() <= large_bytes) return std::nullopt;
  struct Table {
    double bytes;
    const char *name, *smaller;
  };
  std::string parts, smaller;
  for (const auto& [bytes, name, setting] :
       {Table{size.paths_bytes, "paths.csv", "output.paths = 2000"},
        Table{size.endpoints_bytes, "endpoints.csv", "output.endpoints = \"none\""},
        Table{size.barriers_bytes, "barriers.csv", ""}}) {
    constexpr double worth_naming = 0.05;
    if (bytes < worth_naming * size.bytes()) continue;
    parts += fmt::format("{}{} {}", parts.empty() ? "" : ", ", name, size_text(bytes));
    if (*setting != '\0') smaller += fmt::format("{}{}", smaller.empty() ? "; less with " : " or ", setting);
  }
  return fmt::format("The tables will take about {} ({}), the run about {} on {} {} if the disk keeps up{}",
                     size_text(size.bytes()), parts, time_text(size.processor_seconds / threads), threads,
                     threads == 1 ? "thread" : "threads", smaller);
}

}  // namespace talus::project
