#pragma once
// What the rocks of a finished run do at any lines on plan: the figures of a design (results/design_result.hpp) with a
// collector there, from the paths of its rocks.
//
// If the paths of only some rocks are kept, shares are of those, and all intervals are those of their number. Rocks are
// independent of each other, and every rock had the same chance to be kept, so nothing else changes.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "talus/lines/asked_line.hpp"
#include "talus/lines/rock_paths.hpp"
#include "talus/model/design_plan.hpp"
#include "talus/results/design_result.hpp"

namespace talus {

struct CrossingRock {
  std::uint64_t rock = 0;
  LineCrossing at;
};

/// The largest values of each quantity at a line, or in an area.
using CrossingMaxima = std::array<double, crossing_quantity_count>;

struct LineAnswer {
  DesignPlan plan;            // with this line alone
  DesignResult::Line result;  // its figures
  KitDemands demands;
  std::vector<CrossingRock> crossings;  // first crossings, in the order of the rocks
  std::uint64_t rocks = 0;              // asked: those whose paths are kept

  /// Of the whole line, or of one section; nullopt if no rock crosses.
  [[nodiscard]] std::optional<CrossingMaxima> maxima(std::optional<std::uint32_t> section = {}) const;
  /// The section that asks for the most energy, by the design percentile; nullopt if no rock crosses.
  [[nodiscard]] std::optional<std::uint32_t> worst_section() const;
};

/// The design of one line, with the check, percentiles and kits of `basis`; `number`: of its barrier.
[[nodiscard]] DesignPlan plan_of_line(const project::DesignBasis& basis, const Model& model, const AskedLine& line,
                                      std::uint32_t number);

/// One answer for each line, with the check, percentiles and kits of `basis`. All lines are followed at the same time.
[[nodiscard]] std::vector<LineAnswer> ask_lines(const Model& model, const project::DesignBasis& basis,
                                                const RockPaths& paths, std::span<const AskedLine> lines);

/// The same for answers of which no kits are asked.
[[nodiscard]] project::DesignBasis without_kits(project::DesignBasis basis);

/// The rocks of which a kit stops how many, and what lets the others pass.
struct KitAnswer {
  double height = 0, maximum_energy = 0;  // nominal [m], MEL [J]
  std::optional<RockShare> stopped;       // of the rocks that cross; nullopt if none does
  std::uint64_t above = 0, through = 0;   // too high; low enough but with too much energy
};
[[nodiscard]] bool stops(double height, double maximum_energy, const LineCrossing& crossing);
[[nodiscard]] KitAnswer judge_kit(const LineAnswer& answer, double height, double maximum_energy);

}  // namespace talus
