// Synthetic observations of each kind: 90 % intervals hold the truth, and rocks matched with their releases say more.

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include "calibration/slope.hpp"
#include "talus/calibration/group_comparison.hpp"
#include "talus/calibration/sampler.hpp"
#include "talus/calibration/smoothed_likelihood.hpp"
#include "talus/core/random.hpp"
#include "talus/project/read.hpp"

namespace talus::calibration {
namespace {

/// Four releases along a slope, of which the lower ones fall on scree alone.
const std::string four_releases = scree_slope + R"(
[[seeder]]
name = "A"
type = "point"
position = [1, 3]
mass_kg = 300
rocks = 40
[[seeder]]
name = "B"
type = "point"
position = [15, -10]
mass_kg = 300
rocks = 40
[[seeder]]
name = "C"
type = "point"
position = [30, -27]
mass_kg = 300
rocks = 40
[[seeder]]
name = "D"
type = "point"
position = [50, -42]
mass_kg = 300
rocks = 40
)";
constexpr std::uint64_t rocks_of_release = 40, observed_of_release = 6;

/// Many releases, of each of which one rock is observed.
constexpr std::uint64_t releases = 24, few_rocks = 20;
std::string many_releases() {
  std::string text = scree_slope;
  for (std::uint64_t k = 0; k < releases; ++k) {
    const double x = 2 + 1.5 * static_cast<double>(k);
    text += "[[seeder]]\nname = \"R" + std::to_string(k) + "\"\ntype = \"point\"\nposition = [" + std::to_string(x) +
            ", " + std::to_string(3 - x) + "]\nmass_kg = 300\nrocks = " + std::to_string(few_rocks) + "\n";
  }
  return text;
}

const std::vector<std::string> names{"material.Scree.tangential_restitution", "material.Scree.roughness_deg"};

struct Coverage {
  std::vector<int> covered;
  std::vector<double> width;  // mean of the 90 % intervals, as shares of the prior
};

class Kinds : public ::testing::Test {
 protected:
  using Observe = std::function<ObservedGroup(const study::SetOutcome&)>;

  static int replicas() {
    const char* effort = std::getenv("TALUS_TEST_EFFORT");
    return effort == nullptr ? 20 : static_cast<int>(20 * std::clamp(std::atof(effort), 1.0, 10.0));
  }

  static study::PreparedSite site_with(std::uint64_t seed, const std::string& project) {
    Problems warnings;
    return {project::read_project_text(project, "slope.toml", {{}, std::nullopt, seed}).project, warnings};
  }

  /// `seeds`: of simulations, in turn; those of few rocks are off by chance, in common for all sets.
  Coverage coverage(const Observe& observe, std::size_t sets = 400, const std::string& project = four_releases,
                    int seeds = 1) {
    Coverage all{std::vector<int>(names.size(), 0), std::vector<double>(names.size(), 0)};
    for (int seed = 0; seed < seeds; ++seed) add_coverage(all, observe, sets, project, seed, seeds);
    for (std::size_t d = 0; d < names.size(); ++d) {
      RecordProperty("covered " + std::to_string(d), all.covered[d]);
      RecordProperty("width " + std::to_string(d), std::to_string(all.width[d]));
    }
    return all;
  }

  /// Of the replicas `first`, `first + step` ...
  void add_coverage(Coverage& all, const Observe& observe, std::size_t sets, const std::string& project, int first,
                    int step) {
    const study::PreparedSite site = site_with(5 + static_cast<std::uint64_t>(first), project);
    Problems problems;
    std::vector<project::SettingNumber> numbers;
    for (const std::string& name : names)
      numbers.push_back(*project::SettingNumber::find(site.project(), name, {}, problems));
    Sampler sampler(names.size(), 5);
    std::vector<study::ParameterSet> values;
    for (const Place& place : sampler.next_round(sets)) values.push_back(values_at(place));
    sampler.set(std::vector<double>(sets, 0));
    std::vector<study::SetOutcome> outcomes(sets);
    site.run(numbers, values, {.keep_marks = true},
             [&](std::size_t k, study::SetOutcome&& outcome) { outcomes[k] = std::move(outcome); });
    for (int replica = first; replica < replicas(); replica += step) {
      const auto item = static_cast<std::uint64_t>(replica);
      Place truth;
      for (std::uint32_t d = 0; d < names.size(); ++d)
        truth.push_back(uniform_pair(79, item, static_cast<Stream>(5100), d)[0]);
      const ObservedGroup group =
          observe(site_with(2000 + item, project).run(numbers, values_at(truth), {.keep_marks = true}));
      const GroupComparison comparison(group, 5);
      std::vector<double> likelihoods;
      for (const study::SetOutcome& outcome : outcomes)
        likelihoods.push_back(comparison.density(simulated_sample(group, outcome), group.sample).value);
      const std::vector<double> weights = sampler.weights(smoothed_likelihoods(sampler.places(), likelihoods).values);
      for (std::size_t d = 0; d < names.size(); ++d) {
        std::vector<double> own;
        for (const Place& place : sampler.places()) own.push_back(place[d]);
        const double low = weighted_quantile(own, weights, 0.05), high = weighted_quantile(own, weights, 0.95);
        all.covered[d] += low <= truth[d] && truth[d] <= high ? 1 : 0;
        all.width[d] += (high - low) / replicas();
      }
    }
  }

  static void expect_calibrated(const Coverage& coverage) {
    const boost::math::binomial law(replicas(), 0.9);
    for (const int covered : coverage.covered)
      EXPECT_GE(covered, std::floor(boost::math::quantile(law, 0.001))) << "of " << replicas();
  }

  static study::ParameterSet values_at(const Place& place) { return {0.6 + 0.3 * place[0], 1 + 11 * place[1]}; }

  static bool is_observed(std::uint64_t rock) { return rock % rocks_of_release < observed_of_release; }

  /// The first stops of each release; with its name, or without.
  static ObservedGroup stops(const study::SetOutcome& outcome, bool is_matched) {
    ObservedGroup group;
    group.features = {{"runout", "m", 0.01}};
    std::vector<double> runouts;
    for (const study::RockEnd& end : outcome.ends) {
      if (is_matched) group.releases.of_rock.push_back(end.seeder.index);
      if (!is_observed(end.rock)) continue;
      runouts.push_back(end.end.x());
      if (is_matched) group.sample.strata.push_back(end.seeder.index);
    }
    if (is_matched) {
      group.releases.names = {"A", "B", "C", "D"};
      group.releases.origins.assign(4, Vec2{});
    }
    group.sample.rows = Eigen::Map<Eigen::VectorXd>(runouts.data(), static_cast<Eigen::Index>(runouts.size()));
    return group;
  }
};

TEST_F(Kinds, ManyReleasesOfOneObservedRockAreCalibrated) {
  const auto observe = [](const study::SetOutcome& outcome) {
    ObservedGroup group;
    group.features = {{"runout", "m", 0.01}};
    std::vector<double> runouts;
    for (const study::RockEnd& end : outcome.ends) {
      group.releases.of_rock.push_back(end.seeder.index);
      if (end.rock % few_rocks != 0) continue;
      runouts.push_back(end.end.x());
      group.sample.strata.push_back(end.seeder.index);
    }
    for (std::uint64_t k = 0; k < releases; ++k) group.releases.names.push_back("R" + std::to_string(k));
    group.releases.origins.assign(releases, Vec2{});
    group.sample.rows = Eigen::Map<Eigen::VectorXd>(runouts.data(), static_cast<Eigen::Index>(runouts.size()));
    return group;
  };
  expect_calibrated(coverage(observe, 400, many_releases(), 8));
}

TEST_F(Kinds, MatchedStopsAreCalibratedAndSayMore) {
  const Coverage matched = coverage([](const study::SetOutcome& outcome) { return stops(outcome, true); });
  const Coverage together = coverage([](const study::SetOutcome& outcome) { return stops(outcome, false); });
  expect_calibrated(matched);
  expect_calibrated(together);
  for (std::size_t d = 0; d < names.size(); ++d) {
    RecordProperty("matched " + std::to_string(d), std::to_string(matched.width[d]));
    RecordProperty("together " + std::to_string(d), std::to_string(together.width[d]));
    EXPECT_LT(matched.width[d], together.width[d]) << names[d];
  }
}

TEST_F(Kinds, ZonesAreCalibrated) {
  expect_calibrated(coverage([](const study::SetOutcome& outcome) {
    ObservedGroup group;
    group.kind = ObservationKind::zones;
    group.zones.amount = ZoneAmount::count;
    group.zones.has_elsewhere = true;
    group.zones.list = {{.name = "slope", .from = 0, .to = 70}, {.name = "foot", .from = 70, .to = 95}};
    std::vector<study::RockEnd> observed;
    std::ranges::copy_if(outcome.ends, std::back_inserter(observed),
                         [](const study::RockEnd& end) { return is_observed(end.rock); });
    group.sample = zone_sample(group.zones, observed);
    return group;
  }));
}

TEST_F(Kinds, MarksAreCalibratedIfTheyNameTheirRocks) {
  constexpr std::size_t sets = 150;
  const auto marks = [](const study::SetOutcome& outcome) {
    ObservedGroup group;
    group.kind = ObservationKind::marks;
    group.features = {{"runout", "m", 0.01}};
    std::vector<double> places;
    for (const study::Mark& mark : outcome.marks) {
      if (mark.rock % 20 != 0) continue;
      places.push_back(mark.position.x());
      group.sample.rocks.push_back(static_cast<std::uint32_t>(mark.rock));
    }
    group.sample.rows = Eigen::Map<Eigen::VectorXd>(places.data(), static_cast<Eigen::Index>(places.size()));
    return group;
  };
  expect_calibrated(coverage(marks, sets));
}

}  // namespace
}  // namespace talus::calibration
