#include "talus/statistics/proper_scores.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "talus/core/check.hpp"

namespace talus {

namespace {

/// Weights that add up to 1.
std::vector<double> normalized(std::span<const double> weights, std::size_t count) {
  TALUS_PROMISE(count > 0 && (weights.empty() || weights.size() == count), "a sample has values, and a weight each");
  if (weights.empty()) return std::vector<double>(count, 1.0 / static_cast<double>(count));
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  TALUS_PROMISE(std::isfinite(sum) && sum > 0, "weights must not all be zero");
  std::vector<double> result(weights.begin(), weights.end());
  for (double& weight : result) weight /= sum;
  return result;
}

double sum_of_squares(std::span<const double> weights) {
  return std::inner_product(weights.begin(), weights.end(), weights.begin(), 0.0);
}

/// From the mean over all pairs to the mean over pairs of different members.
double spread_as(double spread, double squared_weights, SpreadOf of) {
  return of == SpreadOf::sample ? spread : spread / (1 - squared_weights);
}

/// Calls use(F, G, length) for each stretch between neighbouring values of either sample, from the lowest to the
/// highest; F and G are constant on it.
template <class Use>
void for_each_stretch(const LineSample& a, const LineSample& b, Use&& use) {
  const std::span<const double> x = a.values(), y = b.values();
  std::size_t i = 0, j = 0;  // numbers of values passed
  double place = std::min(x[0], y[0]);
  while (i < x.size() || j < y.size()) {
    const double next = j == y.size() || (i < x.size() && x[i] <= y[j]) ? x[i] : y[j];
    if (next > place) {
      use(i > 0 ? a.share_up_to(i - 1) : 0.0, j > 0 ? b.share_up_to(j - 1) : 0.0, next - place);
      place = next;
    }
    while (i < x.size() && x[i] == next) ++i;
    while (j < y.size() && y[j] == next) ++j;
  }
}

}  // namespace

LineSample::LineSample(std::span<const double> values, std::span<const double> weights) {
  const std::vector<double> shares = normalized(weights, values.size());
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t number) { return values[number]; });
  double sum = 0;
  for (const std::size_t number : order) {
    TALUS_PROMISE(std::isfinite(values[number]), "a sample has finite values");
    values_.push_back(values[number]);
    // Of equal weights exact, so that samples that are equally far apart compare as equal.
    sum = weights.empty() ? static_cast<double>(values_.size()) / static_cast<double>(values.size())
                          : sum + shares[number];
    shares_.push_back(std::min(1.0, sum));
  }
  shares_.back() = 1;
  squared_weights_ = sum_of_squares(shares);

  const std::size_t count = values_.size();
  below_.assign(count, 0.0);
  above_.assign(count, 0.0);
  for (std::size_t i = 1; i < count; ++i) {
    below_[i] = below_[i - 1] + shares_[i - 1] * shares_[i - 1] * (values_[i] - values_[i - 1]);
  }
  for (std::size_t i = count - 1; i > 0; --i) {
    const double rest = 1 - shares_[i - 1];
    above_[i - 1] = above_[i] + rest * rest * (values_[i] - values_[i - 1]);
  }
}

double LineSample::share_up_to_value(double value) const {
  const auto after = std::ranges::upper_bound(values_, value);
  return after == values_.begin() ? 0.0 : shares_[static_cast<std::size_t>(after - values_.begin()) - 1];
}

double LineSample::spread(SpreadOf of) const {
  // E|X - X'| is twice the integral of F (1 - F).
  double integral = 0;
  for (std::size_t i = 0; i + 1 < values_.size(); ++i) {
    integral += shares_[i] * (1 - shares_[i]) * (values_[i + 1] - values_[i]);
  }
  return spread_as(2 * integral, squared_weights_, of);
}

double crps(const LineSample& sample, double observed, SpreadOf spread) {
  // The integral of F^2 below the observed value and of (1 - F)^2 above it: no difference of large numbers.
  const std::vector<double>& values = sample.values_;
  const auto after = static_cast<std::size_t>(std::ranges::upper_bound(values, observed) - values.begin());
  double score = 0;
  if (after > 0) {
    const double share = sample.shares_[after - 1];
    score += sample.below_[after - 1] + share * share * (observed - values[after - 1]);
  }
  if (after < values.size()) {
    const double rest = after > 0 ? 1 - sample.shares_[after - 1] : 1.0;
    score += sample.above_[after] + rest * rest * (values[after] - observed);
  }
  return spread == SpreadOf::sample ? score : score - 0.5 * (sample.spread(spread) - sample.spread());
}

double energy_distance(const LineSample& a, const LineSample& b) {
  double integral = 0;
  for_each_stretch(a, b, [&](double f, double g, double length) { integral += (f - g) * (f - g) * length; });
  return 2 * integral;
}

double kolmogorov_smirnov(const LineSample& a, const LineSample& b) {
  double maximum = 0;
  for_each_stretch(a, b, [&](double f, double g, double) { maximum = std::max(maximum, std::abs(f - g)); });
  return maximum;
}

PlaneSample::PlaneSample(std::vector<Vec2> points, std::span<const double> weights)
    : points_(std::move(points)), weights_(normalized(weights, points_.size())) {
  squared_weights_ = sum_of_squares(weights_);
  for (std::size_t i = 1; i < points_.size(); ++i) {
    double sum = 0;
    for (std::size_t j = 0; j < i; ++j) sum += weights_[j] * (points_[i] - points_[j]).norm();
    spread_ += 2 * weights_[i] * sum;
  }
}

double PlaneSample::spread(SpreadOf of) const { return spread_as(spread_, squared_weights_, of); }

double PlaneSample::mean_distance(const Vec2& point) const {
  double sum = 0;
  for (std::size_t i = 0; i < points_.size(); ++i) sum += weights_[i] * (points_[i] - point).norm();
  return sum;
}

double energy_score(const PlaneSample& sample, const Vec2& observed, SpreadOf spread) {
  return sample.mean_distance(observed) - 0.5 * sample.spread(spread);
}

double energy_distance(const PlaneSample& a, const PlaneSample& b) {
  double between = 0;
  for (std::size_t i = 0; i < b.points().size(); ++i) between += b.weights()[i] * a.mean_distance(b.points()[i]);
  return 2 * between - a.spread() - b.spread();
}

}  // namespace talus
