#pragma once
// Writes summary.json (run_summary.hpp) from the facts of a run and its sums.

#include <optional>
#include <string>
#include <vector>

#include "talus/archive/run_description.hpp"
#include "talus/archive/run_summary.hpp"
#include "talus/campaign/shard.hpp"
#include "talus/files/text_sink.hpp"
#include "talus/results/design_result.hpp"
#include "talus/results/summary.hpp"

namespace talus {

/// The course of a run, or of several merged runs.
struct RunCourse {
  RockRange range;             // planned rocks
  std::optional<Shard> shard;  // nullopt: the whole campaign
  bool interrupted = false;
  std::vector<RockRange> missing;  // of merged runs: rocks that are in none of them
  double seconds = 0;              // computing time, summed over merged runs
  int threads = 1;                 // maximum over merged runs
  std::optional<StoredRocks> trajectories{};
};

/// Everything except `timings` depends only on the project, the seed and the rocks done. `warnings` are all warnings of
/// the run, including those of the description. Expects `design` if the description has a plan for it. Written piece by
/// piece, because there may be very many barriers; barriers without hits have no statistics and histograms.
void write_summary(TextSink& out, const RunDescription& description, const ToldWarnings& warnings,
                   const Summary& summary, const RunCourse& course, const DesignResult* design = nullptr);

[[nodiscard]] WaysSummary ways_of(const Summary& sums);
/// The statistics of a tally.
[[nodiscard]] Statistics statistics_of(const Tally& tally);

}  // namespace talus
