#pragma once
// Results of a barrier design: figures along the lines, the demands of the standard's check, and which kit on which
// line catches the target share at the lowest cost.

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "talus/results/design_tally.hpp"
#include "talus/statistics/order_statistics.hpp"

namespace talus {

/// `rocks` out of `of` rocks, and the confidence interval of the underlying probability.
struct RockShare {
  std::uint64_t rocks = 0, of = 0;  // of: at least one
  double value = 0, low = 0, high = 0;
};

/// Nullopt without any rocks.
[[nodiscard]] std::optional<RockShare> share_of(std::uint64_t rocks, std::uint64_t all, double confidence);

/// A kit that the check asks for.
struct KitDemand {
  double maximum_energy = 0;  // MEL [J]
  int kit_class = 0;
  double height = 0;  // nominal [m]
  friend bool operator==(const KitDemand&, const KitDemand&) = default;
};

/// The design percentile of what the check takes, of rocks that cross a line.
struct CheckedFigures {
  Estimate energy_translational, energy_total, velocity, needed_height;  // [J] [m/s] [m]
};
[[nodiscard]] KitDemand demand_of(const CheckFactors& factors, const CheckedFigures& figures);
/// From the upper ends of their intervals; nullopt if they have none.
[[nodiscard]] std::optional<KitDemand> demand_at_upper_end(const CheckFactors& factors, const CheckedFigures& figures);

/// Figures of a section or of a whole line.
struct DesignFigures {
  double from = 0, to = 0;              // along the line, on plan [m]
  std::uint64_t rocks = 0;              // that cross it
  std::optional<RockShare> share;       // of all rocks of the run; nullopt without any
  std::optional<double> largest_block;  // its diameter [m]; nullopt if no rock crosses
  /// By quantity, in the order of the plan's percentiles; empty if no rock crosses.
  std::array<std::vector<Estimate>, shown_quantity_count> percentiles;
  /// From the design percentile; and from the upper ends of its confidence intervals, if they exist.
  std::optional<KitDemand> demand, demand_at_upper_end;
  /// Metres along the line per metre across it, on plan: the design percentile. 3D only.
  std::optional<double> lateral;
  std::optional<double> clearance;        // D_A: distance on plan to what is protected [m]
  std::optional<double> most_elongation;  // that a kit may have there [m]
};

/// Why a kit does not catch the target share of the rocks: the first of these that alone prevents it. It has to be
/// removed first: no kit may reach what is protected, none stops a rock that passes beyond its ends, and no energy
/// stops one that passes above.
enum class KitLimit { none, clearance, ends, height, energy };

/// A candidate: a line, a height, and the lowest of the energies with which the kit catches the target share of the
/// rocks. If too many rocks pass beyond the ends of the line, the target is that share of the rocks that cross it. If
/// no energy is enough, it is the energy that catches the most.
struct KitChoice {
  std::size_t line = 0;
  std::optional<std::size_t> kit;  // in DesignPlan::kits
  double height = 0;               // [m]
  double maximum_energy = 0;       // [J]
  std::optional<int> kit_class;
  bool suffices = false;            // it catches at least the target share
  bool is_sure = false;             // true of the whole confidence interval of that share
  KitLimit limit = KitLimit::none;  // none if it suffices, or if no rock counts
  std::optional<RockShare> caught;  // of the rocks that count; nullopt without any
  /// Rocks that are not caught: too high; low enough but with too much energy; never at the line, or at its free ends.
  std::uint64_t above = 0, through = 0, beside = 0;
  double cost = 0;
  /// D_d and D_A: what its elongation needs on plan, and what there is [m]; nullopt: unknown.
  std::optional<double> needed_clearance, clearance;
  /// The height that remains after an impact at the MEL, at least [m], and the rocks that are below it, whatever their
  /// energy: what the kit may still stand in the way of until it is repaired. No test says what it then stops.
  std::optional<double> residual_height;
  std::optional<RockShare> below_residual;

  [[nodiscard]] bool reaches_protected() const {
    return needed_clearance && clearance && *needed_clearance > *clearance;
  }
};

/// A kit of a pair.
struct PairKit {
  std::size_t line = 0;
  std::optional<std::size_t> kit;
  double height = 0, maximum_energy = 0;  // [m] [J]
};

/// Two lines one behind the other, with their kits. A rock that the first does not catch goes on as if the first were
/// not there: kits stop rocks or do not.
struct PairChoice {
  std::size_t pair = 0;             // in DesignPlan::pairs
  PairKit first, second;            // first: the line that most of the rocks that cross both cross first
  std::optional<RockShare> caught;  // of the rocks that count, by either
  std::uint64_t by_first = 0;       // caught by the first
  std::uint64_t at_second = 0;      // others that the second meets
  std::uint64_t by_second = 0;      // of these, caught by it
  std::uint64_t beside = 0;         // rocks that count and that neither meets
  bool suffices = false, is_sure = false;
  double cost = 0;                         // of both
  std::optional<double> needed_overlap{};  // of staggered lines [m]
};

struct DesignResult {
  struct Line {
    DesignFigures whole;
    std::vector<DesignFigures> sections;
  };
  std::vector<Line> lines;  // in the order of the plan
  /// Best first. Kits that suffice, by cost. Then kits that catch the target share of the rocks that cross their line
  /// but are limited by its ends: by the number of rocks that pass beyond the ends, then by cost. Then the others, by
  /// the share that they miss; last, those whose net would reach what is protected. A height is left out if a lower one
  /// of the same kit on the same line catches as much with no more energy.
  std::vector<KitChoice> ranking;
  /// Of every pair the kits that are the cheapest for what they catch. Those that suffice come first, by cost; the
  /// others by what they miss.
  std::vector<PairChoice> pairs;
};

[[nodiscard]] DesignResult evaluate(const DesignPlan& plan, const DesignTally& tally);

}  // namespace talus
