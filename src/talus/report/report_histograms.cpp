#include "talus/report/report_histograms.hpp"

#include <optional>
#include <string>

#include "talus/statistics/histogram.hpp"

namespace talus {

namespace {

constexpr std::uint64_t most_bins = 50;  // more would be too narrow for two runs side by side

std::optional<Histogram> histogram_of(const HistogramCounts& given) {
  const auto edges = bins_from(given.low, given.width, given.counts.size());
  if (!edges) return std::nullopt;
  Histogram histogram(*edges);
  for (std::size_t k = 0; k < given.counts.size(); ++k) histogram.add_to(k, given.counts[k]);
  return histogram;
}

HistogramCounts counts_of(const Histogram& histogram) {
  const BinEdges& edges = histogram.edges();
  return {edges.edge(0),
          BinEdges{1, edges.step_digit, edges.step_exponent, 1}.edge(0),
          {histogram.counts().begin(), histogram.counts().end()}};
}

/// For all quantities that both have.
void share_bins(Histograms& first, Histograms& second) {
  for (auto& [quantity, one] : first) {
    for (auto& [other_quantity, other] : second) {
      if (quantity != other_quantity || !one || !other) continue;
      const auto a = histogram_of(*one), b = histogram_of(*other);
      if (!a || !b) continue;
      const BinEdges edges = common_bins(a->edges(), b->edges(), most_bins);
      one = counts_of(a->regrouped(edges));
      other = counts_of(b->regrouped(edges));
    }
  }
}

}  // namespace

void give_common_bins(RunSummary& first, RunSummary& second) {
  share_bins(first.histograms, second.histograms);
  for (BarrierSummary& here : first.barriers) {
    for (BarrierSummary& there : second.barriers) {
      if (here.name == there.name) share_bins(here.histograms, there.histograms);
    }
  }
}

}  // namespace talus
