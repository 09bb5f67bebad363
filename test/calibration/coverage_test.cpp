// Synthetic observations from known parameters: 90 % intervals of the posterior contain the truth in 90 % of replicas,
// and those of a likelihood that is wrong do not.

#include <gtest/gtest.h>

#include <boost/math/distributions/binomial.hpp>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "calibration/slope.hpp"
#include "talus/calibration/likelihood.hpp"
#include "talus/calibration/sampler.hpp"
#include "talus/core/random.hpp"
#include "talus/project/read.hpp"
#include "talus/study/prepared_site.hpp"

namespace talus::calibration {
namespace {

constexpr std::size_t rocks = 150, observed_rocks = 25, prior_sets = 1500;

const std::vector<std::string> paths{"material.Scree.tangential_restitution", "material.Scree.friction_angle_deg",
                                     "material.Scree.roughness_deg"};
const std::vector<project::Prior> priors{project::Prior::uniform(0.6, 0.9), project::Prior::uniform(20, 40),
                                         project::Prior::uniform(1, 12)};

class Replicas {
 public:
  explicit Replicas(std::uint64_t seed) : site_(site_with(seed)), sampler_(paths.size(), seed) {
    Problems problems;
    for (const std::string& path : paths)
      numbers_.push_back(*project::SettingNumber::find(site_.project(), path, {}, problems));
    std::vector<study::ParameterSet> sets;
    for (const Place& place : sampler_.next_round(prior_sets)) sets.push_back(values_at(place));
    samples_.resize(sets.size());
    site_.run(numbers_, sets, {.rocks = rocks},
              [&](std::size_t k, study::SetOutcome&& outcome) { samples_[k] = stops_of(outcome); });
    for (const Sample& sample : samples_)
      expected_.push_back(expected_summaries(sample, {Eigen::MatrixXd::Zero(observed_rocks, 1)}, {feature}, seed));
    sampler_.set(std::vector<double>(prior_sets, 0));
  }

  /// How many of the parameters' 90 % intervals contain the truth in this many replicas, by parameter. Each replica has
  /// its own truth, drawn from the prior, and its own rocks.
  std::vector<int> covered(int replicas, double likelihood_power) {
    std::vector<int> covered(paths.size(), 0);
    for (int replica = 0; replica < replicas; ++replica) {
      const auto item = static_cast<std::uint64_t>(replica);
      Place truth;
      for (std::uint32_t d = 0; d < paths.size(); ++d)
        truth.push_back(uniform_pair(77, item, static_cast<Stream>(5000), d)[0]);
      const study::PreparedSite other = site_with(1000 + item);
      const Sample all = stops_of(other.run(numbers_, values_at(truth), {.rocks = observed_rocks}));
      Eigen::MatrixXd observed = all.rows;
      for (Eigen::Index k = 0; k < observed.rows(); ++k) {
        const auto [a, b] = uniform_pair(78, item, static_cast<Stream>(5001), static_cast<std::uint32_t>(k));
        observed(k, 0) += feature.accuracy * std::sqrt(-2 * std::log(a)) * std::cos(2 * std::numbers::pi * b);
      }
      std::vector<double> likelihoods;
      for (const ExpectedSummaries& each : expected_)
        likelihoods.push_back(likelihood_power * log_density(summaries_of(observed), each).value);
      const std::vector<double> weights = sampler_.weights(likelihoods);
      for (std::size_t d = 0; d < paths.size(); ++d) {
        std::vector<double> values;
        for (const Place& place : sampler_.places()) values.push_back(place[d]);
        const bool holds = weighted_quantile(values, weights, 0.05) <= truth[d] &&
                           truth[d] <= weighted_quantile(values, weights, 0.95);
        covered[d] += holds ? 1 : 0;
      }
    }
    return covered;
  }

 private:
  static inline const Feature feature{"runout", "m", 0.5};

  static study::PreparedSite site_with(std::uint64_t seed) {
    Problems warnings;
    return {project::read_project_text(scree_slope + cliff_release, "slope.toml", {{}, rocks, seed}).project, warnings};
  }
  static Sample stops_of(const study::SetOutcome& outcome) {
    Sample sample;
    sample.rows.resize(static_cast<Eigen::Index>(outcome.ends.size()), 1);
    for (std::size_t k = 0; k < outcome.ends.size(); ++k)
      sample.rows(static_cast<Eigen::Index>(k), 0) = outcome.ends[k].end.x();
    return sample;
  }
  static study::ParameterSet values_at(const Place& place) {
    study::ParameterSet values;
    for (std::size_t d = 0; d < priors.size(); ++d) values.push_back(priors[d].value(place[d]));
    return values;
  }

  study::PreparedSite site_;
  Sampler sampler_;
  std::vector<project::SettingNumber> numbers_;
  std::vector<Sample> samples_;
  std::vector<ExpectedSummaries> expected_;
};

/// The numbers within which a binomial count lies with a probability of 99.8 %.
std::pair<int, int> binomial_bounds(int trials, double probability) {
  const boost::math::binomial law(trials, probability);
  return {static_cast<int>(std::floor(boost::math::quantile(law, 0.001))),
          static_cast<int>(std::ceil(boost::math::quantile(law, 0.999)))};
}

TEST(CalibrationCoverage, IntervalsContainTheTruthAsOftenAsTheyClaim) {
  constexpr int replicas = 120;
  Replicas all(5);
  const std::vector<int> covered = all.covered(replicas, 1);
  const auto [least, most] = binomial_bounds(replicas, 0.9);
  for (std::size_t d = 0; d < paths.size(); ++d) {
    RecordProperty(paths[d], covered[d]);
    EXPECT_GE(covered[d], least) << paths[d];
    EXPECT_LE(covered[d], most) << paths[d];
  }
  // A likelihood as if nine times as many rocks had been observed is found out.
  const std::vector<int> wrong = all.covered(replicas, 9);
  for (std::size_t d = 0; d < paths.size(); ++d) RecordProperty("wrong " + paths[d], wrong[d]);
  EXPECT_LT(*std::ranges::min_element(wrong), least);
}

}  // namespace
}  // namespace talus::calibration
