#pragma once
// A run's results in a few lines for the terminal.

#include <string>
#include <vector>

#include "talus/results/summary.hpp"

namespace talus::cli {

/// Prints the end reasons, runout, notes and one line per barrier. `barriers`: their names, in order.
void print_summary(const Summary& summary, const std::vector<std::string>& barriers);

}  // namespace talus::cli
