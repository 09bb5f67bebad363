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

/// A kit that the check asks for.
struct KitDemand {
  double maximum_energy = 0;  // MEL [J]
  int kit_class = 0;
  double height = 0;  // nominal [m]
};

/// Figures of a section or of a whole line.
struct DesignFigures {
  double from = 0, to = 0;         // along the line, on plan [m]
  std::uint64_t rocks = 0;         // that cross it
  std::optional<RockShare> share;  // of all rocks of the run; nullopt without any
  /// By quantity (all but the radius), in the order of the plan's percentiles; empty if no rock crosses.
  std::array<std::vector<Estimate>, crossing_quantity_count - 1> percentiles;
  /// From the design percentile; and from the upper ends of its confidence intervals, if they exist.
  std::optional<KitDemand> demand, demand_at_upper_end;
};

/// Why a kit does not catch the target share of the rocks: the first of these that alone prevents it. It has to be
/// removed first: no kit stops a rock that passes beyond its ends, and no energy stops one that passes above.
enum class KitLimit { none, ends, height, energy };

/// A candidate: a line, a height, and the lowest of the energies with which the kit catches the target share of the
/// rocks. If too many rocks pass beyond the ends of the line, the target is that share of the rocks that cross it. If
/// no energy is enough, it is the energy that catches the most.
struct KitChoice {
  std::size_t line = 0;
  double height = 0;          // [m]
  double maximum_energy = 0;  // [J]
  std::optional<int> kit_class;
  bool suffices = false;            // it catches at least the target share
  bool is_sure = false;             // true of the whole confidence interval of that share
  KitLimit limit = KitLimit::none;  // none if it suffices, or if no rock counts
  std::optional<RockShare> caught;  // of the rocks that count; nullopt without any
  /// Rocks that are not caught: too high; low enough but with too much energy; never at the line.
  std::uint64_t above = 0, through = 0, beside = 0;
  double cost = 0;
};

struct DesignResult {
  struct Line {
    DesignFigures whole;
    std::vector<DesignFigures> sections;
  };
  std::vector<Line> lines;  // in the order of the plan
  /// Best first. Kits that suffice, by cost. Then kits that catch the target share of the rocks that cross their line
  /// but are limited by its ends: by the number of rocks that pass beyond the ends, then by cost. Then the others, by
  /// the share that they miss. A height is left out if a lower one on the same line catches as much with no more
  /// energy.
  std::vector<KitChoice> ranking;
};

[[nodiscard]] DesignResult evaluate(const DesignPlan& plan, const DesignTally& tally);

}  // namespace talus
