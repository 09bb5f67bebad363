#pragma once
// Two lines one behind the other: what their kits catch together, and the cheapest kits for each share.
//
// A rock is caught by a pair if either kit catches it. A kit stops a rock or does not touch it, so the rocks that the
// second meets are those that the first does not catch, on the paths that they have without it: the share is that of a
// run in which the first stops what it catches (test/cli/run_pairs_test.cpp), rock by rock. Spheres count by their
// centres; a barrier that is built also stops those that touch its top, so that for spheres the share is a lower bound.

#include <optional>
#include <vector>

#include "talus/results/design_result.hpp"

namespace talus {

/// `laterals` of each line, as DesignFigures::lateral.
[[nodiscard]] std::vector<PairChoice> evaluate_pairs(const DesignPlan& plan, const DesignTally& tally,
                                                     const std::vector<std::optional<double>>& laterals);

/// The price of a kit on a line, or else its cost index.
[[nodiscard]] double cost_of(const DesignPlan& plan, std::size_t line, std::optional<std::size_t> kit, double height,
                             double maximum_energy);

}  // namespace talus
