#pragma once
// How large the table of paths will be, before it is written.

#include <cstdint>
#include <optional>

#include "talus/campaign/model.hpp"
#include "talus/campaign/shard.hpp"

namespace talus::project {

/// Bytes of paths.csv of a run of these rocks where at most so many have their paths written (nothing: all). Estimated
/// from a few rocks, spread over them, that are thrown for it: within a factor of two where paths are alike.
[[nodiscard]] double expected_paths_bytes(const Model& model, const RockRange& rocks,
                                          std::optional<std::int64_t> path_limit);

}  // namespace talus::project
