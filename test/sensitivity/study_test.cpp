// Study files: what they mean, and the exact text of refusals.

#include "talus/sensitivity/study.hpp"

#include <gtest/gtest.h>

#include <string>

#include "support/projects.hpp"

namespace talus::sensitivity {
namespace {

using testing_tools::replaced;

const std::string whole = R"(method = "sobol"
rows = 64
[[site]]
project = "slope.toml"
[[parameter]]
path = "material.Scree.normal_restitution"
range = [0.2, 0.6]
[[parameter]]
path = "material.Scree.friction_angle_deg"
prior = { mean = 30, distribution = "normal", std_dev = 2 }
[[result]]
quantity = "runout"
[[result]]
quantity = "energy"
percentile = 99
at = "Road"
)";

std::string refusal_of_study(const std::string& text) {
  try {
    static_cast<void>(read_study_text(text, "study.toml"));
  } catch (const BadInput& bad) {
    return bad.what();
  }
  return "";
}

TEST(SensitivityStudy, IsRead) {
  const Study study = read_study_text(whole, "study.toml").study;
  EXPECT_EQ(study.name, "study");
  EXPECT_EQ(study.method, Method::sobol);
  EXPECT_EQ(study.rows, 64);
  ASSERT_EQ(study.parameters.size(), 2u);
  EXPECT_EQ(study.parameters[0].range, (std::vector<double>{0.2, 0.6}));
  EXPECT_EQ(study.parameters[1].prior->kind, DistributionKind::normal);
  ASSERT_EQ(study.results.size(), 2u);
  EXPECT_EQ(study.results[0].name, "95th percentile of the runout on plan");
  EXPECT_EQ(study.results[1].name, "99th percentile of the total kinetic energy at the line: Road");
  EXPECT_EQ(study.results[1].of, FigureOf::energy);
  EXPECT_EQ(study.sites.front().name, "site 1");
}

TEST(SensitivityStudy, IsRefusedWithEveryProblem) {
  EXPECT_EQ(refusal_of_study(replaced(replaced(whole, "\"sobol\"", "\"sobel\""), "[0.2, 0.6]", "[0.6, 0.2]")),
            "study.toml:1: method is \"sobel\" (expected morris, sobol). Did you mean \"sobol\"?\n"
            "study.toml:7: [[parameter]] 1: range is [0.6, 0.2] (expected [least, greatest]). Exchange the two");
  EXPECT_EQ(refusal_of_study(replaced(whole, "rows = 64", "rows = 60")),
            "study.toml:2: rows is 60 (points of a Sobol sequence are even in powers of two). Use 32 or 64");
  EXPECT_EQ(refusal_of_study(replaced(whole, "at = \"Road\"\n", "")),
            "study.toml:14: [[result]] 2: at is missing (energy is that at a line). Name a collector or barrier of the "
            "project");
  EXPECT_EQ(
      refusal_of_study(replaced(whole, "quantity = \"runout\"", "quantity = \"run out\"")),
      "study.toml:12: [[result]] 1: quantity is \"run out\" (expected runout, max_energy, max_bounce, share, energy, "
      "velocity, height). Did you mean \"runout\"?");
  EXPECT_EQ(refusal_of_study(replaced(whole, "range = [0.2, 0.6]\n", "")),
            "study.toml:5: [[parameter]] 1: range or prior is missing (a parameter varies within what is known of it). "
            "Write range "
            "= [least, greatest]");
  EXPECT_EQ(refusal_of_study(replaced(whole, "percentile = 99", "name = \"95th percentile of the runout on plan\"")),
            "study.toml:15: [[result]] 2: name \"95th percentile of the runout on plan\" is given twice (names must be "
            "unique)");
  EXPECT_EQ(refusal_of_study(whole + "sites = [\"site 2\"]\n"),
            "study.toml:17: [[result]] 2: there is no site \"site 2\". Did you mean \"site 1\"?");
}

}  // namespace
}  // namespace talus::sensitivity
