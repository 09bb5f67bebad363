#pragma once
// The input of a barrier design: what is asked, along which lines, and which kits there are to choose from.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "talus/barriers/barrier_check.hpp"
#include "talus/core/vec.hpp"

namespace talus {

/// A straight piece of a line on plan.
struct LinePiece {
  double station = 0;               // where it begins, as DesignLine::start [m]
  double along_x = 0, along_y = 0;  // unit
  friend bool operator==(const LinePiece&, const LinePiece&) = default;
};

/// A line on plan that rocks cross, cut into sections from its first point that is on the terrain.
struct DesignLine {
  std::string name;
  std::uint32_t barrier = 0;        // number of the barrier or collector
  double length = 0;                // from its start, on plan [m]; 0 in 2D, where a line is a point
  double section_length = 0;        // of all sections but the last, which takes the remainder [m]
  std::uint32_t sections = 1;       // at least one
  double start = 0;                 // where it begins on plan, measured from the first point of the input [m]
  std::vector<LinePiece> pieces{};  // in order; empty in 2D
  std::vector<double>
      clearances{};  // D_A of each section: the distance on plan to what is protected [m]; empty: unknown

  [[nodiscard]] std::uint32_t section_at(double station) const;
  /// Where a section begins; for the number of sections: where the line ends.
  [[nodiscard]] double section_begin(std::uint32_t section) const;
  /// Whether a place is within this distance on plan of an end of the line [m].
  [[nodiscard]] bool is_at_free_end(double station, double free_end) const;
  /// How far a rock with this velocity moves along the line while it moves a metre across it, on plan; 0 in 2D.
  [[nodiscard]] double lateral_of(double station, const Vec3& velocity) const;
  /// The smallest of the clearances; nullopt: unknown.
  [[nodiscard]] std::optional<double> least_clearance() const;
  friend bool operator==(const DesignLine&, const DesignLine&) = default;
};

/// Two lines, one behind the other.
struct DesignPair {
  std::uint32_t one = 0, other = 0;  // in DesignPlan::lines, one < other
  // Of staggered lines, on plan [m]: how far they overlap (negative: the gap between them), and the distance between
  // them there.
  std::optional<double> overlap{}, distance{};
  friend bool operator==(const DesignPair&, const DesignPair&) = default;
};

/// A kit on the market.
struct DesignKit {
  std::string name;
  std::vector<double> heights;  // nominal, ascending [m]
  double maximum_energy = 0;    // MEL [J]
  double checked_energy = 0;    // compared with the MEL that the check asks for: the MEL, or three times the SEL [J]
  std::optional<double> elongation{};      // in its test at the MEL [m]
  std::optional<double> residual_share{};  // least share of the height that remains after an impact at the MEL
  std::optional<double> cost_per_metre{};
  friend bool operator==(const DesignKit&, const DesignKit&) = default;
};

/// A relative cost to compare kits by: length [m] x height [m]^a x MEL [kJ]^b; in 2D for one metre.
struct CostIndex {
  double height_exponent = 1, energy_exponent = 0.5;
  [[nodiscard]] double of(double length, double height, double maximum_energy) const;
  friend bool operator==(const CostIndex&, const CostIndex&) = default;
};

/// A factor of the check as it was applied, for the results.
struct AppliedFactor {
  std::string symbol, key, multiplies, source, not_read;
  double value = 1;
  friend bool operator==(const AppliedFactor&, const AppliedFactor&) = default;
};

struct DesignPlan {
  static constexpr std::uint32_t most_sections = 1000;  // of one line
  /// Counts of all pairs: 16 MB, and as many combinations to choose from.
  static constexpr std::size_t most_pair_counts = 2'000'000;
  static constexpr std::size_t most_kit_heights = 1000;  // of all kits

  std::vector<DesignLine> lines;
  /// The barrier or collector to protect: the rocks that reach it count, and kits must stop them before it. Without
  /// one, the rocks that reach a line count for that line.
  std::optional<std::uint32_t> protect;
  double free_end = 0;  // at both ends of every line, where it catches nothing [m]
  double confidence = 0.95;
  std::vector<double> percentiles;  // [%]
  double design_percentile = 95;    // that the check is based on [%]
  std::string standard;             // by name; empty: none
  std::string standard_not_read;    // what could not be read of it
  std::vector<AppliedFactor> applied;
  CheckFactors factors;
  /// Heights [m] and energies [J] that rocks are counted by, ascending. Without kits, each height is to be had with
  /// each energy. With kits: those of the kits, and the heights that remain after an impact.
  std::vector<double> heights, energies;
  std::vector<DesignKit> kits;
  std::vector<DesignPair> pairs;
  double catch_share = 0.95;  // target share
  CostIndex cost;
  friend bool operator==(const DesignPlan&, const DesignPlan&) = default;

  [[nodiscard]] std::size_t kit_classes() const { return (heights.size() + 1) * (energies.size() + 1); }
};

}  // namespace talus
