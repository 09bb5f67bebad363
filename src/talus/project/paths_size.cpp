#include "talus/project/paths_size.hpp"

#include <algorithm>

#include "talus/campaign/simulate.hpp"
#include "talus/io/result_tables.hpp"

namespace talus::project {

namespace {

struct Counter : TextSink {
  void write(std::string_view text) override { bytes += static_cast<double>(text.size()); }
  double bytes = 0;
};

}  // namespace

double expected_paths_bytes(const Model& model, const RockRange& rocks, std::optional<std::int64_t> path_limit) {
  constexpr std::uint64_t most_thrown = 32;
  const std::uint64_t thrown = std::min(most_thrown, rocks.count());
  if (thrown == 0) return 0;
  Counter counter;
  PathsTable table(TableContext::of(model), counter, model.rocks(), std::nullopt);
  const auto part = table.new_part();
  Simulator simulator(model);
  for (std::uint64_t k = 0; k < thrown; ++k) {
    const std::uint64_t rock = rocks.first + (rocks.count() / thrown) * k;
    const RockRecord record = simulator.simulate(rock, true);
    part->see(record, simulator.log());
  }
  table.commit(*part);
  // Of a shard's rocks as many are written as of the whole run's.
  const auto all = static_cast<double>(model.rocks());
  const double share = path_limit ? std::min(1.0, static_cast<double>(*path_limit) / all) : 1;
  return counter.bytes / static_cast<double>(thrown) * share * static_cast<double>(rocks.count());
}

}  // namespace talus::project
