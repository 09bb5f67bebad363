#pragma once
// Histograms of two runs in the same bins, for a page that shows them side by side.

#include "talus/archive/run_summary.hpp"

namespace talus {

/// Counts each quantity of two summaries again, in bins of both; barriers are of one kind by their names. What one of
/// them lacks, or has in bins that are not Talus's own, stays as it is.
void give_common_bins(RunSummary& first, RunSummary& second);

}  // namespace talus
