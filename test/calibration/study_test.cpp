// Study files: what is read, and the exact text of what is refused.

#include "talus/calibration/study.hpp"
#include "support/places.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

#include "calibration/slope.hpp"
#include "support/input_folder.hpp"
#include "support/projects.hpp"
#include "talus/calibration/calibrate.hpp"

namespace talus::calibration {
namespace {

using testing_tools::replaced;

const std::string small = R"(
rocks = 40
draws = 60
[[site]]
project = "slope.toml"
[[observations]]
stops = "stops.csv"
[[parameter]]
path = "material.Scree.friction_angle_deg"
range = [20, 40]
)";

const std::string two_part_slope = R"(
[terrain]
section = [[0, 0], [40, -40], [300, -60]]
[[material]]
name = "Scree"
tangential_restitution = { mean = 0.8, distribution = "normal", std_dev = 0.04 }
)" + cliff_release + road_collector;

std::string refusal(const std::string& text) {
  try {
    static_cast<void>(read_study_text(text, "study.toml"));
  } catch (const BadInput& bad) {
    return bad.problems().text();
  }
  return "was read";
}

TEST(Study, HasDefaults) {
  const Study study = read_study_text(small, "study.toml").study;
  EXPECT_EQ(study.name, "study");
  EXPECT_EQ(study.rounds, 3);
  EXPECT_EQ(study.sites.front().name, "site 1");
  EXPECT_EQ(study.observations.front().site, "site 1");
  EXPECT_EQ(study.observations.front().name, "stops");
  EXPECT_EQ(study.parameters.front().range, (std::vector<double>{20, 40}));
}

TEST(Study, ReportsAllProblemsInTheirPlaces) {
  EXPECT_EQ(
      refusal(R"(
draws = 10
[[site]]
project = "slope.toml"
[[observations]]
stop = "stops.csv"
[[parameter]]
path = "material.Scree.friction_angle_deg"
range = [40, 20]
[[parameter]]
path = "material.Scree.roughness_deg"
prior = { mean = 5 }
sites = ["site 2"]
)"),
      "study.toml:2: draws is 10 (fewer cannot represent a posterior; expected 50 to 1e6)\n"
      "study.toml:5: [[observations]] 1: stops, marks, values or zones is missing (observations come from a file). "
      "Write stops = \"stops.csv\"\n"
      "study.toml:6: observations 1: unknown key \"stop\". Did you mean \"stops\"?\n"
      "study.toml:9: [[parameter]] 1: range is [40, 20] (expected [least, greatest]). Exchange the two\n"
      "study.toml:12: [[parameter]] 2: prior is a single value (it would not vary). Add distribution "
      "= \"normal\" and std_dev, or write range = [least, greatest]\n"
      "study.toml:13: [[parameter]] 2: there is no site \"site 2\". Did you mean \"site 1\"?");
}

TEST(Study, NeedsSitesObservationsAndParameters) {
  EXPECT_EQ(refusal("name = \"a\"\n"),
            "study.toml: [[site]] is missing (a study needs at least one)\n"
            "study.toml: [[observations]] is missing (a study needs at least one)\n"
            "study.toml: [[parameter]] is missing (a study needs at least one)");
}

TEST(Study, HasEveryKeyInTheDocumentation) {
  std::ifstream in(talus::places::in_source("/docs/calibration.md"));
  std::ostringstream page;
  page << in.rdbuf();
  for (const project::Table& table : study_tables()) {
    const std::string heading = table.key.empty() ? "| key |" : "`[[" + std::string(table.key) + "]]`";
    EXPECT_NE(page.str().find(heading), std::string::npos) << heading;
    for (const project::Setting& setting : table.settings)
      EXPECT_NE(page.str().find("| `" + std::string(setting.key) + "` |"), std::string::npos) << setting.key;
  }
}

class StudyFiles : public testing_tools::InputFolder {
 protected:
  StudyFiles() { write("slope.toml", two_part_slope); }
  std::string problems_of(const std::string& study, const std::string& stops) {
    write("stops.csv", stops);
    write("study.toml", study);
    warnings_ = {};
    return refusal_of([&] { const PreparedStudy prepared(read_study(path("study.toml")).study, nullptr, warnings_); });
  }
};

TEST_F(StudyFiles, RefuseObservationsOffTheTerrain) {
  EXPECT_EQ(problems_of(small, "x_m\n90\n310\n"),
            "stops.csv:3: x = 310 is off the terrain (the section extends from x = 0 to 300)\n"
            "stops.csv: 1 of 2 observations is off the terrain. Leave out what lies off the terrain, or extend the "
            "terrain");
  EXPECT_EQ(problems_of(small, "x_m\n2600000\n"),
            "stops.csv:2: x = 2600000 is off the terrain (the section extends from x = 0 to 300)\n"
            "stops.csv: 1 of 1 observations is off the terrain (they may be in another coordinate system). "
            "Give x along the section, as its vertices have it");
}

TEST_F(StudyFiles, RefuseTablesThatCannotBeRead) {
  EXPECT_EQ(problems_of(small, "runout\n5\n"),
            "stops.csv:1: there is no column x_m (the columns are runout). Name the columns of the coordinates x_m and "
            "y_m, in metres");
  EXPECT_EQ(problems_of(small, "x_m,z_m\n5,0\n7\nabc,1\n"),
            "stops.csv:3: the row has 1 value (the file has 2 columns). Numbers have a decimal point; or separate "
            "values by semicolons");
  EXPECT_EQ(problems_of(small, "x_m\n90\nabc\n"), "stops.csv:3: x_m: \"abc\" is not a number");
  EXPECT_EQ(problems_of(small, "# nothing\n"),
            "stops.csv: there are no observations (expected a line of column names, and a row for each rock)");
}

TEST_F(StudyFiles, RefuseMoreParametersThanObservations) {
  const std::string two = small + "[[parameter]]\npath = \"material.Scree.roughness_deg\"\nrange = [0, 9]\n";
  EXPECT_EQ(problems_of(two, "x_m\n90\n"),
            "study.toml: 2 parameters are sought from 1 observation (there must be at least as many observations). Fix "
            "some parameters in the projects, or share them between materials and sites");
}

TEST_F(StudyFiles, RefuseRangesOutsideWhatASettingMayBe) {
  EXPECT_EQ(problems_of(replaced(small, "[20, 40]", "[20, 95]"), "x_m\n90\n"),
            "study.toml:8: parameter \"material.Scree.friction_angle_deg\": range is [20, 95] (the setting may be 0 to "
            "89.9)");
}

TEST_F(StudyFiles, WarnOfParametersThatNothingDependsOn) {
  EXPECT_EQ(problems_of(replaced(small, "friction_angle_deg", "forest_height_m"), "x_m\n90\n"),
            "study.toml:8: parameter \"material.Scree.forest_height_m\": is not given in the project (a study varies "
            "numbers that are). Give it a value there");
  EXPECT_EQ(problems_of(replaced(small, "material.Scree.friction_angle_deg", "analysis.max_time_s") + "", "x_m\n90\n"),
            "was read");
  EXPECT_NE(warnings().find("no rock depends on it (all rocks move the same with its smallest and its largest value). "
                            "Leave it out"),
            std::string::npos)
      << warnings();
}

TEST_F(StudyFiles, RefuseColumnsInOtherUnits) {
  EXPECT_EQ(
      problems_of(small, "x_ft\n300\n"),
      "stops.csv:1: column \"x_ft\" has another unit (the unit is in the name; expected x_m). Convert it, and name "
      "it x_m");
  EXPECT_EQ(problems_of(small, "lat,lon\n47.1,11.2\n"),
            "stops.csv:1: there is no column x_m (the columns are lat, lon). Degrees are read from points of a "
            "GeoPackage, Shapefile or GeoJSON");
  const std::string values = replaced(small, "stops = \"stops.csv\"", "values = \"stops.csv\"\nat = \"Road\"");
  EXPECT_EQ(problems_of(values, "height,energy_J\n3,4000\n"),
            "stops.csv:1: column \"height\" has no unit (the unit is in the name; expected height_m). Convert it, and "
            "name it height_m\n"
            "stops.csv:1: column \"energy_J\" has another unit (the unit is in the name; expected energy_kJ). Convert "
            "it, and name it energy_kJ");
  EXPECT_EQ(problems_of(values, "velocity_m_s,energy_kJ\n12,-3\n"),
            "stops.csv:2: energy_kJ is -3 (expected 0 or more)");
  EXPECT_EQ(problems_of(values, "velocity_m_s,energy_kJ\n12,30000\n"), "was read");
  EXPECT_NE(warnings().find("the energies and velocities imply rocks of 4.17e+05 kg (the simulated rocks have 300 kg). "
                            "Check the units"),
            std::string::npos)
      << warnings();
  EXPECT_EQ(problems_of(replaced(values, "Road", "Bridge"), "velocity_m_s\n12\n"),
            "study.toml:6: observations \"stops\": at is \"Bridge\" (the project has no collector or barrier of this "
            "name). Add a [[collector]] \"Bridge\" to the project");
}

TEST_F(StudyFiles, WarnOfColumnsThatAreNotRead) {
  EXPECT_EQ(problems_of(small, "x_m,y_m,release_no,remark\n90,3,7,wet\n"), "was read");
  EXPECT_NE(warnings().find("stops.csv:1: warning: column \"release_no\" is not read. Did you mean \"release\"?\n"
                            "stops.csv:1: warning: column y_m is not read (a section has x alone)"),
            std::string::npos)
      << warnings();
  EXPECT_EQ(warnings().find("remark"), std::string::npos);
}

TEST_F(StudyFiles, RefuseFilesThatAreNotThere) {
  const std::string lacking = replaced(replaced(small, "slope.toml", "slop.toml"), "stops.csv", "a/stop.csv");
  EXPECT_EQ(
      problems_of(lacking, "x_m\n90\n"),
      "study.toml:4: site \"site 1\": project is \"slop.toml\" (there is no such file). Paths are relative to the "
      "study file\n"
      "study.toml:6: observations \"stop\": stops is \"a/stop.csv\" (there is no such file). Paths are relative to "
      "the study file");
  EXPECT_EQ(refusal_of([&] { static_cast<void>(read_study(path("none.toml"))); }), "none.toml: there is no such file");
}

TEST_F(StudyFiles, RefuseFilesOfAnotherKind) {
  EXPECT_EQ(refusal(two_part_slope),
            "study.toml: this is a project (expected the study of a calibration). Name it in a study, as project of a "
            "[[site]]");
  EXPECT_EQ(refusal(replaced(small, "[[observations]]", "[[result]]")),
            "study.toml: this is the study of a sensitivity analysis (expected the study of a calibration). Use talus "
            "sensitivity");
  EXPECT_EQ(refusal_of([&] { static_cast<void>(project::read_project_text(small, "study.toml", {})); }),
            "study.toml: this is the study of a calibration (expected a project). Use talus calibrate");
}

TEST_F(StudyFiles, RefuseMoreFoldsThanObservations) {
  EXPECT_EQ(problems_of("folds = 3" + small, "x_m\n90\n80\n"),
            "study.toml: folds is 3 (no file has more than 2 observations to divide). Use 2 at most");
  EXPECT_EQ(problems_of("folds = 2" + small, "x_m\n90\n80\n"), "was read");
}

TEST_F(StudyFiles, RefuseMistypedColumns) {
  const auto refused = [](const std::string& column, const std::string& meant) {
    return "stops.csv:1: column \"" + column + "\" is not known (it would not be read, and there is no column " +
           meant + "). Name it " + meant + ", or otherwise if it is something else";
  };
  EXPECT_EQ(problems_of(small, "x_m,relase,block,mas_kg\n90,Cliff,7,20\n"),
            refused("relase", "release") + "\n" + refused("mas_kg", "mass_kg"));
  EXPECT_EQ(problems_of(small, "x_m,Seeders\n90,Cliff\n"), refused("Seeders", "seeder"));
  // The table has what a similar name might have meant; a stop's rock is a note.
  EXPECT_EQ(problems_of(small, "x_m,mass_kg,mase_kg,rock_nr\n90,300,1,2\n"), "was read");
  const std::string marks = replaced(small, "stops = ", "marks = ");
  EXPECT_EQ(problems_of(marks, "x_m,rock_nr\n90,1\n"), refused("rock_nr", "rock_id"));
  const std::string values = replaced(small, "stops = \"stops.csv\"", "values = \"stops.csv\"\nat = \"Road\"");
  EXPECT_EQ(problems_of(values, "velocity_m_s,energi_kJ\n12,9\n"), refused("energi_kJ", "energy_kJ"));
}

TEST_F(StudyFiles, WarnOfStopsAboveTheGround) {
  EXPECT_EQ(problems_of(small, "x_m,z_m\n90,-40\n91,-43.9\n92,-44\n93,-44\n94,-44\n95,-44\n"), "was read");
  EXPECT_EQ(warnings(),
            "stops.csv: warning: 1 of 6 observed stops is more than 1 m above or below the terrain (up to 3.8 m). "
            "Compare their heights and coordinates with the terrain");
}

}  // namespace
}  // namespace talus::calibration
