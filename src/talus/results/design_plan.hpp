#pragma once
// What a design of barriers is to find out, and along which lines.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "talus/barriers/barrier_check.hpp"

namespace talus {

/// A line on plan that rocks cross, cut into sections from its first point on, or from the first that is on the
/// terrain.
struct DesignLine {
  std::string name;
  std::uint32_t barrier = 0;   // or collector: its number
  double length = 0;           // from its start on, on plan [m]; 0 in 2D, where it is a place
  double section_length = 0;   // of all sections but the last one, which takes the rest [m]
  std::uint32_t sections = 1;  // at least one
  double start = 0;            // where it begins, from the first point as it was given, on plan [m]

  [[nodiscard]] std::uint32_t section_at(double station) const;
  /// Where a section begins; that after the last one: where the line ends.
  [[nodiscard]] double section_begin(std::uint32_t section) const;
  friend bool operator==(const DesignLine&, const DesignLine&) = default;
};

/// What a kit costs, as a number to compare kits by: length [m] x height [m]^a x MEL [kJ]^b; in 2D a metre of it.
struct CostIndex {
  double height_exponent = 1, energy_exponent = 0.5;
  [[nodiscard]] double of(double length, double height, double maximum_energy) const;
  friend bool operator==(const CostIndex&, const CostIndex&) = default;
};

struct DesignPlan {
  static constexpr std::uint32_t most_sections = 1000;  // of one line

  std::vector<DesignLine> lines;
  /// A barrier or collector that stands for what is to be protected: rocks count that reach it, and kits must stop them
  /// before. Nothing: of each line, all rocks count that reach it.
  std::optional<std::uint32_t> protect;
  double confidence = 0.95;
  std::vector<double> percentiles;  // [%]
  double design_percentile = 95;    // that the check begins with [%]
  std::string standard;             // by name; empty: none
  CheckFactors factors;
  std::vector<double> heights;   // of kits to choose from, nominal, rising [m]
  std::vector<double> energies;  // their MELs, rising [J]
  double catch_share = 0.95;     // that is wanted
  CostIndex cost;
  friend bool operator==(const DesignPlan&, const DesignPlan&) = default;
};

}  // namespace talus
