#pragma once
// What follows from the counts of a design: figures along the lines, what the standard's check asks for, and which kit
// on which line catches the wanted share at the least cost.

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "talus/results/design_tally.hpp"
#include "talus/statistics/order_statistics.hpp"

namespace talus {

/// So many of so many rocks, and the confidence interval of the probability behind it.
struct RockShare {
  std::uint64_t rocks = 0, of = 0;  // at least one
  double value = 0, low = 0, high = 0;
};

/// A kit that is needed.
struct KitDemand {
  double maximum_energy = 0;  // MEL [J]
  int kit_class = 0;
  double height = 0;  // nominal [m]
};

/// Of a section, or of a whole line.
struct DesignFigures {
  double from = 0, to = 0;         // along the line, on plan [m]
  std::uint64_t rocks = 0;         // that cross it
  std::optional<RockShare> share;  // of all rocks seen; nothing without any
  /// By quantity (all but the radius), in the order of the plan's percentiles; empty without a rock.
  std::array<std::vector<Estimate>, crossing_quantity_count - 1> percentiles;
  /// By the percentile of the design; and by the upper ends of its confidence intervals, where there are any.
  std::optional<KitDemand> demand, demand_at_upper_end;
};

/// What keeps a kit from catching the wanted share of the rocks: the first of these that alone does. Nothing else helps
/// before it is removed: no kit stops a rock that passes beyond its ends, and no energy one that passes above.
enum class KitLimit { none, ends, height, energy };

/// A kit that may be chosen: on a line, of a height, and with the least of the energies with which it catches the
/// wanted share of the rocks; where the ends of the line leave too few for that, the wanted share of those that cross
/// the line; where no energy does, with which it catches the most.
struct KitChoice {
  std::size_t line = 0;
  double height = 0;          // [m]
  double maximum_energy = 0;  // [J]
  std::optional<int> kit_class;
  bool suffices = false;            // the share that it catches is at least the wanted one
  bool is_sure = false;             // the whole confidence interval of that share says the same
  KitLimit limit = KitLimit::none;  // none where it suffices, or no rock counts
  std::optional<RockShare> caught;  // of the rocks that count; nothing without any
  /// Why others are not caught: too high; low enough, but with too much energy; never at the line.
  std::uint64_t above = 0, through = 0, beside = 0;
  double cost = 0;
};

struct DesignResult {
  struct Line {
    DesignFigures whole;
    std::vector<DesignFigures> sections;
  };
  std::vector<Line> lines;  // in the order of the plan
  /// The best first: those that suffice, by cost; then those that only the ends of their line hold back although they
  /// catch the wanted share of the rocks that cross it, by the rocks that pass beyond the ends, then by cost; then the
  /// others, by what they catch. A height that catches no more, and needs no less energy, than a lower one on the same
  /// line is left out.
  std::vector<KitChoice> ranking;
};

[[nodiscard]] DesignResult evaluate(const DesignPlan& plan, const DesignTally& tally);

}  // namespace talus
