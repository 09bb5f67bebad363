// Experiment files: what is refused, with line, key and hint.

#include "talus/calibration/experiment.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "support/input_folder.hpp"

namespace talus::validation {
namespace {

const std::string good_study = R"([[site]]
name = "A"
project = "p.toml"
[[site]]
name = "B"
project = "p.toml"
[[observations]]
site = "A"
stops = "a.csv"
[[observations]]
site = "B"
stops = "b.csv"
[[parameter]]
path = "material.Scree.roughness_deg"
range = [1, 12]
)";

const std::string good_experiment = R"(title = "Slope"
summary = "Rocks were released."
licence = "CC0"
citations = ["A. Author: Rocks"]
split = "odd and even"
sought = ["roughness"]
not_sought = ["all else"]
[[model]]
name = "lumped mass"
study = "study.toml"
)";

class Experiments : public testing_tools::InputFolder {
 protected:
  std::string refusal(const std::string& experiment, const std::string& study = good_study) {
    write("experiment.toml", experiment);
    write("study.toml", study);
    return refusal_of([&] { (void)read_experiment(folder_, warnings_); });
  }
};

TEST_F(Experiments, AreReadWithTheirStudies) {
  EXPECT_EQ(refusal(good_experiment), "was read");
  const Experiment experiment = read_experiment(folder_, warnings_);
  EXPECT_EQ(experiment.title, "Slope");
  EXPECT_EQ(experiment.studies.size(), 1U);
  EXPECT_EQ(experiment.name, folder_.filename().string());
}

TEST_F(Experiments, AllProblemsAreReportedAtOnce) {
  EXPECT_EQ(
      refusal(R"(titel = "Slope"
summary = "Rocks were released."
licence = "CC0"
citations = ["A. Author: Rocks"]
split = "odd and even"
sought = ["roughness"]
not_sought = ["all else"]
[[model]]
name = "lumped mass"
study = "../study.toml"
[[published]]
name = "Other"
source = "its manual"
observed_mean_m = -3
)"),
      "experiment.toml:1: unknown key \"titel\". Did you mean title?\n"
      "experiment.toml:8: model \"lumped mass\": study is \"../study.toml\" (an experiment is one folder). Put the "
      "study beside experiment.toml and give its name alone\n"
      "experiment.toml:11: published \"Other\": predicted_mean_m is missing (expected 0 to 1e6)\n"
      "experiment.toml:14: published \"Other\": observed_mean_m is -3 (expected 0 to 1e6)");
}

TEST_F(Experiments, StudiesThatCannotBeHeldOutAreRefused) {
  EXPECT_EQ(
      refusal(good_experiment, good_study + "each_site = true\n[[observations]]\nsite = \"A\"\nstops = \"c.csv\"\n"),
      "study.toml:13: model \"lumped mass\": parameter \"material.Scree.roughness_deg\" belongs to one site (its value "
      "cannot be predicted from the other sites). Leave each_site out\n"
      "study.toml:1: model \"lumped mass\": site \"A\" does not have one file of stops (predicted stops are compared "
      "with observed ones, run by run). Give it one [[observations]] with stops");
}

}  // namespace
}  // namespace talus::validation
