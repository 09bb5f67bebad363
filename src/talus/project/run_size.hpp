#pragma once
// How much a run will write and how long it will take, before it begins.

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>

#include "talus/campaign/model.hpp"
#include "talus/campaign/shard.hpp"
#include "talus/io/table_rocks.hpp"

namespace talus::project {

struct RunSize {
  double endpoints_bytes = 0, barriers_bytes = 0, paths_bytes = 0;  // of the tables, without compression
  double processor_seconds = 0;                                     // of one thread, for the rocks and their text

  [[nodiscard]] double bytes() const { return endpoints_bytes + barriers_bytes + paths_bytes; }
};

/// Of a run of these rocks of the model with these in its tables. Estimated from a few rocks, spread over them, that
/// are simulated for it: bytes within a factor of two where paths are alike, and always the same; seconds as this
/// machine is busy now. The estimate takes no more than a sixtieth of the run: of a run of few rocks it is nothing.
/// It ends early, and is too small, once `stop` (may be null) is set.
[[nodiscard]] RunSize expected_size(const Model& model, const RockRange& rocks, const io::TableRocks& tables,
                                    const std::atomic<bool>* stop = nullptr);

/// What to say before a run that will write more than a gigabyte: how much, how long it will take on so many threads,
/// and which settings make it smaller. Nothing of others.
[[nodiscard]] std::optional<std::string> large_run_text(const RunSize& size, int threads);

}  // namespace talus::project
