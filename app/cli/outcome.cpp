#include "outcome.hpp"

#include <fmt/format.h>

namespace talus::cli {

void print_summary(const Summary& summary, const std::vector<std::string>& barriers) {
  for (int k = 0; k < end_reason_count; ++k) {
    const std::uint64_t count = summary.ended(static_cast<EndReason>(k));
    if (count > 0) fmt::print("  {:<22}{:>10}\n", name(static_cast<EndReason>(k)), count);
  }
  const Descriptive way = summary.runout_plan.describe();
  if (way.mean && way.maximum)
    fmt::print("  runout on plan: mean {:.2f} m, greatest {:.2f} m\n", *way.mean, *way.maximum);
  for (const std::string& note : notes_of(summary)) fmt::print("  note: {}\n", note);
  for (std::size_t b = 0; b < summary.barriers.size(); ++b) {
    const BarrierTally& tally = summary.barriers[b];
    const Descriptive energy = tally.total_energy.describe(), height = tally.height.describe();
    fmt::print("  {}: {} rocks hit it, {} passed above", barriers[b], tally.rocks_hit, tally.rocks_passed_above);
    if (energy.maximum) fmt::print("; at most {:.1f} kJ, {:.2f} m high", *energy.maximum / 1000, *height.maximum);
    fmt::print("\n");
  }
}

}  // namespace talus::cli
