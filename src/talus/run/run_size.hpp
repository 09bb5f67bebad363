#pragma once
// Estimates how much a run will write and how long it will take, before it begins.

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>

#include "talus/campaign/model.hpp"
#include "talus/campaign/shard.hpp"
#include "talus/project/project.hpp"

namespace talus::project {

struct RunSize {
  // Of the tables, without compression.
  double endpoints_bytes = 0, barriers_bytes = 0, paths_bytes = 0, impacts_bytes = 0;
  double maps_bytes = 0;         // or of envelopes
  double processor_seconds = 0;  // of one thread, for simulating, text and maps

  [[nodiscard]] double bytes() const {
    return endpoints_bytes + barriers_bytes + paths_bytes + impacts_bytes + maps_bytes;
  }
};

/// Estimates a run of these rocks by simulating a few of them, spread over the range. Bytes are reproducible: those of
/// tables are right within a factor of two if paths are similar, those of maps within a factor of four. Seconds depend
/// on the load of this machine. The number of touched cells is extrapolated from the cells touched by exactly one and
/// by two of the simulated rocks (A. Chao 1987, "Estimating the population size for capture-recapture data with unequal
/// catchability", with the extrapolation of R.K. Colwell et al. 2012, "Models and estimators linking individual-based
/// and sample-based rarefaction, extrapolation and comparison of assemblages", eq. 18). The estimate takes no more than
/// a sixtieth of the run; for a run of few rocks it is zero. It ends early, and is too small, once `stop` (may be null)
/// is set.
[[nodiscard]] RunSize expected_size(const Project& project, const Model& model, const RockRange& rocks,
                                    const std::atomic<bool>* stop = nullptr);

/// How many cells `rocks` rocks touch, if `few` rocks touched `touched` of them: `by_one` cells by exactly one rock,
/// `by_two` by two.
[[nodiscard]] double expected_touched(double few, double touched, double by_one, double by_two, double rocks);

/// "340 MB", "2.1 GB".
[[nodiscard]] std::string size_text(double bytes);

/// A note before a run that will write more than a gigabyte: how much, how long it will take on this many threads, and
/// which settings reduce it. nullopt for smaller runs.
[[nodiscard]] std::optional<std::string> large_run_text(const RunSize& size, int threads);

}  // namespace talus::project
