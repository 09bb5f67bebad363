// Calibrations from files to results: recovery of known parameters, predictions, and warnings.

#include "talus/calibration/calibrate.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/math/distributions/binomial.hpp>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "calibration/calibrations.hpp"
#include "support/projects.hpp"
#include "talus/calibration/best_set.hpp"
#include "talus/calibration/coverage.hpp"
#include "talus/calibration/doubts.hpp"
#include "talus/calibration/result_files.hpp"
#include "talus/core/random.hpp"
#include "talus/core/stop.hpp"
#include "talus/model/model.hpp"
#include "talus/project/read.hpp"

namespace talus::calibration {
namespace {

using testing_tools::replaced;

TEST_F(Calibrations, RecoverKnownParametersAndPredict) {
  observe(40, 0.75, 6, 11);
  const PreparedStudy study = prepared();
  const CalibrationResult result = calibrate(study);
  EXPECT_EQ(result.sets.size(), 420U) << "240 draws, and further rounds, since these were too few";
  EXPECT_GE(result.effective_sets, enough_effective_sets);
  double sum = 0;
  for (const SetResult& set : result.sets) sum += set.weight;
  EXPECT_NEAR(sum, 1, 1e-9);
  const auto& best = result.sets[result.best];
  EXPECT_NEAR(best.values[0], 0.75, 0.06);
  EXPECT_TRUE(agrees(best));
  EXPECT_EQ(result.misfit, 1);
  ASSERT_EQ(result.held_out.size(), 3U);
  double posterior = 0, prior = 0;
  for (const HeldOut& held : result.held_out) {
    posterior += held.posterior;
    prior += held.prior;
    EXPECT_TRUE(held.constant.has_value());
  }
  EXPECT_LT(posterior, prior);
  const std::vector<HeldOutCoverage> coverage = coverage_of(result.held_out);
  ASSERT_EQ(coverage.size(), 1U);
  EXPECT_EQ(coverage[0].feature.name, "runout");
  EXPECT_EQ(coverage[0].observations, 40U);
  EXPECT_FALSE(coverage[0].is_too_narrow()) << coverage[0].within_90;
  EXPECT_EQ(result.warnings.text().find("held out lie within"), std::string::npos);
}

/// All rocks start at the same place with the same velocity on ground without spread; those that were observed do not.
TEST_F(Calibrations, WarnOfPredictionsThatAreTooNarrow) {
  observe(40, 0.75, 8, 19);
  write("slope.toml", replaced(replaced(slope, "roughness_deg = 5", ""), "distribution = \"normal\", std_dev = 0.04",
                               "distribution = \"none\""));
  write("study.toml", R"(
rocks = 80
draws = 240
folds = 4
[[site]]
project = "slope.toml"
[[observations]]
stops = "stops.csv"
[[parameter]]
path = "material.Scree.friction_angle_deg"
range = [29, 31]
)");
  const PreparedStudy study = prepared();
  const CalibrationResult result = calibrate(study);
  const std::vector<HeldOutCoverage> coverage = coverage_of(result.held_out);
  ASSERT_EQ(coverage.size(), 1U);
  EXPECT_TRUE(coverage[0].is_too_narrow()) << coverage[0].within_90;
  EXPECT_EQ(coverage[0].observations, 40U);
  EXPECT_EQ(coverage[0].min_expected, 31U);  // 2.5 % of the binomial distribution of 40 trials with 0.9
  EXPECT_EQ(coverage[0].max_expected, 39U);
  EXPECT_NE(result.warnings.text().find("of 40 observations that were held out lie within the central 90 % of their "
                                        "predicted runout (expected at least"),
            std::string::npos)
      << result.warnings.text();

  for (const double factor : {0.9, 1.2}) {
    CalibrationResult other = result;
    other.warnings = {};
    for (HeldOut& held : other.held_out) held.posterior = factor * held.prior;
    add_doubts(study, {}, other);
    EXPECT_EQ(other.warnings.text().find("predicted no better than with the prior") != std::string::npos, factor > 1);
  }
}

TEST_F(Calibrations, LearnFromValuesAtALine) {
  observe(60, 0.75, 6, 12);
  write("study.toml", replaced(study_text, "stops = \"stops.csv\"", "values = \"values.csv\"\nat = \"Road\""));
  const PreparedStudy study = prepared();
  EXPECT_EQ(study.groups().front().features.size(), 2U);
  const CalibrationResult result = calibrate(study);
  EXPECT_TRUE(agrees(result.sets[result.best]));
  EXPECT_NEAR(result.sets[result.best].values[0], 0.75, 0.06);
}

TEST_F(Calibrations, LearnFromImpactMarks) {
  observe(60, 0.65, 6, 17);
  write("study.toml", replaced(study_text, "stops = \"stops.csv\"", "marks = \"marks.csv\"\naccuracy_m = 0"));
  const CalibrationResult result = calibrate(prepared());
  EXPECT_TRUE(agrees(result.sets[result.best]));
  double mean = 0;
  for (const SetResult& set : result.sets) mean += set.weight * set.values[0];
  EXPECT_LT(mean, 0.71);  // 0.75 is the middle of the prior
}

// The noise is that of a logarithm by the chance of so many rocks: another seed gives nearly the same, and four times
// the rocks give half.
TEST_F(Calibrations, MeasureTheChanceOfTheirLikelihoods) {
  observe(30, 0.7, 6, 14);
  const auto noise = [&](int rocks, int seed) {
    write("study.toml",
          replaced(study_text, "rocks = 80", "seed = " + std::to_string(seed) + "\nrocks = " + std::to_string(rocks)));
    return calibrate(prepared()).likelihood_noise.value_or(0);
  };
  const double one = noise(80, 1), other = noise(80, 2), large = noise(320, 1);
  EXPECT_GT(one, 0.1);
  EXPECT_LT(std::abs(std::log(other / one)), std::log(1.7));
  EXPECT_NEAR(one / large, 2, 0.9);
}

// A posterior is of the laws and values with which it was found: a project with others is refused, and one with the
// same is not.
// Two slopes in space. The predictions of the second are the same bits wherever its own rocks stopped, since neither
// the sets nor the axis of runouts nor the misfit nor the noise follow from them.
TEST_F(Calibrations, PredictAHeldOutSiteWithoutItsObservations) {
  write("space.toml", replaced(scree_slope, "[300, -60]]", "[300, -60]]\nwidth_m = 200") +
                          replaced(cliff_release, "[1, 3]", "[1, 100, 3]"));
  write("study.toml", R"(
rocks = 40
draws = 120
hold_out_sites = true
[[site]]
name = "A"
project = "space.toml"
[[site]]
name = "B"
project = "space.toml"
[[observations]]
site = "A"
stops = "a.csv"
[[observations]]
site = "B"
stops = "b.csv"
[[parameter]]
path = "material.Scree.tangential_restitution"
range = [0.6, 0.9]
[[parameter]]
path = "material.Scree.roughness_deg"
range = [1, 12]
)");
  const auto stops = [](double x, double y) {
    std::string text = "x_m,y_m\n";
    for (int k = 0; k < 20; ++k)
      text += std::to_string(x + 1.5 * ((7 * k) % 20)) + "," + std::to_string(y + 0.4 * ((3 * k) % 20 - 10)) + "\n";
    return text;
  };
  write("a.csv", stops(70, 100));
  const auto held_out = [&](const std::string& own) {
    write("b.csv", own);
    return calibrate(prepared()).held_out;
  };
  const std::vector<HeldOut> here = held_out(stops(70, 100)), moved = held_out(stops(90, 107));
  ASSERT_EQ(here.size(), 2U);
  ASSERT_EQ(here[1].features.size(), 2U);
  for (std::size_t f = 0; f < 2; ++f) {
    EXPECT_NE(here[1].features[f].observed.mean, moved[1].features[f].observed.mean);
    EXPECT_EQ(here[1].features[f].predicted.mean, moved[1].features[f].predicted.mean) << f;
    EXPECT_EQ(here[1].features[f].predicted.std_dev, moved[1].features[f].predicted.std_dev) << f;
  }
  EXPECT_NE(here[0].features[0].predicted.mean, moved[0].features[0].predicted.mean) << "site A is predicted from B";
}

TEST_F(Calibrations, SayWhatIsDoneAfterTheSets) {
  observe(30, 0.7, 6, 15);
  std::vector<std::string> said;
  std::size_t last = 0;
  static_cast<void>(calibrate_into(path("out"), prepared(),
                                   {.progress = [&](std::size_t done, std::size_t) { last = done; },
                                    .phase =
                                        [&](const std::string& what) {
                                          EXPECT_EQ(last,
                                                    300U);  // 240 draws, and a further round, since these were too few
                                          said.push_back(what);
                                        }}));
  EXPECT_THAT(said, testing::ElementsAre("predicting observations that were held out: fold 1 of 3",
                                         "predicting observations that were held out: fold 2 of 3",
                                         "predicting observations that were held out: fold 3 of 3",
                                         "checking the results", "writing the results"));
}

TEST_F(Calibrations, SayWhyTheBestSetIsOutsideThePosterior) {
  observe(30, 0.7, 6, 15);
  const PreparedStudy study = prepared();
  CalibrationResult result;
  for (int k = 0; k < 100; ++k) {
    SetResult& set = result.sets.emplace_back();
    set.values = {0.6 + 0.003 * k, 6};
    set.weight = 0.01;
  }
  for (const std::size_t inside : {5u, 50u, 94u}) {
    result.best = inside;
    EXPECT_EQ(why_best_is_outside(study, result), "") << inside;
  }
  for (const std::size_t outside : {0u, 99u}) {
    result.best = outside;
    EXPECT_EQ(
        why_best_is_outside(study, result),
        "The best set lies outside the posterior's 5 to 95 % of material.Scree.tangential_restitution: it has the "
        "least score, the distance of its rocks from the observed ones, while the posterior weights sets by their "
        "likelihood; predict with the posterior")
        << outside;
  }
}

TEST_F(Calibrations, SimulateAnotherStudyAnew) {
  observe(30, 0.7, 6, 15);
  static_cast<void>(calibrate_into(path("out"), prepared(), {}));
  const std::string before = bytes_of(path("out/posterior.csv"));
  observe(30, 0.85, 3, 16);
  static_cast<void>(calibrate_into(path("out"), prepared(), {}));
  EXPECT_NE(bytes_of(path("out/posterior.csv")), before);
}

TEST_F(Calibrations, StopIfNoObservationCanBeReached) {
  write("stops.csv", "x_m\n250\n255\n260\n265\n270\n251\n256\n261\n266\n271\n");
  const std::string refusal = refusal_of([&] { static_cast<void>(calibrate(prepared())); });
  EXPECT_NE(refusal.find("study.toml: stops: no parameters within the ranges give a runout of more than "),
            std::string::npos)
      << refusal;
  EXPECT_NE(refusal.find("; observed 270 m (no observation is reached by any of 120 sets). Widen the ranges, let other "
                         "parameters vary, or check the observations and the releases"),
            std::string::npos)
      << refusal;
}

TEST_F(Calibrations, SayZeroWhereNoRockMoves) {
  write("slope.toml", replaced(replaced(slope, "position = [1, 3]", "position = [1, \"surface\"]"),
                               "horizontal_velocity_m_s = 2", ""));
  write("stops.csv", "x_m\n27\n28\n27\n28\n27\n28\n");
  write("study.toml",
        replaced(replaced(study_text, "tangential_restitution", "friction_angle_deg"), "[0.6, 0.9]", "[70, 80]"));
  EXPECT_EQ(refusal_of([&] { static_cast<void>(calibrate(prepared())); }),
            "study.toml: stops: no parameters within the ranges give a runout of more than 0 m; observed 27 m (no "
            "observation is reached by any of 120 sets). Widen the ranges, let other parameters vary, or check the "
            "observations and the releases");
}

/// The direction of runouts is then that of the simulated rocks.
TEST_F(Calibrations, CompareStopsAtTheRelease) {
  write("stops.csv", "x_m\n1\n1\n1\n1\n1\n1\n");
  EXPECT_THAT(refusal_of([&] { static_cast<void>(calibrate(prepared())); }),
              testing::HasSubstr("no parameters within the ranges give a runout of less than 39"));
}

TEST_F(Calibrations, SayWhatCannotBeReached) {
  write("stops.csv", "x_m\n250\n255\n260\n65\n70\n251\n256\n261\n66\n71\n");
  const CalibrationResult result = calibrate(prepared());
  EXPECT_NE(result.warnings.text().find("no parameters within the ranges give a runout of more than"),
            std::string::npos)
      << result.warnings.text();
  EXPECT_NE(result.warnings.text().find("; observed 260 m"), std::string::npos) << result.warnings.text();
  EXPECT_GT(result.misfit, 1);
}

TEST_F(Calibrations, SayWhichGroundNoObservedRockTouched) {
  // Rocks of a second release fall on the meadow; only those of the cliff were observed, on scree.
  write("slope.toml",
        replaced(replaced(slope, "[[seeder]]",
                          "[[material]]\nname = \"Meadow\"\nnormal_restitution = 0.3\nfriction_angle_deg = 30\n"
                          "tangential_restitution = 0.8\n[ground]\nsegments = [\"Scree\", \"Scree\", \"Scree\", "
                          "\"Meadow\"]\n[[seeder]]\nname = \"Wall\"\ntype = \"point\"\nposition = [150, -50]\n"
                          "mass_kg = 300\nrocks = 40\nhorizontal_velocity_m_s = 3\n[[seeder]]"),
                 "[300, -60]]", "[130, -56], [300, -60]]"));
  write("stops.csv", "x_m,release\n66,Cliff\n67,Cliff\n68,Cliff\n69,Cliff\n70,Cliff\n71,Cliff\n72,Cliff\n73,Cliff\n");
  write("study.toml", study_text + "[[parameter]]\npath = \"material.Meadow.friction_angle_deg\"\nrange = [20, 40]\n");
  const CalibrationResult result = calibrate(prepared());
  EXPECT_NE(result.warnings.text().find("parameter \"material.Meadow.friction_angle_deg\": 0 of the "),
            std::string::npos)
      << result.warnings.text();
  EXPECT_NE(result.warnings.text().find("simulated rocks that come nearest to the observed ones depend on it (it seems "
                                        "that no observed rock touched the ground \"Meadow\")"),
            std::string::npos)
      << result.warnings.text();
}

/// The whole calibration of many synthetic sites; with `make soak`.
TEST_F(Calibrations, CalibrationCoverageOfWholeCalibrations) {
  const char* effort = std::getenv("TALUS_TEST_EFFORT");
  if (effort == nullptr || std::atof(effort) < 10) GTEST_SKIP() << "takes minutes; make soak runs it";
  constexpr int replicas = 110;
  std::vector<int> right(2, 0), wrong(2, 0);
  write("study.toml", replaced(replaced(study_text, "draws = 240", "draws = 900"), "folds = 3", "folds = 0"));
  for (int replica = 0; replica < replicas; ++replica) {
    const auto [a, b] = uniform_pair(9, static_cast<std::uint64_t>(replica), static_cast<Stream>(6001), 0);
    const std::vector<double> truth{0.6 + 0.3 * a, 1 + 11 * b};
    observe(25, truth[0], truth[1], 500 + static_cast<std::uint64_t>(replica));
    const PreparedStudy study = prepared();
    const CalibrationResult result = calibrate(study), sharp = calibrate(study, {.likelihood_power = 9});
    for (std::size_t k = 0; k < 2; ++k) {
      right[k] += holds(result, k, truth[k]) ? 1 : 0;
      wrong[k] += holds(sharp, k, truth[k]) ? 1 : 0;
    }
  }
  const boost::math::binomial law(replicas, 0.9);
  for (std::size_t k = 0; k < 2; ++k) {
    RecordProperty("right " + std::to_string(k), right[k]);
    RecordProperty("wrong " + std::to_string(k), wrong[k]);
    EXPECT_GE(right[k], boost::math::quantile(law, 0.001));
    EXPECT_LE(right[k], boost::math::quantile(law, 0.999) + 1);
    EXPECT_LT(wrong[k], boost::math::quantile(law, 0.001));
  }
}

}  // namespace
}  // namespace talus::calibration
