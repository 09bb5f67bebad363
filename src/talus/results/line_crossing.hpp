#pragma once
// What a rock is like where it first crosses a line, and the kit that it asks for there. The design of a run
// (design_tally.hpp) and questions after it (room `lines`) take it from here.

#include <array>
#include <cstdint>
#include <vector>

#include "talus/results/design_plan.hpp"
#include "talus/trajectory/rock_log.hpp"

namespace talus {

/// Quantities of a rock at the place where it crosses a line.
enum class CrossingQuantity : std::uint32_t {
  energy_translational,
  energy_total,
  velocity,
  height,         // of the top of the block (rocks/heights.hpp)
  needed_height,  // of a kit, nominal
  lateral
};  // [J] [m/s] [m]; lateral: metres along the line per metre across it, on plan
inline constexpr std::size_t crossing_quantity_count = 6;
/// The first ones have percentiles in the results.
inline constexpr std::size_t shown_quantity_count = 4;

/// A rock's first crossing of a barrier or collector, on a panel or above it, stopped there or not; null if there is
/// none.
[[nodiscard]] const Passage* first_passage(const RockLog& log, std::uint32_t barrier);

struct LineCrossing {
  std::uint32_t section = 0;
  std::array<double, crossing_quantity_count> values{};
  double diameter = 0;       // of the block [m]
  double needed_energy = 0;  // of a kit: MEL [J]
  // The first sufficient ones of the plan; their number if none is.
  std::uint32_t height = 0, energy = 0;

  [[nodiscard]] double of(CrossingQuantity quantity) const { return values[static_cast<std::size_t>(quantity)]; }
  [[nodiscard]] double needed_height() const { return of(CrossingQuantity::needed_height); }
};
/// Index of the first of the ascending values that is at least `needed`; their number if none is.
[[nodiscard]] std::uint32_t first_sufficient(const std::vector<double>& ascending, double needed);

[[nodiscard]] LineCrossing line_crossing(const DesignPlan& plan, const DesignLine& line, const Rock& rock,
                                         const Passage& crossing);

}  // namespace talus
