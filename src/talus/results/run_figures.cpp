#include "talus/results/run_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/special_functions/beta.hpp>
#include <cmath>

namespace talus {

namespace {

/// "50th", "95th", "99.5th"; of these percentiles only 1, 2, 3, 21 ... are irregular.
std::string ordinal(double percentile) {
  const bool is_whole = percentile == std::floor(percentile);
  const auto whole = static_cast<int>(percentile);
  const bool is_teen = whole / 10 == 1;
  const int last = is_whole && !is_teen ? whole % 10 : 0;
  return fmt::format("{}{}", percentile, last == 1 ? "st" : last == 2 ? "nd" : last == 3 ? "rd" : "th");
}

std::array<QuantileSketch, 3> three_of(std::uint64_t planned) {
  return {QuantileSketch(planned), QuantileSketch(planned), QuantileSketch(planned)};
}

}  // namespace

std::string RunFigure::text() const {
  const std::string_view meaning = quantity_of(of).meaning;
  if (of == FigureOf::share) return std::string(meaning);
  return fmt::format("{} percentile of the {}", ordinal(percentile), meaning);
}

std::vector<RunFigure> usual_figures(std::size_t lines) {
  std::vector<RunFigure> figures{
      {FigureOf::runout, 50}, {FigureOf::runout, 95}, {FigureOf::max_energy, 95}, {FigureOf::max_bounce, 95}};
  for (std::size_t line = 0; line < lines; ++line) {
    for (const FigureOf of : {FigureOf::share, FigureOf::energy, FigureOf::velocity, FigureOf::height})
      figures.push_back({of, 95, line});
  }
  return figures;
}

FigureTally::FigureTally(std::size_t lines, std::uint64_t planned_rocks)
    : of_rocks_(three_of(planned_rocks)), at_lines_(lines, three_of(planned_rocks)) {}

void FigureTally::add(const RockValues& rock) {
  of_rocks_[0].add(rock.runout);
  of_rocks_[1].add(rock.max_energy);
  of_rocks_[2].add(rock.max_bounce);
}

void FigureTally::add(std::size_t line, const ArrivalValues& arrival) {
  at_lines_[line][0].add(arrival.energy);
  at_lines_[line][1].add(arrival.velocity);
  at_lines_[line][2].add(arrival.height);
}

const QuantileSketch& FigureTally::sketch(const RunFigure& figure) const {
  switch (figure.of) {
    case FigureOf::runout:
      return of_rocks_[0];
    case FigureOf::max_energy:
      return of_rocks_[1];
    case FigureOf::max_bounce:
      return of_rocks_[2];
    case FigureOf::share:  // its count alone
    case FigureOf::energy:
      return at_lines_[figure.line][0];
    case FigureOf::velocity:
      return at_lines_[figure.line][1];
    case FigureOf::height:
      break;
  }
  return at_lines_[figure.line][2];
}

std::uint64_t FigureTally::count(const RunFigure& figure) const {
  return figure.of == FigureOf::share ? rocks() : sketch(figure).count();
}

std::optional<Estimate> FigureTally::estimate(const RunFigure& figure, double confidence,
                                              std::optional<std::uint64_t> rocks) const {
  const QuantileSketch& values = sketch(figure);
  if (figure.of == FigureOf::share) {
    const std::uint64_t of = rocks.value_or(this->rocks()), hits = values.count();
    if (of == 0) return std::nullopt;
    const ShareBounds bounds = share_bounds(hits, of, confidence);
    return Estimate{static_cast<double>(hits) / static_cast<double>(of), bounds.low, bounds.high};
  }
  if (values.count() == 0) return std::nullopt;
  return RankedValues(values).estimate(figure.percentile / 100, confidence);
}

std::optional<double> FigureTally::value(const RunFigure& figure) const {
  if (figure.of == FigureOf::share && rocks() > 0)
    return static_cast<double>(sketch(figure).count()) / static_cast<double>(rocks());
  return figure.of == FigureOf::share ? std::nullopt : sketch(figure).quantile(figure.percentile / 100);
}

std::optional<double> FigureTally::sampling_variance(const RunFigure& figure) const {
  const QuantileSketch& values = sketch(figure);
  const auto n = static_cast<double>(count(figure));
  if (n < 2) return std::nullopt;
  if (figure.of == FigureOf::share) {
    const double share = static_cast<double>(values.count()) / n;
    return share * (1 - share) / (n - 1);
  }
  const double p = figure.percentile / 100, a = (n + 1) * p, b = (n + 1) * (1 - p);
  const auto ascending = values.ascending();
  if (p <= 0 || p >= 1) return std::nullopt;
  double up_to = 0, below = 0, mean = 0, square = 0;
  const double origin = ascending.front().value;
  for (const QuantileSketch::Counted& each : ascending) {
    up_to += static_cast<double>(each.count);
    const double share = boost::math::ibeta(a, b, std::min(1.0, up_to / n)), weight = share - below;
    below = share;
    mean += weight * (each.value - origin);
    square += weight * (each.value - origin) * (each.value - origin);
  }
  return std::max(0.0, square - mean * mean);
}

std::optional<std::uint64_t> rocks_needed(const RunFigure& figure, const Estimate& estimate, std::uint64_t rocks,
                                          std::uint64_t values, double confidence, double tolerance) {
  if (rocks == 0 || values == 0 || !(estimate.value > 0)) return std::nullopt;
  constexpr double most = 1e15;
  const auto n = static_cast<double>(rocks);
  double needed = 0;
  for (const auto& end : {estimate.low, estimate.high}) {
    if (!end) continue;
    const double reach = std::abs(*end - estimate.value) / (tolerance * estimate.value);
    needed = std::max(needed, n * reach * reach);
  }
  if (figure.of != FigureOf::share && (!estimate.low || !estimate.high)) {
    const double p = figure.percentile / 100, rarer = std::max(p, 1 - p);
    const double both_ends = std::log((1 - confidence) / 2) / std::log(rarer);
    needed = std::max(needed, both_ends * n / static_cast<double>(values));
  }
  if (!(needed < most)) return std::nullopt;
  return static_cast<std::uint64_t>(std::ceil(std::max(needed, 1.0)));
}

}  // namespace talus
