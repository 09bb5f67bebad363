// `talus sensitivity`: its files, and what it says.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/program.hpp"
#include "support/browser.hpp"

namespace talus::test {
namespace {

using ::testing::HasSubstr;

const std::string study_text = R"(
method = "morris"
trajectories = 5
rocks = 20
[[site]]
project = "PROJECT"
[[parameter]]
path = "material.*.friction_angle_deg"
range = [20, 40]
[[parameter]]
path = "analysis.normal_velocity_cutoff_m_s"
range = [0.05, 0.2]
[[result]]
name = "runout"
quantity = "runout"
)";

std::string study_of_tutorial() {
  std::string text = study_text;
  return text.replace(text.find("PROJECT"), 7, tutorial("2d"));
}

TEST(SensitivityCommand, WritesTheSameFilesOnAnyNumberOfThreads) {
  const Workplace place;
  const std::string study = place.write("slope.toml", study_of_tutorial());
  const Said said = talus_says("sensitivity " + study + " --threads 1");
  EXPECT_EQ(said.exit_code, 0) << said.text;
  EXPECT_THAT(said.text, HasSubstr("slope: 20 runs of 20 rocks"));
  EXPECT_THAT(said.text, HasSubstr("material.*.friction_angle_deg"));
  EXPECT_EQ(talus_says("sensitivity " + study + " --threads 2 --quiet -o " + (place / "again").string()).exit_code, 0);
  for (const char* file : {"sensitivity.csv", "runs.csv", "summary.json", "report.html"}) {
    EXPECT_EQ(place.read(std::string("slope/") + file), place.read(std::string("again/") + file)) << file;
  }
  EXPECT_THAT(place.read("slope/sensitivity.csv"),
              HasSubstr("\nsite 1,runout,m,material.*.friction_angle_deg,20 to 40,"));
  EXPECT_THAT(place.read("slope/runs.csv"),
              HasSubstr("run,material.*.friction_angle_deg,analysis.normal_velocity_cutoff_m_s,(seed),runout\n0,"));
  EXPECT_THAT(place.read("slope/summary.json"), HasSubstr("\"method\": \"morris\""));
}

TEST(SensitivityCommand, DrawsTheEffectsOfEachResult) {
  if (!testing_tools::has_browser()) GTEST_SKIP() << "there is no chromium";
  const Workplace place;
  ASSERT_EQ(talus_says("sensitivity -q " + place.write("slope.toml", study_of_tutorial())).exit_code, 0);
  EXPECT_EQ(testing_tools::said_in_page(place / "slope/report.html", R"(
    const [figure, ...others] = document.querySelectorAll('figure');
    return [others.length, figure.querySelector('h4').textContent, figure.querySelectorAll('.bar').length].join(' ');
  )"),
            "0 runout 3");
}

TEST(SensitivityCommand, RefusesABadStudy) {
  const Workplace place;
  const Said said = talus_says("sensitivity " + place.write("slope.toml", "method = \"guess\"\n"));
  EXPECT_EQ(said.exit_code, 2);
  EXPECT_THAT(said.text, HasSubstr("slope.toml:1: method is \"guess\" (expected morris, sobol)"));
  EXPECT_THAT(said.text, HasSubstr("[[site]] is missing"));
}

}  // namespace
}  // namespace talus::test
