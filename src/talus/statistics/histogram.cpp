#include "talus/statistics/histogram.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "talus/core/check.hpp"

namespace talus {

namespace {

// The double nearest to `steps` x digit x 10^exponent while the powers of ten are exact, up to 10^22; 1 ulp beyond.
double decimal(std::int64_t steps, int digit, int exponent) {
  const auto number = static_cast<double>(steps * digit);
  return exponent < 0 ? number / std::pow(10.0, -exponent) : number * std::pow(10.0, exponent);
}

}  // namespace

double BinEdges::edge(std::uint64_t i) const {
  return decimal(first + static_cast<std::int64_t>(i), step_digit, step_exponent);
}

BinEdges nice_bins(double least, double most, std::uint64_t most_bins) {
  TALUS_PROMISE(std::isfinite(least) && std::isfinite(most) && least <= most, "a range has two ends in order");
  TALUS_PROMISE(std::abs(least) < 1e100 && std::abs(most) < 1e100, "beyond, steps are no numbers for a reader");
  TALUS_PROMISE(most_bins >= 2 && most_bins <= 1000, "a step that fits exists for two bins and more");
  const double magnitude = std::max(std::abs(least), std::abs(most));
  // A step of at least 1e-12 of the magnitude keeps the edges distinct and the number of steps to them an integer that
  // a double holds.
  double span = std::max(most - least, magnitude * 1e-12 * static_cast<double>(most_bins));
  if (span < 1e-200) span = 1;
  // A tenth of the smallest step that could do, then upwards: 1, 2, 5, 10 ... the first that fits is the narrowest.
  int exponent = static_cast<int>(std::floor(std::log10(span / static_cast<double>(most_bins)))) - 1;
  for (;; ++exponent) {
    for (const int digit : {1, 2, 5}) {
      const double step = decimal(1, digit, exponent);
      if (step * static_cast<double>(most_bins) < span * (1 - 1e-9)) continue;
      BinEdges edges{static_cast<std::int64_t>(std::floor(least / step)), digit, exponent, 1};
      // The quotients are rounded: the edges themselves decide.
      if (edges.edge(0) > least) --edges.first;
      if (edges.edge(1) <= least) ++edges.first;
      while (edges.edge(edges.bins) < most && edges.bins <= most_bins) ++edges.bins;
      if (edges.bins <= most_bins) return edges;
    }
  }
}

void Histogram::add(double x, std::uint64_t count) {
  TALUS_PROMISE(std::isfinite(x), "only finite numbers have a bin");
  const double low = edges_.edge(0), high = edges_.edge(edges_.bins);
  if (x < low) {
    underflow_ += count;
  } else if (x > high) {
    overflow_ += count;
  } else {
    const double place = (x - low) / (high - low) * static_cast<double>(edges_.bins);
    std::uint64_t bin = std::min(static_cast<std::uint64_t>(place), edges_.bins - 1);
    // The quotient is rounded: the edges themselves decide.
    if (x < edges_.edge(bin)) --bin;
    if (bin + 1 < edges_.bins && x >= edges_.edge(bin + 1)) ++bin;
    counts_[bin] += count;
  }
}

void Histogram::merge(const Histogram& other) {
  TALUS_PROMISE(edges_ == other.edges_, "only histograms with the same bins can be added");
  for (std::size_t i = 0; i < counts_.size(); ++i) counts_[i] += other.counts_[i];
  underflow_ += other.underflow_;
  overflow_ += other.overflow_;
}

std::uint64_t Histogram::total() const {
  return std::accumulate(counts_.begin(), counts_.end(), underflow_ + overflow_);
}

}  // namespace talus
