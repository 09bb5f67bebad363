#include "talus/verification/sampling_spread.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "talus/core/check.hpp"
#include "talus/core/random.hpp"
#include "talus/statistics/binomial.hpp"
#include "talus/statistics/quantile.hpp"

namespace talus::verification {
namespace {

constexpr std::array<std::string_view, statistic_count> names{"mean",
                                                              "standard_error",
                                                              "median",
                                                              "standard_deviation",
                                                              "sample_variance",
                                                              "kurtosis",
                                                              "skewness",
                                                              "range",
                                                              "minimum",
                                                              "maximum",
                                                              "sum",
                                                              "count",
                                                              "confidence_level_95"};

/// A number in 0 ... count-1 from 32 random bits, by the upper half of their product. The bias of count/2^32 is far too
/// small to be seen in the samples.
std::size_t scaled(std::uint32_t bits, std::size_t count) {
  return static_cast<std::size_t>((static_cast<std::uint64_t>(bits) * count) >> 32u);
}

double quantile(const std::vector<double>& ascending, double p) {
  const QuantilePlace place = quantile_place(p, ascending.size());
  const double low = ascending[place.rank];
  return place.fraction == 0 ? low : between(low, ascending[place.rank + 1], place.fraction);
}

}  // namespace

std::string_view name(Statistic statistic) { return names[static_cast<std::size_t>(statistic)]; }

std::optional<Statistic> statistic_of(std::string_view text) {
  const auto found = std::ranges::find(names, text);
  if (found == names.end()) return std::nullopt;
  return static_cast<Statistic>(found - names.begin());
}

std::optional<double> value(const Descriptive& rows, Statistic statistic) {
  switch (statistic) {
    case Statistic::mean:
      return rows.mean;
    case Statistic::standard_error:
      return rows.standard_error;
    case Statistic::median:
      return rows.median;
    case Statistic::standard_deviation:
      return rows.standard_deviation;
    case Statistic::sample_variance:
      return rows.sample_variance;
    case Statistic::kurtosis:
      return rows.kurtosis;
    case Statistic::skewness:
      return rows.skewness;
    case Statistic::range:
      return rows.range;
    case Statistic::minimum:
      return rows.minimum;
    case Statistic::maximum:
      return rows.maximum;
    case Statistic::sum:
      return rows.sum;
    case Statistic::count:
      return static_cast<double>(rows.count);
    case Statistic::confidence_level_95:
      return rows.confidence_half_width_95;
  }
  return std::nullopt;
}

SamplingSpread::SamplingSpread(std::span<const double> many, std::uint64_t size, const SpreadOptions& options)
    : options_(options) {
  TALUS_PROMISE(!many.empty() && many.size() < (std::uint64_t{1} << 32u), "there are values to draw from");
  std::vector<Descriptive> rows(options.samples);
  tbb::parallel_for(std::uint64_t{0}, options.samples, [&](std::uint64_t k) {
    std::vector<double> sample(size);
    for (std::uint64_t i = 0; i < size; i += 4) {
      const auto words = philox(options.seed, k, static_cast<std::uint32_t>(i), 0);
      for (std::uint64_t j = 0; j < 4 && i + j < size; ++j) sample[i + j] = many[scaled(words[j], many.size())];
    }
    rows[k] = describe(sample);
  });
  for (int s = 0; s < statistic_count; ++s) {
    std::vector<double>& values = values_[static_cast<std::size_t>(s)];
    for (const Descriptive& row : rows) {
      if (const auto x = value(row, static_cast<Statistic>(s))) values.push_back(*x);
    }
    std::ranges::sort(values);
  }
}

const std::vector<double>* SamplingSpread::values_if_enough(Statistic statistic) const {
  const std::vector<double>& values = values_[static_cast<std::size_t>(statistic)];
  return values.empty() || values.size() < options_.samples / 2 ? nullptr : &values;
}

std::optional<Interval> SamplingSpread::interval(Statistic statistic) const {
  const std::vector<double>* values = values_if_enough(statistic);
  if (values == nullptr) return std::nullopt;
  const double tail = (1 - options_.central) / 2;
  return Interval{quantile(*values, tail), quantile(*values, 1 - tail)};
}

std::optional<double> SamplingSpread::typical(Statistic statistic) const {
  const std::vector<double>* values = values_if_enough(statistic);
  return values == nullptr ? std::nullopt : std::optional(quantile(*values, 0.5));
}

Interval binomial_interval(std::uint64_t trials, double probability, double central) {
  const auto [low, high] = central_counts(trials, probability, central);
  return {low, high};
}

}  // namespace talus::verification
