#pragma once
// Histograms of two runs in the same bins, for a page that compares them.

#include "talus/archive/run_summary.hpp"

namespace talus {

/// Counts each quantity of two summaries again in common bins; barriers are matched by name. A quantity that one of
/// them lacks, or whose bins are not Talus's own, stays unchanged.
void give_common_bins(RunSummary& first, RunSummary& second);

}  // namespace talus
