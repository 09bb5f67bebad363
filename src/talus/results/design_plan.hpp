#pragma once
// The input of a barrier design: what is asked, and along which lines.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "talus/barriers/barrier_check.hpp"

namespace talus {

/// A line on plan that rocks cross, cut into sections from its first point that is on the terrain.
struct DesignLine {
  std::string name;
  std::uint32_t barrier = 0;   // number of the barrier or collector
  double length = 0;           // from its start, on plan [m]; 0 in 2D, where a line is a point
  double section_length = 0;   // of all sections but the last, which takes the remainder [m]
  std::uint32_t sections = 1;  // at least one
  double start = 0;            // where it begins on plan, measured from the first point of the input [m]

  [[nodiscard]] std::uint32_t section_at(double station) const;
  /// Where a section begins; for the number of sections: where the line ends.
  [[nodiscard]] double section_begin(std::uint32_t section) const;
  friend bool operator==(const DesignLine&, const DesignLine&) = default;
};

/// A relative cost to compare kits by: length [m] x height [m]^a x MEL [kJ]^b; in 2D for one metre.
struct CostIndex {
  double height_exponent = 1, energy_exponent = 0.5;
  [[nodiscard]] double of(double length, double height, double maximum_energy) const;
  friend bool operator==(const CostIndex&, const CostIndex&) = default;
};

struct DesignPlan {
  static constexpr std::uint32_t most_sections = 1000;  // of one line

  std::vector<DesignLine> lines;
  /// The barrier or collector to protect: the rocks that reach it count, and kits must stop them before it. Without
  /// one, the rocks that reach a line count for that line.
  std::optional<std::uint32_t> protect;
  double confidence = 0.95;
  std::vector<double> percentiles;  // [%]
  double design_percentile = 95;    // that the check is based on [%]
  std::string standard;             // by name; empty: none
  CheckFactors factors;
  std::vector<double> heights;   // nominal heights of the kits to choose from, ascending [m]
  std::vector<double> energies;  // their MELs, ascending [J]
  double catch_share = 0.95;     // target share
  CostIndex cost;
  friend bool operator==(const DesignPlan&, const DesignPlan&) = default;
};

}  // namespace talus
