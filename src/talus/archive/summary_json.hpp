#pragma once
// Writes summary.json (run_summary.hpp) from what a run was and its sums.

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

/// How a run went, or several that were merged.
struct RunCourse {
  RockRange range;             // the rocks that were to be done
  std::optional<Shard> shard;  // nothing: the whole campaign
  bool interrupted = false;
  std::vector<RockRange> missing;  // of merged runs: rocks that none of them did
  double seconds = 0;              // spent on computing; of several runs all together
  int threads = 1;                 // at most, of several runs
};

/// Everything but `timings` depends on the project, the seed and the rocks done, and on nothing else. `warnings` are
/// all of the run, those of the description among them. `design`: where the description has a plan for it. Written
/// piece by piece, since there may be very many barriers; of those that no rock hit there are no statistics and
/// histograms.
void write_summary(TextSink& out, const RunDescription& description, const std::vector<std::string>& warnings,
                   const Summary& summary, const RunCourse& course, const DesignResult* design = nullptr);

/// What a tally says.
[[nodiscard]] Statistics statistics_of(const Tally& tally);

}  // namespace talus
