#include "talus/calibration/zone_prediction.hpp"

#include <algorithm>
#include <cmath>

#include "talus/core/random.hpp"

namespace talus::calibration {

namespace {

using Eigen::Index;

constexpr auto share_prediction = static_cast<Stream>(1410);

}  // namespace

std::vector<PredictedShare> predicted_shares(const ObservedGroup& group, std::size_t g,
                                             const std::vector<SetResult>& sets, std::span<const double> weights,
                                             std::uint64_t seed) {
  constexpr std::size_t replicas = 1000;
  constexpr double most_rocks = 2000;
  const std::size_t categories = group.zones.category_count();
  const auto rocks =
      static_cast<std::uint32_t>(std::clamp(std::round(effective_rocks(group.zones, group.sample)), 1.0, most_rocks));
  std::vector<double> cumulated;
  double sum = 0;
  for (std::size_t k = 0; k < sets.size(); ++k)
    cumulated.push_back(sum += sets[k].samples[g].rows.rows() > 0 ? weights[k] : 0);
  std::vector<PredictedShare> predicted(categories);
  if (!(sum > 0)) return predicted;
  std::vector<std::vector<double>> drawn(categories);
  for (std::uint64_t r = 0; r < replicas; ++r) {
    const double pick = uniform_pair(seed, r, share_prediction, 0)[0] * sum;
    const auto set = static_cast<std::size_t>(std::ranges::upper_bound(cumulated, pick) - cumulated.begin());
    const Eigen::VectorXd shares = zone_shares(group.zones, sets[std::min(set, sets.size() - 1)].samples[g]);
    std::vector<double> counts(categories, 0);
    for (std::uint32_t rock = 0; rock < rocks; ++rock) {
      double left = uniform_pair(seed, r, share_prediction, rock + 1)[0];
      std::size_t zone = 0;
      while (zone + 1 < categories && left >= shares[static_cast<Index>(zone)])
        left -= shares[static_cast<Index>(zone++)];
      counts[zone] += 1.0 / rocks;
    }
    for (std::size_t k = 0; k < categories; ++k) drawn[k].push_back(counts[k]);
  }
  for (std::size_t k = 0; k < categories; ++k) {
    std::ranges::sort(drawn[k]);
    const auto at = [&](double q) { return drawn[k][static_cast<std::size_t>(q * (replicas - 1))]; };
    predicted[k] = {at(0.05), at(0.5), at(0.95)};
  }
  return predicted;
}

}  // namespace talus::calibration
