#include "talus/statistics/box_plot.hpp"

#include <algorithm>
#include <functional>

#include "talus/statistics/quantile.hpp"

namespace talus {

namespace {

using Counted = QuantileSketch::Counted;

BoxPlot from_quantiles(const std::vector<Counted>& ascending, const std::function<double(double)>& quantile,
                       bool has_values) {
  BoxPlot plot;
  plot.lower_quartile = quantile(0.25);
  plot.median = quantile(0.5);
  plot.upper_quartile = quantile(0.75);
  const double reach = 1.5 * (plot.upper_quartile - plot.lower_quartile);
  // A whisker starts at the box: with few values a quartile may lie beyond every value on its side of the fence.
  plot.lower_whisker = plot.lower_quartile;
  plot.upper_whisker = plot.upper_quartile;
  for (const auto& [value, count] : ascending) {
    if (value < plot.lower_quartile - reach || value > plot.upper_quartile + reach) {
      plot.outlier_count += count;
      if (has_values) plot.outliers.insert(plot.outliers.end(), count, value);
    } else {
      plot.lower_whisker = std::min(plot.lower_whisker, value);
      plot.upper_whisker = std::max(plot.upper_whisker, value);
    }
  }
  return plot;
}

}  // namespace

std::optional<BoxPlot> box_plot(std::span<const double> sample) {
  if (sample.empty()) return {};
  std::vector<double> sorted(sample.begin(), sample.end());
  std::sort(sorted.begin(), sorted.end());
  std::vector<Counted> ascending;
  for (const double x : sorted) ascending.push_back({x, 1});
  const auto quantile = [&](double p) {
    const auto [rank, fraction] = quantile_place(p, sorted.size());
    return fraction > 0 ? between(sorted[rank], sorted[rank + 1], fraction) : sorted[rank];
  };
  return from_quantiles(ascending, quantile, true);
}

std::optional<BoxPlot> box_plot(const QuantileSketch& sketch) {
  if (sketch.count() == 0) return {};
  const auto quantile = [&](double p) { return *sketch.quantile(p); };
  return from_quantiles(sketch.ascending(), quantile, sketch.is_exact());
}

}  // namespace talus
