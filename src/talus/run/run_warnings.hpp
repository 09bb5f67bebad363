#pragma once
// Warnings about a run that only its sums can show.

#include <cstdint>

#include "talus/archive/run_description.hpp"
#include "talus/core/problems.hpp"
#include "talus/results/design_result.hpp"
#include "talus/results/summary.hpp"

namespace talus::project {

/// Warns of rocks that were lost, lifted, or (if more than one in a hundred) ended by a limit of the data or of the
/// computation; and if most of their way was along the ground.
void warn_of_rocks(const Summary& summary, Problems& warnings);

/// Warns of sources from which a stopped run has released no rocks, or not all: its results are not representative.
void warn_of_sources(const RunDescription& description, std::uint64_t first_not_run, Problems& warnings);

/// Warns of collectors above which many rocks passed: their statistics are of the other rocks only.
void warn_of_collectors(const RunDescription& description, const Summary& summary, Problems& warnings);

/// Warns of design lines that no rock crosses, of heights below the size of the largest block and, if no kit catches
/// the wanted share, of what limits the best kit of each line.
void warn_of_design(const DesignPlan& plan, const DesignResult& result, Problems& warnings);

}  // namespace talus::project
