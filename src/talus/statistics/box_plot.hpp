#pragma once
// The numbers of a box-and-whisker plot.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "talus/statistics/quantile_sketch.hpp"

namespace talus {

/// J. W. Tukey, "Exploratory data analysis" (1977): the box from quartile to quartile (by definition 7, quantile.hpp),
/// whiskers to the furthest values within 1.5 box heights of it, and the values beyond as outliers.
struct BoxPlot {
  double lower_whisker = 0;
  double lower_quartile = 0;
  double median = 0;
  double upper_quartile = 0;
  double upper_whisker = 0;
  std::uint64_t outlier_count = 0;
  std::vector<double> outliers;  // ascending; empty if the values were counted in bins, even if there are outliers
  [[nodiscard]] friend bool operator==(const BoxPlot&, const BoxPlot&) = default;
};

/// nullopt if there are no values.
[[nodiscard]] std::optional<BoxPlot> box_plot(std::span<const double> sample);
/// As exact as the sketch: once it counts in bins, each number is within 0.05 % of its distance from the sketch's
/// origin.
[[nodiscard]] std::optional<BoxPlot> box_plot(const QuantileSketch& sketch);

}  // namespace talus
