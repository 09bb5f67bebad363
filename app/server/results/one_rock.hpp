#pragma once
// Everything about one rock of a run.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>

#include "http/answer.hpp"
#include "run_model.hpp"
#include "talus/archive/run_facts.hpp"

namespace talus::server {

/// The rock's rows of the tables. If they lack its end point or path, it is simulated again; `model` is only called
/// then. Refuses (404) a rock that was not run, and a path that can no longer be computed (`model` returned null).
[[nodiscard]] Json one_rock(const std::filesystem::path& folder, std::uint64_t rock, const RunFacts& facts,
                            const std::function<std::shared_ptr<const BuiltProject>()>& model);

}  // namespace talus::server
