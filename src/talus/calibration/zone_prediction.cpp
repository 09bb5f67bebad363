#include "talus/calibration/zone_prediction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "talus/calibration/svg.hpp"
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

std::string zones_as_html(const PreparedStudy& study, std::size_t g, const CalibrationResult& result,
                          std::span<const double> posterior, std::span<const double> prior) {
  const ObservedGroup& group = study.groups()[g];
  const std::uint64_t seed = study.study().seed;
  const auto after = predicted_shares(group, g, result.sets, posterior, seed);
  const auto before = predicted_shares(group, g, result.sets, prior, seed);
  const Eigen::VectorXd observed = zone_shares(group.zones, group.sample);
  const std::string unit = group.zones.unit();
  std::string html = fmt::format(
      "<table><tr><th>{}, {}</th><th>observed{}</th><th>share observed [%]</th><th>predicted [%]: median (5 to 95)</th>"
      "<th>prior [%]: median (5 to 95)</th></tr>\n",
      escaped(study.study().sites[group.site].name), escaped(group.name),
      unit.empty() ? "" : fmt::format(" [{}]", unit == "m3" ? "m\u00b3" : unit));
  const auto text_of = [](const PredictedShare& share) {
    return fmt::format("{:.1f} ({:.1f} to {:.1f})", 100 * share.p50, 100 * share.p05, 100 * share.p95);
  };
  double highest = observed.maxCoeff();
  for (const PredictedShare& share : after) highest = std::max(highest, share.p95);
  Plot plot(480, 250, {0, static_cast<double>(after.size()) + 1, "zone, in the order of the table"},
            {0, highest * 1.05, "share"});
  for (std::size_t k = 0; k < after.size(); ++k) {
    const double share = observed[static_cast<Index>(k)];
    const double amount =
        k < group.zones.list.size() ? group.zones.list[k].amount : group.zones.released.value_or(0) - group.zones.total;
    html += fmt::format("<tr><td>{}</td><td>{:.4g}</td><td>{:.1f}</td><td>{}</td><td>{}</td></tr>\n",
                        escaped(group.zones.name_of(k)), std::max(amount, 0.0), 100 * share, text_of(after[k]),
                        text_of(before[k]));
    const auto x = static_cast<double>(k) + 1;
    plot.bar(x - 0.3, x + 0.3, share, "prior");
    plot.line({{x, after[k].p05}, {x, after[k].p95}}, "median");
    plot.dot(x, after[k].p50, 3, "set");
  }
  html += "</table>\n<p>";
  if (group.zones.released && group.zones.amount != ZoneAmount::share) {
    html += fmt::format("The zones hold {:.4g} of the {:.4g} {} that were released ({:.0f} %). ", group.zones.total,
                        *group.zones.released, unit == "m3" ? "m\u00b3" : unit,
                        100 * group.zones.total / *group.zones.released);
  } else if (!group.zones.has_elsewhere) {
    html += "Shares are of what the zones hold: what came to rest outside was not observed. ";
  }
  html += fmt::format(
      "The observation counts as {:.3g} independent rocks. Energy distance of the best set {:.3g}; chance alone gives "
      "up to {:.3g}.</p>\n",
      effective_rocks(group.zones, group.sample), result.sets[result.best].distances[g], result.thresholds[g]);
  return html + fmt::format(
                    "<figure>{}<figcaption>Grey: observed. Blue: the posterior's prediction, median and 90 % "
                    "of as many rocks as were observed.</figcaption></figure>\n",
                    plot.text());
}

}  // namespace talus::calibration
