#pragma once
// How much a run will write and how long it will take, before it begins.

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>

#include "talus/campaign/model.hpp"
#include "talus/campaign/shard.hpp"
#include "talus/project/project.hpp"

namespace talus::project {

struct RunSize {
  double endpoints_bytes = 0, barriers_bytes = 0, paths_bytes = 0;  // of the tables, without compression
  double maps_bytes = 0;                                            // or envelopes
  double processor_seconds = 0;  // of one thread, for the rocks, their text and the maps

  [[nodiscard]] double bytes() const { return endpoints_bytes + barriers_bytes + paths_bytes + maps_bytes; }
};

/// Of a run of these rocks of the project's model. Estimated from a few rocks, spread over them, that are simulated for
/// it: bytes of tables within a factor of two where paths are alike, those of maps within one of four, and always the
/// same; seconds as this machine is busy now. Which cells all rocks touch follows from how many cells one of the few
/// touched, and how many two (A. Chao 1987, "Estimating the population size for capture-recapture data with unequal
/// catchability", with the extrapolation of R.K. Colwell et al. 2012, "Models and estimators linking individual-based
/// and sample-based rarefaction, extrapolation and comparison of assemblages", eq. 18). The estimate takes no more than
/// a sixtieth of the run: of a run of few rocks it is nothing. It ends early, and is too small, once `stop` (may be
/// null) is set.
[[nodiscard]] RunSize expected_size(const Project& project, const Model& model, const RockRange& rocks,
                                    const std::atomic<bool>* stop = nullptr);

/// How many things (cells) some thousand rocks touch, if a few touched `touched` of them, `by_one` no more than one
/// rock, and `by_two` two.
[[nodiscard]] double expected_touched(double few, double touched, double by_one, double by_two, double rocks);

/// "340 MB", "2.1 GB".
[[nodiscard]] std::string size_text(double bytes);

/// What to say before a run that will write more than a gigabyte: how much, how long it will take on so many threads,
/// and which settings make it smaller. Nothing of others.
[[nodiscard]] std::optional<std::string> large_run_text(const RunSize& size, int threads);

}  // namespace talus::project
