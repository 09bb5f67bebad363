// `talus validate`, with an experiment in a folder.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "cli/program.hpp"
#include "support/browser.hpp"

namespace talus::test {
namespace {

using ::testing::HasSubstr;

/// Eight runs a half on a made slope.
std::string experiment_in(const Workplace& folder) {
  folder.write("slope.toml", R"([terrain]
section = [[0, 0], [40, -40], [70, -55], [300, -60]]
[[material]]
name = "Scree"
normal_restitution = { mean = 0.3, distribution = "normal", std_dev = 0.04 }
tangential_restitution = { mean = 0.8, distribution = "normal", std_dev = 0.04 }
friction_angle_deg = 30
roughness_deg = 5
[[seeder]]
name = "Releases"
type = "table"
table = "releases.csv"
mass_kg = 300
)");
  folder.write("study.toml", R"(rocks = 80
draws = 50
[[site]]
name = "A"
project = "slope.toml"
[[site]]
name = "B"
project = "slope.toml"
[[observations]]
site = "A"
stops = "a.csv"
[[observations]]
site = "B"
stops = "b.csv"
[[parameter]]
path = "material.Scree.roughness_deg"
range = [1, 12]
)");
  folder.write("experiment.toml", R"(title = "A made slope"
summary = "Nothing was released."
licence = "CC0"
citations = ["A. Author"]
limits = ["The slope does not exist."]
split = "none"
sought = ["roughness"]
not_sought = ["all else"]
[[model]]
name = "lumped mass"
study = "study.toml"
[[published]]
name = "Other"
source = "its <manual>"
observed_mean_m = 70
predicted_mean_m = 75
)");
  std::string releases = "name,x_m,height_above_m\n", a = "name,x_m\n", b = a;
  for (int k = 0; k < 8; ++k) {
    const std::string name = "r" + std::to_string(k) + ",";
    releases += name + std::to_string(1 + k) + ",1\n";
    a += name + std::to_string(62 + 3 * k) + "\n";
    b += name + std::to_string(84 - 3 * k) + "\n";
  }
  folder.write("releases.csv", releases);
  folder.write("a.csv", a);
  folder.write("b.csv", b);
  return (folder / "").parent_path().string();
}

TEST(ValidateCommand, WritesResultsOfAFolder) {
  const Workplace folder;
  const std::string experiment = experiment_in(folder);
  const Said said = talus_says("validate " + experiment + " -o " + (folder / "out").string());
  EXPECT_EQ(said.exit_code, 0) << said.text;
  EXPECT_THAT(said.text, HasSubstr("The slope does not exist."));
  EXPECT_THAT(said.text, HasSubstr("of 8"));
  const std::string name = std::filesystem::path(experiment).filename().string();
  EXPECT_THAT(folder.read("out/" + name + "/results.csv"), HasSubstr("\nlumped mass,A,B,8,"));
  EXPECT_THAT(folder.read("out/" + name + "/runs.csv"), HasSubstr("\nlumped mass,B,r7,8,"));
  if (!testing_tools::has_browser()) GTEST_SKIP() << "there is no chromium";
  EXPECT_EQ(testing_tools::said_in_page(folder / ("out/" + name + "/report.html"), R"(
    const main = document.getElementById('main');
    const titles = [...main.querySelectorAll('h4')].map((each) => each.textContent).slice(0, 6).join(', ');
    const other = [...main.querySelectorAll('tr')].filter((row) => row.textContent.startsWith('Other')).map((row) =>
      [...row.children].map((cell) => cell.textContent).join(' ')).join();
    const drawn = ['.whisker', '.below-curve', '.curve', 'circle'].every((what) => main.querySelector('figure ' + what));
    return [titles, other, drawn, main.textContent.includes('The slope does not exist.'),
      /NaN|undefined/.test(main.innerHTML)].join('; ');
  )"),
            "Runs of A, Runouts of A, A on plan, Runs of B, Runouts of B, B on plan; "
            "Other 70.0 75.0 +5.0 \xe2\x80\x93 its &lt;manual&gt;; true; true; false");
}

TEST(ValidateCommand, RefusesWhatIsNoExperiment) {
  EXPECT_EQ(talus_says("validate nowhere").exit_code, 2);
  const Workplace folder;
  const Said said = talus_says("validate " + (folder / "").string());
  EXPECT_EQ(said.exit_code, 2);
  EXPECT_THAT(said.text, HasSubstr("there is no experiment.toml in this folder"));
}

}  // namespace
}  // namespace talus::test
