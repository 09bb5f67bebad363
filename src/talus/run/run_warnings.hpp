#pragma once
// What is doubtful about a run and shows in its sums only.

#include <cstdint>

#include "talus/archive/run_description.hpp"
#include "talus/core/problems.hpp"
#include "talus/results/design_result.hpp"
#include "talus/results/summary.hpp"

namespace talus::project {

/// Adds what only the sums tell: rocks that were lost, lifted, or, more than one in a hundred, ended by a limit of the
/// data or of the computation.
void warn_of_rocks(const Summary& summary, Problems& warnings);

/// Adds of which sources a run that was stopped has thrown no rock, or not all: its results are not those of the whole.
void warn_of_sources(const RunDescription& description, std::uint64_t first_not_run, Problems& warnings);

/// Adds which collectors many rocks passed above: their statistics are of the others.
void warn_of_collectors(const RunDescription& description, const Summary& summary, Problems& warnings);

/// Adds which lines of a design no rock crosses, and, where no kit catches the wanted share, what holds the best kit of
/// each line back.
void warn_of_design(const DesignPlan& plan, const DesignResult& result, Problems& warnings);

}  // namespace talus::project
