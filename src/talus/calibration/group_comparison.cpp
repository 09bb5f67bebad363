#include "talus/calibration/group_comparison.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "talus/core/random.hpp"

namespace talus::calibration {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double share_by_chance = 0.95;
constexpr double normal_quantile = 1.644854;  // of share_by_chance
constexpr std::size_t fewest_rocks = 5;       // of which a distribution can be estimated
constexpr auto zone_resampling = static_cast<Stream>(1210);
/// Without a single value, the distance is that of a distribution infinitely far away: a large number.
constexpr double nothing_arrives = 1e3;

double zone_distance(const VectorXd& a, const VectorXd& b) { return (a - b).squaredNorm(); }

}  // namespace

GroupComparison::GroupComparison(const ObservedGroup& group, std::uint64_t seed) : group_(group), seed_(seed) {
  if (group.kind == ObservationKind::zones) {
    shares_ = zone_shares(group.zones, group.sample);
    chance_ = chance_of_zones();
    return;
  }
  rows_.emplace(group.sample.rows, group.kind != ObservationKind::values);
  if (!group.sample.has_strata()) chance_ = rows_->distance_by_chance(share_by_chance, seed, group.sample.first_rows());
}

Compared GroupComparison::compare(const Sample& simulated) const {
  Compared compared{density(simulated, group_.sample), distance(simulated), chance_};
  if (group_.sample.has_strata()) compared.chance = chance_of_releases(simulated);
  return compared;
}

LogDensity GroupComparison::density(const Sample& simulated, const Sample& observed) const {
  const LogDensity impossible{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  if (group_.kind == ObservationKind::zones) {
    if (simulated.rows.rows() < static_cast<Index>(fewest_rocks)) return impossible;
    return share_log_density(zone_shares(group_.zones, observed), effective_rocks(group_.zones, observed),
                             zone_shares(group_.zones, simulated), effective_rocks(simulated));
  }
  if (!Redraw(simulated, observed).has_at_least(fewest_rocks)) return impossible;
  if (observed.has_strata()) return matched_log_density(simulated, observed, group_.features, seed_);
  return log_density(summaries_of(observed.rows), expected_summaries(simulated, observed, group_.features, seed_));
}

double GroupComparison::distance(const Sample& simulated) const {
  if (simulated.rows.rows() == 0) return nothing_arrives;
  if (group_.kind == ObservationKind::zones) return zone_distance(zone_shares(group_.zones, simulated), shares_);
  return group_.sample.has_strata() ? score(simulated, group_.sample) : rows_->distance(simulated.rows);
}

double GroupComparison::score(const Sample& forecast, const Sample& observed) const {
  if (forecast.rows.rows() == 0) return nothing_arrives;
  if (group_.kind == ObservationKind::zones) {
    const VectorXd predicted = zone_shares(group_.zones, forecast), shares = zone_shares(group_.zones, observed);
    return 1 - shares.dot(predicted) - (1 - predicted.squaredNorm()) / 2;
  }
  if (!observed.has_strata() || !forecast.has_strata()) return rows_->score(forecast.rows, observed.rows);
  double sum = 0;
  for (std::uint32_t release = 0; release < observed.stratum_count(); ++release) {
    const Sample here = observed.stratum(release);
    if (here.rows.rows() == 0) continue;
    const Sample own = forecast.stratum(release);
    sum += static_cast<double>(here.rows.rows()) *
           (own.rows.rows() == 0 ? nothing_arrives : rows_->score(own.rows, here.rows));
  }
  return sum / static_cast<double>(observed.rows.rows());
}

std::size_t GroupComparison::summary_count() const {
  if (group_.kind == ObservationKind::zones) return group_.zones.category_count() - 1;
  if (group_.sample.has_strata()) return matched_summary_count(group_.sample);
  return static_cast<std::size_t>(summaries_of(group_.sample.rows).size());
}

double GroupComparison::chance_of_releases(const Sample& simulated) const {
  double mean = 0, variance = 0;
  for (std::uint32_t release = 0; release < group_.sample.stratum_count(); ++release) {
    const auto count = static_cast<double>(group_.sample.stratum(release).rows.rows());
    const Sample own = simulated.stratum(release);
    if (count == 0 || own.rows.rows() < 2) continue;
    const OwnScores scores = rows_->own_scores(own.rows);
    mean += count * scores.mean;
    variance += count * scores.variance;
  }
  const auto n = static_cast<double>(group_.sample.rows.rows());
  return mean / n + normal_quantile * std::sqrt(variance) / n;
}

double GroupComparison::chance_of_zones() const {
  constexpr int resamples = 400;
  constexpr double most_rocks = 2000;  // of more, distances are in proportion to 1 / n
  const double rocks = effective_rocks(group_.zones, group_.sample);
  const double drawn = std::clamp(std::round(rocks), 1.0, most_rocks);
  std::vector<double> distances;
  for (int k = 0; k < resamples; ++k) {
    VectorXd resample = VectorXd::Zero(shares_.size());
    for (std::uint32_t rock = 0; rock < static_cast<std::uint32_t>(drawn); ++rock) {
      double left = uniform_pair(seed_, static_cast<std::uint64_t>(k), zone_resampling, rock)[0];
      Index zone = 0;
      while (zone + 1 < shares_.size() && left >= shares_[zone]) left -= shares_[zone++];
      resample[zone] += 1 / drawn;
    }
    distances.push_back(zone_distance(resample, shares_) * std::max(drawn / rocks, 0.0));
  }
  std::ranges::sort(distances);
  return distances[static_cast<std::size_t>(share_by_chance * (resamples - 1))];
}

}  // namespace talus::calibration
