#include "talus/archive/doubts.hpp"

#include <fmt/format.h>

namespace talus {

namespace {

void doubt_height(const std::string& where, ProblemKind kind, const char* whose, double height,
                  const DesignFigures& figures, Problems& warnings) {
  if (!figures.largest_block || height >= *figures.largest_block) return;
  warnings.add({.severity = Severity::warning,
                .where = where,
                .what = fmt::format("{} {:.2f} m, less than the largest block that crosses", whose, height),
                .why = fmt::format("its diameter is {:.2f} m: such a block reaches over the fence even as it rolls",
                                   *figures.largest_block),
                .hint = "Take at least that height, or a higher percentile",
                .kind = kind});
}

}  // namespace

void doubt_ways(const WaysSummary& ways, Problems& warnings) {
  const double all = ways.flown_m + ways.on_ground_m;
  if (!(ways.on_ground_m > doubtful_share_on_ground * all)) return;
  warnings.add(
      {.severity = Severity::warning,
       .where = "rocks",
       .what = fmt::format("{:.0f} % of the way of all rocks was slid or rolled", 100 * ways.on_ground_m / all),
       .why = "blocks bounce on natural ground: heights, and what fences must have, may be far too low",
       .hint = "Look at roughness_deg of the materials before you use heights of this run",
       .kind = ProblemKind::mostly_on_ground});
}

void doubt_needed_height(const std::string& where, const DesignFigures& figures, Problems& warnings) {
  if (figures.demand)
    doubt_height(where, ProblemKind::height_below_block, "the height that a fence must have is", figures.demand->height,
                 figures, warnings);
}

void doubt_kit_height(const std::string& where, double height, const DesignFigures& figures, Problems& warnings) {
  doubt_height(where, ProblemKind::kit_below_block, "the kit's height is", height, figures, warnings);
}

}  // namespace talus
