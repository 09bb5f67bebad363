#include "talus/archive/uncertainty.hpp"

#include <algorithm>
#include <cmath>

#include "talus/results/ensemble.hpp"
#include "talus/statistics/quantile.hpp"

namespace talus {

namespace {

/// The central range of values that has this confidence; sorts them.
Estimate range_of(std::vector<double> values, double value, double confidence) {
  std::ranges::sort(values);
  const auto quantile = [&](double p) {
    const QuantilePlace place = quantile_place(p, values.size());
    return between(values[place.rank], values[std::min<std::size_t>(place.rank + 1, values.size() - 1)],
                   place.fraction);
  };
  return {value, quantile((1 - confidence) / 2), quantile((1 + confidence) / 2)};
}

}  // namespace

UncertaintyCount::UncertaintyCount(std::uint64_t rocks, std::uint64_t ensembles, std::vector<std::string> lines)
    : lines_(std::move(lines)),
      last_rock_(lines_.size()),
      all_(lines_.size(), rocks),
      of_ensemble_(ensembles, FigureTally(lines_.size(), rocks / std::max<std::uint64_t>(ensembles, 1) + 1)) {
  for (std::size_t line = 0; line < lines_.size(); ++line) line_of_.emplace(lines_[line], line);
}

void UncertaintyCount::add_end(std::uint64_t rock, const RockValues& values) {
  all_.add(values);
  of_ensemble_[ensemble_of(rock, of_ensemble_.size())].add(values);
}

void UncertaintyCount::add_arrival(std::uint64_t rock, std::string_view line, const ArrivalValues& values) {
  const auto found = line_of_.find(line);
  if (found == line_of_.end() || last_rock_[found->second] == rock) return;
  last_rock_[found->second] = rock;
  all_.add(found->second, values);
  of_ensemble_[ensemble_of(rock, of_ensemble_.size())].add(found->second, values);
}

std::optional<FigureUncertainty> UncertaintyCount::of(const RunFigure& figure) const {
  const auto whole = all_.value(figure);
  std::vector<double> values;
  double sampling = 0, mean = 0;
  for (const FigureTally& tally : of_ensemble_) {
    const auto value = tally.value(figure);
    const auto variance = tally.sampling_variance(figure);
    if (!value || !variance) continue;
    values.push_back(*value);
    sampling += *variance;
    mean += *value;
  }
  if (!whole || values.size() < Uncertainty::fewest) return std::nullopt;
  const auto n = static_cast<double>(values.size());
  sampling /= n;
  mean /= n;
  double between_ensembles = 0;
  for (const double value : values) between_ensembles += (value - mean) * (value - mean) / (n - 1);

  FigureUncertainty all{.figure = figure,
                        .line = figure.is_at_line() ? lines_[figure.line] : "",
                        .ensembles = values.size(),
                        .total = range_of(values, *whole, Uncertainty::confidence),
                        .parameters = {},
                        .rocks = {}};
  const double of_parameters = std::max(0.0, between_ensembles - sampling);
  all.parameter_share = between_ensembles > 0 ? of_parameters / between_ensembles : 0;
  for (double& value : values) value = mean + std::sqrt(all.parameter_share) * (value - mean);
  all.parameters = range_of(std::move(values), *whole, Uncertainty::confidence);
  constexpr double normal_95 = 1.6448536269514722;  // the 95th percentile of the standard normal distribution
  const double reach = normal_95 * std::sqrt(std::min(sampling, between_ensembles));
  all.rocks = {*whole, *whole - reach, *whole + reach};
  if (figure.of != FigureOf::runout) all.rocks.low = std::max(0.0, *all.rocks.low);  // others are not negative
  if (figure.of == FigureOf::share) all.rocks.high = std::min(1.0, *all.rocks.high);
  return all;
}

Uncertainty UncertaintyCount::result() const {
  Uncertainty all{.ensembles = of_ensemble_.size(), .figures = {}};
  for (const RunFigure& figure : usual_figures(lines_.size())) {
    if (auto each = of(figure)) all.figures.push_back(std::move(*each));
  }
  return all;
}

}  // namespace talus
