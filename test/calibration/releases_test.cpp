// Observed rocks that name their releases, masses and rocks.

#include "talus/calibration/releases.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "calibration/slope.hpp"
#include "support/input_folder.hpp"
#include "support/projects.hpp"
#include "talus/calibration/calibrate.hpp"

namespace talus::calibration {
namespace {

using testing_tools::replaced;

const std::string table_slope = scree_slope + R"(
[[seeder]]
name = "Field"
type = "table"
table = "releases.csv"
rocks = 60
)";

const std::string matched_study = R"(
rocks = 60
draws = 200
[[site]]
project = "slope.toml"
[[observations]]
stops = "stops.csv"
[[parameter]]
path = "material.Scree.tangential_restitution"
range = [0.6, 0.95]
)";

class Releases : public testing_tools::InputFolder {
 protected:
  Releases() {
    write("slope.toml", table_slope);
    write("releases.csv", "name,x_m,z_m,mass_kg\nR1,1,3,300\nR2,20,-17,500\nR3,45,-39,900\n");
    write("study.toml", matched_study);
  }
  PreparedStudy prepared() {
    warnings_ = {};
    return {read_study(path("study.toml")).study, nullptr, warnings_};
  }
  std::string problems_of(const std::string& stops) {
    write("stops.csv", stops);
    return refusal_of([&] { static_cast<void>(prepared()); });
  }
};

TEST_F(Releases, AreSeedersOrRowsOfTheirTables) {
  EXPECT_EQ(problems_of("x_m,release\n95,R3\n80,R1\n90,R3\n99,R3\n98,R1\n"), "was read");
  const PreparedStudy study = prepared();
  const ObservedGroup& group = study.groups().front();
  EXPECT_EQ(group.releases.names, (std::vector<std::string>{"R3", "R1"}));
  EXPECT_EQ(group.sample.strata, (std::vector<std::uint32_t>{0, 1, 0, 0, 1}));
  // Runouts are from the rock's own release; R2 was not observed, and its rocks are not compared.
  EXPECT_NEAR(group.sample.rows(0, 0), 95 - 45, 1e-9);
  EXPECT_NEAR(group.sample.rows(1, 0), 80 - 1, 1e-9);
  const study::SetOutcome outcome = study.sites().front().run({}, {});
  const Sample simulated = simulated_sample(group, outcome);
  EXPECT_EQ(simulated.rows.rows(), 40);
  EXPECT_EQ(problems_of("x_m,release\n95,Field\n80,Field\n"), "was read");
}

TEST_F(Releases, AreRefusedIfTheyAreNotThere) {
  EXPECT_EQ(problems_of("x_m,release\n95,R3\n80,R12\n70,\n"),
            "stops.csv:3: there is no release \"R12\" (the column release names a seeder, or a row of its table). Did "
            "you mean \"R1\"?");
  EXPECT_EQ(
      problems_of("x_m,release\n95,R12\n80,R3\n70,R12\n71,R12\n"),
      "stops.csv:2: there is no release \"R12\", which 2 rows name as well (the column release names a seeder, or a "
      "row of its table). Did you mean \"R1\"?");
  EXPECT_EQ(problems_of("x_m,release\n95,R3\n80,\n"),
            "stops.csv: 1 of 2 rocks has a release (either all or none). Put rocks of unknown releases into another "
            "file, as observations of their own");
  EXPECT_EQ(problems_of("x_m,release\n95,R3\n80,Field\n"),
            "stops.csv: \"R3\" and \"Field\" are the same releases (one is a seeder, the other a row of its table). "
            "Name the rows, or the seeder, in all observations");
}

TEST_F(Releases, NeedSimulatedRocks) {
  write("slope.toml", replaced(table_slope, "rocks = 60", "rocks = 30"));
  write("study.toml", replaced(matched_study, "rocks = 60", "rocks = 30"));
  EXPECT_EQ(problems_of("x_m,release\n95,R3\n80,R1\n"), "was read");
  EXPECT_NE(warnings().find("stops.csv: warning: the release \"R3\" has 10 simulated rocks (each observed rock is "
                            "compared with those of its release: 5 at least, 20 are better). Write rocks = 60 in the "
                            "study"),
            std::string::npos)
      << warnings();
}

TEST_F(Releases, HaveTheObservedMasses) {
  EXPECT_EQ(problems_of("x_m,release,mass_kg\n95,R3,0.9\n80,R1,300\n"), "was read");
  EXPECT_NE(
      warnings().find("1 of 2 observed masses differs from those of their releases (the rock of \"R3\" has 0.9 kg, "
                      "its release 900 kg). Check the unit"),
      std::string::npos)
      << warnings();
  EXPECT_EQ(
      problems_of("x_m,release,mass_t\n95,R3,0.9\n80,R1,3\n"),
      "stops.csv:1: column \"mass_t\" has another unit (the unit is in the name; expected mass_kg). Convert it, and "
      "name it mass_kg");
  EXPECT_EQ(problems_of("x_m,release,mass_kg\n95,R3,-9\n80,R1,3\n"),
            "stops.csv:2: mass_kg is -9 (expected more than 0). Leave it empty if it is not known");
}

TEST_F(Releases, CompareRocksOfSimilarMass) {
  write("slope.toml", replaced(table_slope, "type = \"table\"\ntable = \"releases.csv\"",
                               "type = \"point\"\nposition = [1, 3]\nmass_kg = { mean = 300, distribution = "
                               "\"lognormal\", std_dev = 200 }"));
  write("study.toml", replaced(matched_study, "rocks = 60", "rocks = 120"));
  std::string stops = "x_m,mass_kg\n";
  for (int k = 0; k < 10; ++k) stops += std::to_string(80 + k) + "," + std::to_string(150 + 40 * k) + "\n";
  EXPECT_EQ(problems_of(stops), "was read");
  const PreparedStudy study = prepared();
  const ReleaseStrata& strata = study.groups().front().releases;
  ASSERT_EQ(strata.mass_bounds.size(), 1U);
  EXPECT_NEAR(strata.mass_bounds[0], std::sqrt(310.0 * 350), 1e-9);
  EXPECT_EQ(strata.class_of(310), 0U);
  EXPECT_EQ(strata.class_of(350), 1U);
  EXPECT_EQ(problems_of(replaced(stops, ",150", ",150000")), "was read");
  EXPECT_NE(warnings().find("the observed masses are 190 to 1.5e+05 kg"), std::string::npos) << warnings();
}

TEST_F(Releases, OfMarksAreTakenRockByRock) {
  write("study.toml", replaced(matched_study, "stops = \"stops.csv\"", "marks = \"stops.csv\""));
  EXPECT_EQ(problems_of("x_m,rock\n45,b\n60,a\n50,b\n"), "was read");
  const PreparedStudy study = prepared();
  EXPECT_EQ(study.groups().front().sample.rocks, (std::vector<std::uint32_t>{0, 0, 1}));
  EXPECT_EQ(study.groups().front().count(), 2U);
  EXPECT_EQ(problems_of("x_m,rock\n45,b\n60,\n50,b\n"),
            "stops.csv: 2 of 3 marks have a rock (either all or none). Put marks of unknown rocks into another file");
  EXPECT_EQ(problems_of("x_m,rock,release\n45,b,R1\n60,a,R1\n50,b,R2\n"),
            "stops.csv:4: rock \"b\" has the releases \"R1\" and \"R2\" (a rock has one)");
  EXPECT_EQ(problems_of("x_m\n45\n60\n50\n"), "was read");
  EXPECT_NE(warnings().find("there is no column rock (marks of one rock are not independent of each other)"),
            std::string::npos)
      << warnings();
}

TEST_F(Releases, AreOutOfReachOneByOne) {
  std::string stops = "x_m,release\n";
  for (int k = 0; k < 8; ++k) stops += std::to_string(80 + k) + ",R1\n";
  write("stops.csv", stops + "44,R3\n");
  const CalibrationResult result = calibrate(prepared());
  EXPECT_NE(result.warnings.text().find("stops, release \"R3\": no parameters within the ranges give a runout of less "
                                        "than"),
            std::string::npos)
      << result.warnings.text();
}

}  // namespace
}  // namespace talus::calibration
