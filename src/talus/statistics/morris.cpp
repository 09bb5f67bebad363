#include "talus/statistics/morris.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "talus/core/check.hpp"
#include "talus/core/stop.hpp"
#include "talus/statistics/counted_draws.hpp"
#include "talus/statistics/without_rounding.hpp"

namespace talus {

namespace {

using Trajectory = std::vector<std::vector<double>>;

/// Morris (1991), section 3: a random start on the grid, and a random order in which each input is changed by plus or
/// minus delta, whichever stays in the cube.
Trajectory candidate(const MorrisPlan& plan, std::uint64_t number) {
  const CountedDraws draws(plan.seed, CountedDraws::Purpose::trajectories);
  const std::size_t half = plan.levels / 2;
  std::vector<std::size_t> level(plan.inputs), order(plan.inputs);
  std::uint32_t next = 0;
  for (std::size_t& each : level) each = draws.below(plan.levels, number, next++);
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t i = plan.inputs; i > 1; --i) std::swap(order[i - 1], order[draws.below(i, number, next++)]);
  const auto point = [&] {
    std::vector<double> coordinates;
    for (const std::size_t each : level)
      coordinates.push_back(static_cast<double>(each) / static_cast<double>(plan.levels - 1));
    return coordinates;
  };
  Trajectory trajectory{point()};
  for (const std::size_t input : order) {
    level[input] = level[input] < half ? level[input] + half : level[input] - half;
    trajectory.push_back(point());
  }
  return trajectory;
}

/// Campolongo et al. (2007), equation 3: the sum of the distances between all points of both.
double distance(const Trajectory& a, const Trajectory& b) {
  double sum = 0;
  for (const auto& p : a) {
    for (const auto& q : b) {
      double square = 0;
      for (std::size_t i = 0; i < p.size(); ++i) square += (p[i] - q[i]) * (p[i] - q[i]);
      sum += std::sqrt(square);
    }
  }
  return sum;
}

/// The trajectories that are far from each other: the first candidate, then always the one with the largest sum of
/// squared distances to those chosen.
std::vector<std::size_t> far_apart(const std::vector<Trajectory>& candidates, std::size_t count) {
  std::vector<double> spread(candidates.size(), 0.0);
  std::vector<std::size_t> chosen;
  std::vector<bool> is_chosen(candidates.size(), false);
  std::size_t last = 0;
  for (;;) {
    chosen.push_back(last);
    is_chosen[last] = true;
    if (chosen.size() == count) return chosen;
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      if (is_chosen[i]) continue;
      stop_point();
      const double d = distance(candidates[last], candidates[i]);
      spread[i] += d * d;
      if (!best || spread[i] > spread[*best]) best = i;
    }
    last = *best;
  }
}

std::size_t input_changed(const std::vector<double>& before, const std::vector<double>& after) {
  return static_cast<std::size_t>(std::ranges::mismatch(before, after).in1 - before.begin());
}

}  // namespace

MorrisDesign::MorrisDesign(const MorrisPlan& plan) : plan_(plan) {
  TALUS_PROMISE(plan.inputs > 0 && plan.trajectories > 1 && plan.levels > 1 && plan.levels % 2 == 0,
                "a screening needs inputs, two trajectories and an even number of levels");
  constexpr std::size_t most_candidates = 500;
  std::vector<Trajectory> candidates;
  const std::size_t count = std::max(plan.trajectories, std::min(most_candidates, 10 * plan.trajectories));
  for (std::size_t i = 0; i < count; ++i) candidates.push_back(candidate(plan, i));
  for (const std::size_t i : far_apart(candidates, plan.trajectories))
    std::ranges::move(candidates[i], std::back_inserter(points_));
}

std::vector<std::optional<ElementaryEffects>> MorrisDesign::effects(std::span<const std::optional<double>> results,
                                                                    const Bootstrap& bootstrap) const {
  TALUS_PROMISE(results.size() == points_.size(), "one result a point");
  std::vector<std::vector<double>> effects(plan_.inputs);
  for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
    if ((i + 1) % (plan_.inputs + 1) == 0 || !results[i] || !results[i + 1]) continue;
    const std::size_t input = input_changed(points_[i], points_[i + 1]);
    const double change = without_rounding(*results[i + 1] - *results[i], *results[i]);
    effects[input].push_back(change / (points_[i + 1][input] - points_[i][input]));
  }
  std::vector<std::optional<ElementaryEffects>> all;
  for (const std::vector<double>& each : effects) {
    auto& found = all.emplace_back();
    if (each.empty()) continue;
    const auto n = static_cast<double>(each.size());
    const double mean = std::accumulate(each.begin(), each.end(), 0.0) / n;
    double squares = 0;
    for (const double effect : each) squares += (effect - mean) * (effect - mean);
    const auto magnitude = [&](std::span<const std::size_t> rows) {
      double sum = 0;
      for (const std::size_t row : rows) sum += std::abs(each[row]);
      return std::vector<double>{sum / static_cast<double>(rows.size())};
    };
    found = ElementaryEffects{.mean = mean,
                              .magnitude = bootstrap_estimates(each.size(), magnitude, bootstrap).front(),
                              .standard_deviation = each.size() > 1 ? std::sqrt(squares / (n - 1)) : 0.0,
                              .count = each.size()};
  }
  return all;
}

}  // namespace talus
