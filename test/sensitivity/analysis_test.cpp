// Studies of small projects whose sensitivities are known.

#include "talus/sensitivity/analysis.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "support/input_folder.hpp"
#include "support/projects.hpp"
#include "talus/core/stop.hpp"
#include "talus/sensitivity/output.hpp"

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

const std::string study_head = R"(rocks = 10
[[site]]
project = "slope.toml"
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

std::string content_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return std::move(text).str();
}

class SensitivityAnalysis : public testing_tools::InputFolder {
 protected:
  Analysis of(const std::string& text, int threads = 1) {
    write("slope.toml", sliding);
    write("study.toml", text);
    warnings_ = {};
    return PreparedStudy(read_study(path("study.toml")).study, warnings_).run({.threads = threads});
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
              ::testing::HasSubstr("study.toml:9: warning: parameter \"seeder.0.mass_kg\": no result depends on it"));
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

TEST_F(SensitivityAnalysis, GivesResultsOfEachSite) {
  write("steep.toml", testing_tools::replaced(sliding, "[10, -10], [200, -10]", "[10, -20], [200, -20]"));
  const std::string two =
      "[[site]]\nname = \"steep\"\nproject = \"steep.toml\"\n[[result]]\nquantity = \"share\"\nat = "
      "\"Road\"\nsites = [\"steep\"]\n";
  const Analysis both = of("method = \"morris\"\ntrajectories = 4\n" + study_head + two);
  ASSERT_EQ(both.results.size(), 3u);
  EXPECT_EQ(both.results[0].title, "runout@site 1");
  EXPECT_EQ(both.results[1].title, "runout@steep");
  EXPECT_EQ(both.results[2].title, "share of rocks that reach the line: Road@steep");
  EXPECT_LT(*both.results[0].mean, *both.results[1].mean);
  // Each site alone gives the same.
  const Analysis one = of("method = \"morris\"\ntrajectories = 4\n" + study_head);
  for (std::size_t k = 0; k < one.runs.size(); ++k) EXPECT_EQ(one.runs[k].results[0], both.runs[k].results[0]);

  // With a value of its own at each site, the inputs of one have no effect at the other.
  const Analysis own =
      of("method = \"morris\"\ntrajectories = 4\n" +
         testing_tools::replaced(study_head, "range = [15, 30]", "range = [15, 30]\neach_site = true") + two);
  ASSERT_EQ(own.inputs.size(), 4u);
  EXPECT_EQ(own.inputs[1].name, "material.Flat.friction_angle_deg@steep");
  EXPECT_LT(own.results[0].of_inputs[0].elementary->mean, -2);
  EXPECT_FALSE(own.results[0].of_inputs[1].size());
  EXPECT_FALSE(own.results[1].of_inputs[0].size());
  EXPECT_LT(own.results[1].of_inputs[1].elementary->mean, -2);
}

TEST_F(SensitivityAnalysis, ContinuesAfterAStopWithTheSameFiles) {
  write("slope.toml", sliding);
  write("study.toml", "method = \"morris\"\ntrajectories = 40\n" + study_head);
  const Study study = read_study(path("study.toml")).study;
  const PreparedStudy prepared(study, warnings_);
  ASSERT_EQ(prepared.runs(), 160u);
  static_cast<void>(analyse_into(path("whole"), study, prepared, {.threads = 2}));
  std::atomic<bool> stop{false};
  {
    const StopScope scope(&stop);
    const AnalysisOptions until_stopped{.threads = 1, .progress = [&](std::uint64_t done) { stop = done > 110; }};
    EXPECT_THROW(static_cast<void>(analyse_into(path("stopped"), study, prepared, until_stopped)), Stopped);
  }
  EXPECT_FALSE(std::filesystem::exists(path("stopped/summary.json")));
  const auto kept = path("stopped/sets/0000000.sets");
  ASSERT_TRUE(std::filesystem::exists(kept));
  const auto written = std::filesystem::last_write_time(kept);
  static_cast<void>(analyse_into(path("stopped"), study, prepared, {.threads = 1}));
  EXPECT_EQ(std::filesystem::last_write_time(kept), written);
  for (const char* file : {"sensitivity.csv", "runs.csv", "summary.json", "report.html"}) {
    EXPECT_NE(content_of(path("whole") / file), "") << file;
    EXPECT_EQ(content_of(path("whole") / file), content_of(path("stopped") / file)) << file;
  }
}

TEST_F(SensitivityAnalysis, RunsAnotherStudyAnew) {
  write("slope.toml", sliding);
  const auto table = [&](const std::string& text) {
    write("study.toml", "method = \"morris\"\ntrajectories = 4\n" + text);
    const Study study = read_study(path("study.toml")).study;
    static_cast<void>(analyse_into(path("out"), study, PreparedStudy(study, warnings_), {}));
    return content_of(path("out/runs.csv"));
  };
  const std::string first = table(study_head);
  const std::string other = table(testing_tools::replaced(study_head, "percentile = 50", "percentile = 99"));
  EXPECT_EQ(first.substr(0, first.find('\n')), other.substr(0, other.find('\n')));
  write("slope.toml", testing_tools::replaced(sliding, "[10, -10], [200, -10]", "[10, -20], [200, -20]"));
  EXPECT_NE(table(study_head), first);
}

TEST_F(SensitivityAnalysis, RefusesWhatTheProjectDoesNotHave) {
  const auto refusal = [&](const std::string& text) { return refusal_of([&] { static_cast<void>(of(text)); }); };
  EXPECT_EQ(
      refusal(study_head + "[[result]]\nquantity = \"share\"\nat = \"Raod\"\n"),
      "study.toml:14: [[result]] 2: there is no collector or barrier \"Raod\" (slope.toml has Road). Did you mean "
      "\"Road\"?");
  EXPECT_EQ(
      refusal("[[site]]\nproject = \"slope.toml\"\n[[parameter]]\npath = \"material.Flat.normal_restitution\"\nrange = "
              "[0.5, "
              "1.5]\n[[result]]\nquantity = \"runout\"\n"),
      "study.toml:3: parameter \"material.Flat.normal_restitution\": range is [0.5, 1.5] (the setting may be 0 to 1)");
}

}  // namespace
}  // namespace talus::sensitivity
