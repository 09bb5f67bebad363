// Studies of small projects whose sensitivities are known.

#include "talus/sensitivity/analysis.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "support/input_folder.hpp"

namespace talus::sensitivity {
namespace {

// Rocks slide down a plane at 45 degrees and along the flat, without a random property. Their runout on the flat is
// proportional to the height that friction leaves: it depends on the flat's friction alone, and not on their mass.
const std::string sliding = R"([analysis]
rotation = false
[terrain]
section = [[0, 0], [10, -10], [200, -10]]
[[material]]
name = "Rock"
friction_angle_deg = 20
normal_restitution = 0
tangential_restitution = 1
[[material]]
name = "Flat"
friction_angle_deg = 20
normal_restitution = 0
tangential_restitution = 1
[ground]
segments = ["Rock", "Flat"]
[[seeder]]
type = "point"
position = [1, "surface"]
mass_kg = 100
rocks = 10
[[collector]]
name = "Road"
line = 20
height_m = 10
)";

const std::string study_head = R"(project = "slope.toml"
rocks = 10
[[parameter]]
path = "material.Flat.friction_angle_deg"
range = [15, 30]
[[parameter]]
path = "seeder.0.mass_kg"
range = [10, 1000]
[[result]]
name = "runout"
quantity = "runout"
percentile = 50
)";

class SensitivityAnalysis : public testing_tools::InputFolder {
 protected:
  Analysis of(const std::string& text, int threads = 1) {
    write("slope.toml", sliding);
    write("study.toml", text);
    return PreparedStudy(read_study(path("study.toml"))).run({.threads = threads});
  }
};

TEST_F(SensitivityAnalysis, FindsTheOnlyInputThatMattersByScreening) {
  const Analysis found = of("method = \"morris\"\ntrajectories = 6\n" + study_head);
  ASSERT_EQ(found.inputs.size(), 3u);
  EXPECT_EQ(found.inputs[0].values, "15 to 30");
  EXPECT_EQ(found.inputs[2].name, seed_name);
  const auto& effects = found.results.front().of_inputs;
  EXPECT_LT(effects[0].elementary->mean, -2);  // more friction, less runout
  EXPECT_EQ(effects[0].elementary->magnitude.value, -effects[0].elementary->mean);
  EXPECT_NEAR(effects[1].elementary->magnitude.value, 0, 1e-6);
  EXPECT_EQ(effects[2].elementary->magnitude.value, 0);
  EXPECT_THAT(found.warnings.text(),
              ::testing::HasSubstr("study.toml:8: warning: [[parameter]] 2: no result depends on seeder.0.mass_kg"));
}

TEST_F(SensitivityAnalysis, GivesItAllOfTheVariance) {
  const Analysis found = of("method = \"sobol\"\nrows = 32\n" + study_head);
  EXPECT_EQ(found.runs.size(), 32u * 5);
  const auto& effects = found.results.front().of_inputs;
  EXPECT_NEAR(effects[0].index->total.value, 1, 0.3);
  EXPECT_NEAR(effects[0].index->first.value, 1, 0.3);
  EXPECT_NEAR(effects[1].index->total.value, 0, 1e-9);
  EXPECT_EQ(effects[2].index->total.value, 0);
}

TEST_F(SensitivityAnalysis, IsTheSameOnAnyNumberOfThreads) {
  const std::string text = "method = \"morris\"\ntrajectories = 4\n" + study_head;
  const Analysis one = of(text, 1), two = of(text, 2);
  for (std::size_t k = 0; k < one.runs.size(); ++k) {
    EXPECT_EQ(one.runs[k].inputs, two.runs[k].inputs);
    EXPECT_EQ(one.runs[k].results, two.runs[k].results);
  }
}

TEST_F(SensitivityAnalysis, LeavesOutRunsInWhichNoRockReachesTheLine) {
  const Analysis found = of("method = \"morris\"\ntrajectories = 6\n" + study_head +
                            "[[result]]\nquantity = \"energy\"\nat = \"Road\"\n[[result]]\nquantity = \"share\"\nat = "
                            "\"Road\"\n");
  const ResultEffects &energy = found.results[1], &share = found.results[2];
  EXPECT_LE(energy.defined, found.runs.size());
  EXPECT_EQ(share.defined, found.runs.size());
}

TEST_F(SensitivityAnalysis, RefusesWhatTheProjectDoesNotHave) {
  const auto refusal = [&](const std::string& text) { return refusal_of([&] { static_cast<void>(of(text)); }); };
  EXPECT_EQ(
      refusal(study_head + "[[result]]\nquantity = \"share\"\nat = \"Raod\"\n"),
      "study.toml:13: [[result]] 2: there is no collector or barrier \"Raod\" (the project has Road). Did you mean "
      "\"Road\"?");
  EXPECT_EQ(
      refusal("project = \"slope.toml\"\n[[parameter]]\npath = \"material.Flat.normal_restitution\"\nrange = [0.5, "
              "1.5]\n[[result]]\nquantity = \"runout\"\n"),
      "study.toml:2: [[parameter]] 1: range contains 1.5 (expected 0 to 1)");
}

}  // namespace
}  // namespace talus::sensitivity
