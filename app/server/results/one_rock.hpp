#pragma once
// All that is known of one rock of a run.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>

#include "http/answer.hpp"
#include "run_model.hpp"
#include "talus/archive/run_facts.hpp"

namespace talus::server {

/// Its rows as they stand in the tables; those of its end and its path are computed again where the tables do not have
/// them, with the model that is asked for then. Refuses (404) a rock that was not run, and a path that
/// can no longer be computed (no model).
[[nodiscard]] Json one_rock(const std::filesystem::path& folder, std::uint64_t rock, const RunFacts& facts,
                            const std::function<std::shared_ptr<const BuiltProject>()>& model);

}  // namespace talus::server
