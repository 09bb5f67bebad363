#pragma once
// A run's results in a few lines for the terminal.

#include <optional>
#include <string>
#include <vector>

#include "talus/archive/run_summary.hpp"
#include "talus/results/summary.hpp"

namespace talus::cli {

/// Prints the end reasons, runout, notes and one line per barrier. `barriers`: their names, in order.
void print_summary(const Summary& summary, const std::vector<std::string>& barriers);

/// Prints how many trajectories are stored, unless all are.
void print_stored(const std::optional<StoredRocks>& stored);

}  // namespace talus::cli
