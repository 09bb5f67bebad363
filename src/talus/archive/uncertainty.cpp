#include "talus/archive/uncertainty.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "talus/results/ensemble.hpp"
#include "talus/statistics/quantile.hpp"

namespace talus {

namespace {

/// The number of a figure's quantity among runout, energy and bounce height, and at each line energy, velocity and
/// height.
std::size_t quantity_number(const RunFigure& figure) {
  switch (figure.of) {
    case FigureOf::runout:
      return 0;
    case FigureOf::max_energy:
      return 1;
    case FigureOf::max_bounce:
      return 2;
    case FigureOf::share:  // those that have an energy
    case FigureOf::energy:
      return 3 + 3 * figure.line;
    case FigureOf::velocity:
      return 4 + 3 * figure.line;
    case FigureOf::height:
      break;
  }
  return 5 + 3 * figure.line;
}

}  // namespace

Estimate range_of(std::vector<double> values, double value, double confidence) {
  std::ranges::sort(values);
  const auto quantile = [&](double p) {
    const QuantilePlace place = quantile_place(p, values.size());
    return between(values[place.rank], values[std::min<std::size_t>(place.rank + 1, values.size() - 1)],
                   place.fraction);
  };
  return {value, quantile((1 - confidence) / 2), quantile((1 + confidence) / 2)};
}

UncertaintyCount::UncertaintyCount(EnsembleRocks run, std::vector<std::string> lines)
    : run_(std::move(run)),
      lines_(std::move(lines)),
      last_rock_(lines_.size()),
      all_(lines_.size(), run_.rocks),
      of_ensemble_(run_.ensembles,
                   FigureTally(lines_.size(), run_.rocks / std::max<std::uint64_t>(run_.ensembles, 1) + 1)) {
  for (std::size_t line = 0; line < lines_.size(); ++line) line_of_.emplace(lines_[line], line);
  const std::uint64_t ensembles = std::max<std::uint64_t>(run_.ensembles, 1);
  for (std::size_t k = 0; k < run_.seeders_begin.size(); ++k) {
    first_places_.push_back(places_);
    const std::uint64_t end = k + 1 < run_.seeders_begin.size() ? run_.seeders_begin[k + 1] : run_.rocks;
    places_ += (end - run_.seeders_begin[k] + ensembles - 1) / ensembles;
  }
  const std::size_t quantities = 3 + 3 * lines_.size();
  constexpr double max_kept = 4e6;  // values of 8 bytes
  const double all = static_cast<double>(places_) * static_cast<double>(ensembles * quantities);
  step_ = static_cast<std::uint64_t>(std::max(1.0, std::ceil(all / max_kept)));
  const std::uint64_t kept = (places_ + step_ - 1) / step_ * ensembles;
  kept_.assign(quantities, std::vector<double>(kept, std::numeric_limits<double>::quiet_NaN()));
}

std::uint64_t UncertaintyCount::place_of(std::uint64_t rock) const {
  const auto after = std::ranges::upper_bound(run_.seeders_begin, rock);
  const auto seeder = static_cast<std::size_t>(after - run_.seeders_begin.begin()) - 1;
  return first_places_[seeder] + (rock - run_.seeders_begin[seeder]) / run_.ensembles;
}

void UncertaintyCount::keep(std::uint64_t rock, std::size_t quantity, std::initializer_list<double> values) {
  if (rock >= run_.rocks) return;
  const std::uint64_t place = place_of(rock);
  if (place % step_ != 0) return;
  const std::size_t at = place / step_ * run_.ensembles + ensemble_of(rock, run_.ensembles);
  for (const double value : values) kept_[quantity++][at] = value;
}

double UncertaintyCount::own_share(const RunFigure& figure) const {
  // What each rock adds to its ensemble's figure, but for a factor: whether it reaches the line; or whether it is below
  // the percentile, less the share that is.
  const std::size_t ensembles = of_ensemble_.size();
  const std::vector<double>& kept = kept_[quantity_number(figure)];
  const double p = figure.percentile / 100;
  std::vector<double> thresholds;
  for (const FigureTally& tally : of_ensemble_) {
    const auto threshold = figure.of == FigureOf::share ? std::optional(0.0) : tally.value(figure);
    if (!threshold) return 1;
    thresholds.push_back(*threshold);
  }
  std::vector<double> rows;  // by place and ensemble
  for (std::size_t first = 0; first + ensembles <= kept.size(); first += ensembles) {
    const std::span<const double> values = std::span(kept).subspan(first, ensembles);
    // The last place of a seeder may not have a rock of each ensemble; nor may a table have all end points.
    if (!figure.is_at_line() && std::ranges::any_of(values, [](double x) { return std::isnan(x); })) continue;
    for (std::size_t k = 0; k < ensembles; ++k) {
      const bool is_there = !std::isnan(values[k]);
      rows.push_back(!is_there ? 0 : figure.of == FigureOf::share ? 1 : (values[k] <= thresholds[k] ? 1 : 0) - p);
    }
  }
  const std::size_t places = rows.size() / ensembles;
  if (places < 2 || ensembles < 2) return 1;
  const auto n = static_cast<double>(places), m = static_cast<double>(ensembles);
  std::vector<double> of_place(places), of_ensemble(ensembles);
  double mean = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    of_place[i / ensembles] += rows[i] / m;
    of_ensemble[i % ensembles] += rows[i] / n;
    mean += rows[i] / (n * m);
  }
  double own = 0, within = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double of_both = rows[i] - of_ensemble[i % ensembles];
    within += of_both * of_both;
    own += (of_both - of_place[i / ensembles] + mean) * (of_both - of_place[i / ensembles] + mean);
  }
  return within > 0 ? std::min(1.0, own / (m - 1) * m / within) : 1;
}

void UncertaintyCount::add_end(std::uint64_t rock, const RockValues& values) {
  keep(rock, 0, {values.runout, values.max_energy, values.max_bounce});
  all_.add(values);
  of_ensemble_[ensemble_of(rock, of_ensemble_.size())].add(values);
}

void UncertaintyCount::add_arrival(std::uint64_t rock, std::string_view line, const ArrivalValues& values) {
  const auto found = line_of_.find(line);
  if (found == line_of_.end() || last_rock_[found->second] == rock) return;
  last_rock_[found->second] = rock;
  keep(rock, 3 + 3 * found->second, {values.energy, values.velocity, values.height});
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
  sampling *= own_share(figure) / n;
  mean /= n;
  double between_ensembles = 0;
  for (const double value : values) between_ensembles += (value - mean) * (value - mean) / (n - 1);

  FigureUncertainty all{.figure = figure,
                        .line = figure.is_at_line() ? lines_[figure.line] : "",
                        .ensembles = values.size(),
                        .total = range_of(values, *whole, Uncertainty::confidence),
                        .parameters = {},
                        .rocks = {}};
  const double of_parameters = run_.parameter_sets < 2 ? 0.0 : std::max(0.0, between_ensembles - sampling);
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
