#pragma once
// paths.csv from the store of trajectories.

#include <cstdint>
#include <optional>

#include "talus/archive/result_tables.hpp"
#include "talus/files/text_sink.hpp"
#include "talus/store/trajectory_store.hpp"

namespace talus {

/// What the rows of paths.csv need beside the rocks.
[[nodiscard]] TableContext path_context_of(const StoreFacts& facts);

/// Writes the rows of paths.csv of rocks in the store: all, or `wanted` of them, evenly spread. Keeps one path in
/// memory. Throws BadInput if the store is damaged.
void write_stored_paths(const TrajectoryStore& store, std::optional<std::uint64_t> wanted, TextSink& out);

}  // namespace talus
