#pragma once
// What the rocks did, in a few lines for the terminal.

#include <string>
#include <vector>

#include "talus/results/summary.hpp"

namespace talus::cli {

/// Ends by reason, runout, notes, and a line a barrier, whose names are given in their order.
void print_summary(const Summary& summary, const std::vector<std::string>& barriers);

}  // namespace talus::cli
