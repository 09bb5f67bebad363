#include "talus/statistics/histogram.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "talus/core/check.hpp"

namespace talus {

namespace {

// The double nearest to `steps` x digit x 10^exponent while the powers of ten are exact, up to 10^22; 1 ulp beyond.
double decimal(std::int64_t steps, int digit, int exponent) {
  const auto number = static_cast<double>(steps * digit);
  return exponent < 0 ? number / std::pow(10.0, -exponent) : number * std::pow(10.0, exponent);
}

struct Step {
  int digit, exponent;
};

Step step_of(const BinEdges& edges) { return {edges.step_digit, edges.step_exponent}; }
bool is_less(const Step& a, const Step& b) {
  return a.exponent != b.exponent ? a.exponent < b.exponent : a.digit < b.digit;
}
Step next_wider(const Step& step) {
  return step.digit == 5 ? Step{1, step.exponent + 1} : Step{step.digit == 1 ? 2 : 5, step.exponent};
}

/// How many narrow steps make a wide one; nullopt if no whole number of them does, and the largest integer if they are
/// too many.
std::optional<std::int64_t> times(const Step& wide, const Step& narrow) {
  constexpr int most_exponent = 17;
  const int exponent = wide.exponent - narrow.exponent;
  if (exponent < 0) return std::nullopt;
  if (exponent > most_exponent) return std::numeric_limits<std::int64_t>::max();
  std::int64_t steps = wide.digit;
  for (int k = 0; k < exponent; ++k) steps *= 10;
  if (steps % narrow.digit != 0) return std::nullopt;
  return steps / narrow.digit;
}

std::int64_t floor_divided(std::int64_t a, std::int64_t b) { return a / b - (a % b < 0 ? 1 : 0); }
std::int64_t ceil_divided(std::int64_t a, std::int64_t b) { return a / b + (a % b > 0 ? 1 : 0); }

}  // namespace

double BinEdges::edge(std::uint64_t i) const {
  return decimal(first + static_cast<std::int64_t>(i), step_digit, step_exponent);
}

BinEdges nice_bins(double least, double most, std::uint64_t most_bins) {
  TALUS_PROMISE(std::isfinite(least) && std::isfinite(most) && least <= most, "a range needs two finite ends in order");
  TALUS_PROMISE(std::abs(least) < 1e100 && std::abs(most) < 1e100, "a step must be a readable number");
  TALUS_PROMISE(most_bins >= 2 && most_bins <= 1000, "a step that fits exists for 2 bins or more");
  const double magnitude = std::max(std::abs(least), std::abs(most));
  // A step of at least 1e-12 of the magnitude keeps the edges distinct, and their numbers of steps exact in a double.
  double span = std::max(most - least, magnitude * 1e-12 * static_cast<double>(most_bins));
  if (span < 1e-200) span = 1;
  // From a tenth of the smallest possible step upwards: 1, 2, 5, 10 ... The first that fits is the narrowest.
  int exponent = static_cast<int>(std::floor(std::log10(span / static_cast<double>(most_bins)))) - 1;
  for (;; ++exponent) {
    for (const int digit : {1, 2, 5}) {
      const double step = decimal(1, digit, exponent);
      if (step * static_cast<double>(most_bins) < span * (1 - 1e-9)) continue;
      BinEdges edges{static_cast<std::int64_t>(std::floor(least / step)), digit, exponent, 1};
      // The quotients are rounded: compare with the edges themselves.
      if (edges.edge(0) > least) --edges.first;
      if (edges.edge(1) <= least) ++edges.first;
      while (edges.edge(edges.bins) < most && edges.bins <= most_bins) ++edges.bins;
      if (edges.bins <= most_bins) return edges;
    }
  }
}

BinEdges common_bins(const BinEdges& a, const BinEdges& b, std::uint64_t most_bins) {
  TALUS_PROMISE(most_bins >= 2, "values on both sides of zero need two bins, however wide");
  const auto last = [](const BinEdges& edges) { return edges.first + static_cast<std::int64_t>(edges.bins); };
  for (Step step = is_less(step_of(a), step_of(b)) ? step_of(b) : step_of(a);; step = next_wider(step)) {
    const auto of_a = times(step, step_of(a)), of_b = times(step, step_of(b));
    if (!of_a || !of_b) continue;
    const std::int64_t from = std::min(floor_divided(a.first, *of_a), floor_divided(b.first, *of_b));
    const std::int64_t to = std::max(ceil_divided(last(a), *of_a), ceil_divided(last(b), *of_b));
    const auto bins = static_cast<std::uint64_t>(to) - static_cast<std::uint64_t>(from);
    if (bins <= most_bins) return {from, step.digit, step.exponent, bins};
  }
}

std::optional<BinEdges> bins_from(double low, double width, std::uint64_t bins) {
  constexpr double rounding = 1e-3;  // a width is the difference of edges up to 1e12 times as large
  if (!(width > 0) || !std::isfinite(width) || !std::isfinite(low) || bins == 0) return std::nullopt;
  const int exponent = static_cast<int>(std::floor(std::log10(width * (1 + rounding))));
  for (const int digit : {1, 2, 5}) {
    const double step = decimal(1, digit, exponent);
    const double first = std::round(low / step);
    if (std::abs(width / step - 1) > rounding || std::abs(first) > 9e15) continue;
    return BinEdges{static_cast<std::int64_t>(first), digit, exponent, bins};
  }
  return std::nullopt;
}

Histogram Histogram::regrouped(const BinEdges& wider) const {
  const auto each = times(step_of(wider), step_of(edges_));
  TALUS_PROMISE(each.has_value(), "a wider bin must be made of whole bins");
  Histogram out(wider);
  for (std::uint64_t k = 0; k < edges_.bins; ++k) {
    const std::int64_t at = floor_divided(edges_.first + static_cast<std::int64_t>(k), *each) - wider.first;
    out.add_to(static_cast<std::uint64_t>(at), counts_[k]);
  }
  out.underflow_ = underflow_;
  out.overflow_ = overflow_;
  return out;
}

void Histogram::add(double x, std::uint64_t count) {
  TALUS_PROMISE(std::isfinite(x), "only finite numbers can be counted");
  const double low = edges_.edge(0), high = edges_.edge(edges_.bins);
  if (x < low) {
    underflow_ += count;
  } else if (x > high) {
    overflow_ += count;
  } else {
    const double place = (x - low) / (high - low) * static_cast<double>(edges_.bins);
    std::uint64_t bin = std::min(static_cast<std::uint64_t>(place), edges_.bins - 1);
    // The quotient is rounded: compare with the edges themselves.
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
