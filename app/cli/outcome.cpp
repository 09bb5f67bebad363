#include "outcome.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace talus::cli {

namespace {

constexpr std::size_t most_printed = 20;  // barriers

/// All in order, or if there are too many those with the most hits.
std::vector<std::size_t> barriers_to_print(const Summary& summary) {
  std::vector<std::size_t> numbers(summary.barriers.size());
  std::iota(numbers.begin(), numbers.end(), std::size_t{0});
  if (numbers.size() <= most_printed) return numbers;
  std::ranges::stable_sort(numbers, std::ranges::greater(),
                           [&](std::size_t b) { return summary.barriers[b].rocks_hit; });
  numbers.resize(most_printed);
  return numbers;
}

}  // namespace

void print_summary(const Summary& summary, const std::vector<std::string>& barriers) {
  for (int k = 0; k < end_reason_count; ++k) {
    const std::uint64_t count = summary.ended(static_cast<EndReason>(k));
    if (count > 0) fmt::print("  {:<22}{:>10}\n", name(static_cast<EndReason>(k)), count);
  }
  const Descriptive way = summary.runout_plan.describe();
  if (way.mean && way.maximum)
    fmt::print("  runout on plan: mean {:.2f} m, maximum {:.2f} m\n", *way.mean, *way.maximum);
  for (const std::string& note : notes_of(summary)) fmt::print("  note: {}\n", note);
  for (const std::size_t b : barriers_to_print(summary)) {
    const BarrierTally& tally = summary.barriers[b];
    const Descriptive energy = tally.total_energy.describe(), height = tally.height.describe();
    fmt::print("  {}: {} rocks hit it, {} passed above", barriers[b], tally.rocks_hit, tally.rocks_passed_above);
    if (energy.maximum) {
      const auto percentile = [](const Tally& values) { return values.sketch().quantile(0.95).value_or(0); };
      fmt::print("; 95 %: {:.1f} kJ, contact {:.2f} m high; at most {:.1f} kJ, {:.2f} m",
                 percentile(tally.total_energy) / 1000, percentile(tally.height), *energy.maximum / 1000,
                 *height.maximum);
    }
    fmt::print("\n");
  }
  if (summary.barriers.size() > most_printed) {
    const auto hit = std::ranges::count_if(summary.barriers, [](const auto& tally) { return tally.rocks_hit > 0; });
    fmt::print(
        "  shown are the {} of {} barriers and collectors with the most hits; {} were hit; all are in summary.json\n",
        most_printed, summary.barriers.size(), hit);
  }
}

void print_stored(const std::optional<StoredRocks>& stored) {
  if (!stored || stored->share == 1) return;
  fmt::print("  trajectories of {} rocks are stored, {:.3g} % of all: a fair sample; more with output.trajectories\n",
             stored->rocks, 100 * stored->share);
}

}  // namespace talus::cli
