// Ensembles of rocks with different parameters: each rock is that of a project with the parameters of its ensemble.

#include "talus/model/build_ensembles.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>

#include "support/input_folder.hpp"
#include "support/projects.hpp"
#include "talus/campaign/simulate.hpp"
#include "talus/model/fingerprint.hpp"
#include "talus/model/fixed_columns.hpp"
#include "talus/model/model.hpp"
#include "talus/project/read.hpp"

namespace talus::project {
namespace {

using testing_tools::replaced;

const std::string scree = R"(
[terrain]
section = [[0, 0], [10, -10], [100, -10]]
[[material]]
name = "Scree"
normal_restitution = { mean = 0.4, distribution = "normal", std_dev = 0.04 }
tangential_restitution = 0.8
friction_angle_deg = 30
[[seeder]]
type = "point"
position = [1, 5]
mass_kg = 100
rocks = 400
)";

class BuildEnsembles : public testing_tools::InputFolder {
 protected:
  Model built(const std::string& sample, const std::string& settings = "ensembles = 10\n") {
    write("posterior.csv", sample);
    write("slope.toml", scree + "[sampling]\nparameters = \"posterior.csv\"\n" + settings);
    warnings_ = {};
    const Reading reading = read_project(path("slope.toml"), {});
    return build_model(reading.project, warnings_);
  }
  std::string refusal(const std::string& sample) {
    return refusal_of([&] { static_cast<void>(built(sample)); });
  }
  Problems warnings_;
};

const std::string two_sets =
    "weight,score,material.Scree.normal_restitution.mean,material.Scree.friction_angle_deg\n3,-1.5,0.2,35\n"
    "1,-2,0.6,20\n";

TEST_F(BuildEnsembles, DrawsSetsByTheirWeights) {
  const Model model = built(two_sets, "ensembles = 100\n");
  ASSERT_EQ(model.drawn_parameters.size(), 100u);
  std::map<double, int> drawn;
  for (const auto& set : model.drawn_parameters) ++drawn[set[0]];
  EXPECT_EQ(drawn[0.2], 75);
  EXPECT_EQ(drawn[0.6], 25);
  EXPECT_EQ(model.uncertain,
            (std::vector<std::string>{"material.Scree.normal_restitution.mean", "material.Scree.friction_angle_deg"}));
  EXPECT_EQ(built("material.Scree.normal_restitution,weight\n0.1,0\n0.5,2\n").drawn_parameters.front()[0], 0.5);
}

TEST_F(BuildEnsembles, GiveEachRockTheParametersOfItsEnsemble) {
  const Model model = built(two_sets);
  Simulator simulator(model);
  for (const auto& [restitution, angle] : {std::pair{"0.2", "35"}, {"0.6", "20"}}) {
    const Reading alone =
        read_project_text(scree, "slope.toml",
                          {.settings = {std::string("material.0.normal_restitution.mean=") + restitution,
                                        std::string("material.0.friction_angle_deg=") + angle}});
    Problems none;
    const Model known = build_model(alone.project, none);
    Simulator with_known(known);
    int rocks = 0;
    for (std::uint64_t rock = 0; rock < 400; ++rock) {
      if (model.drawn_parameters[rock % 10][0] != std::stod(restitution)) continue;
      const RockRecord one = simulator.simulate(rock, false), other = with_known.simulate(rock, false);
      EXPECT_EQ(one.outcome.end.position, other.outcome.end.position);
      EXPECT_EQ(one.outcome.max_kinetic_energy, other.outcome.max_kinetic_energy);
      ++rocks;
    }
    EXPECT_GT(rocks, 50);
  }
}

// In lanes, several rocks of different ensembles are in progress together.
TEST_F(BuildEnsembles, AreTheSameRockByRockAndTogether) {
  const Model model = built(two_sets);
  Simulator together(model), single(model);
  std::vector<Vec3> ends;
  SimulationOrder order;
  order.rocks = {0, 400};
  order.keep_rows = [](std::uint64_t) { return false; };
  order.see = [&](const RockRecord& record, const RockLog&) { ends.push_back(record.outcome.end.position); };
  EXPECT_EQ(together.simulate(order), 400u);
  for (std::uint64_t rock = 0; rock < 400; rock += 7)
    EXPECT_EQ(single.simulate(rock, false).outcome.end.position, ends[rock]) << rock;
}

TEST_F(BuildEnsembles, AreOnesOfTheFingerprint) {
  const nlohmann::ordered_json same = "project";
  const std::string once = fingerprint_of(same, built(two_sets));
  EXPECT_EQ(fingerprint_of(same, built(two_sets)), once);
  EXPECT_NE(fingerprint_of(same, built("material.Scree.normal_restitution\n0.3\n0.4\n")), once);
}

TEST_F(BuildEnsembles, WarnOfWhatTheyCannotShow) {
  static_cast<void>(built(two_sets, "ensembles = 100\n"));
  EXPECT_EQ(
      without_folder(warnings_.text()),
      "slope.toml: warning: [sampling]: an ensemble has 4 of 400 rocks (the parts of rocks and parameters cannot be "
      "separated). Run more rocks, or fewer ensembles");
  static_cast<void>(built("material.Scree.normal_restitution.mean\n0.3\n"));
  EXPECT_EQ(without_folder(warnings_.text()),
            "slope.toml: warning: [sampling]: all ensembles have the same parameters (one row has all of the weight)");
}

TEST_F(BuildEnsembles, WarnOfAMeanWhoseDistributionStays) {
  static_cast<void>(built("material.Scree.normal_restitution\n0.3\n0.4\n"));
  EXPECT_EQ(without_folder(warnings_.text()),
            "slope.toml:15: warning: [sampling]: parameters posterior.csv:1: material.Scree.normal_restitution: is the "
            "mean of a distribution in the project (rocks of an ensemble also draw about its value). If that is meant, "
            "name the column material.Scree.normal_restitution.mean; else give the project a plain number");
  warnings_ = {};
  static_cast<void>(built("weight,score,material.Scree.normal_restitution\n1,0.2,0.3\n1,0.1,0.4\n"));
  EXPECT_EQ(warnings_.text(), "") << "talus calibrate seeks means";
}

const std::string two_sites =
    "weight,score,material.Scree.normal_restitution@half A,material.Scree.normal_restitution@half B,"
    "material.Scree.friction_angle_deg\n1,0.1,0.3,0.5,25\n1,0.2,0.3,0.5,25\n";

TEST_F(BuildEnsembles, TakeTheColumnsOfTheirSite) {
  const auto of_site = [&](const std::string& site) {
    return built(two_sites, "ensembles = 10\nparameters_site = \"" + site + "\"\n").drawn_parameters.front();
  };
  EXPECT_EQ(of_site("half A"), (std::vector{0.3, 25.0}));
  const Model model = built(two_sites, "ensembles = 10\nparameters_site = \"half B\"\n");
  EXPECT_EQ(model.drawn_parameters.front(), (std::vector{0.5, 25.0}));
  EXPECT_EQ(model.uncertain,
            (std::vector<std::string>{"material.Scree.normal_restitution", "material.Scree.friction_angle_deg"}));
}

TEST_F(BuildEnsembles, TakeTheOnlyColumnsThatFit) {
  // The project has no ground "Rock".
  EXPECT_EQ(built("weight,score,material.Rock.normal_restitution@north,material.Scree.normal_restitution@south,"
                  "material.Scree.friction_angle_deg@north@south\n1,0.1,0.3,0.5,25\n")
                .drawn_parameters.front(),
            (std::vector{0.5, 25.0}));
  EXPECT_EQ(built("score,material.Scree.normal_restitution@south\n1,0.5\n").drawn_parameters.front(), std::vector{0.5});
}

TEST_F(BuildEnsembles, TakeNamesOfMaterialsWithAnAt) {
  write("posterior.csv", "score,material.a@b.friction_angle_deg@south@north\n1,31\n");
  write("slope.toml", testing_tools::replaced(scree, "\"Scree\"", "\"a@b\"") +
                          "[sampling]\nparameters = \"posterior.csv\"\nparameters_site = \"north\"\n");
  const Reading reading = read_project(path("slope.toml"), {});
  EXPECT_EQ(build_model(reading.project, warnings_).drawn_parameters.front(), std::vector{31.0});
}

TEST_F(BuildEnsembles, RefuseColumnsOfUnclearSites) {
  EXPECT_EQ(
      refusal(two_sites),
      "slope.toml:15: [sampling]: parameters posterior.csv:1: has columns of the sites \"half A\", \"half B\" (it "
      "is not clear which one the project is). Write parameters_site = \"half A\" in [sampling]");
  const auto with_site = [&](const std::string& sample) {
    return refusal_of([&] { static_cast<void>(built(sample, "parameters_site = \"half C\"\n")); });
  };
  EXPECT_EQ(
      with_site(two_sites),
      "slope.toml: [sampling]: parameters_site is \"half C\" (posterior.csv has columns of \"half A\", \"half B\"). "
      "Did you mean \"half A\"?");
  EXPECT_EQ(
      with_site(two_sets),
      "slope.toml: [sampling]: parameters_site is \"half C\" (the columns of posterior.csv are those of all sites). "
      "Leave it out");
  EXPECT_EQ(
      refusal("wieght,material.Scree.normal_restitution\n1,0.3\n"),
      "slope.toml:15: [sampling]: parameters posterior.csv:1: column \"wieght\" is not known (it would not be read, "
      "and there is no column weight). Name it weight, or otherwise if it is something else");
}

TEST_F(BuildEnsembles, ReadTablesOfOtherPrograms) {
  const Model model = built("\xEF\xBB\xBFWeight;material.Scree.friction_angle_deg\r\n0;20\r\n\r\n2,5;30,5\r\n");
  EXPECT_EQ(model.drawn_parameters, std::vector(10, std::vector{30.5}));
}

const std::string at = "slope.toml:15: [sampling]: parameters posterior.csv";

TEST_F(BuildEnsembles, RefuseABadSample) {
  EXPECT_EQ(refusal("weight,material.Screes.normal_restitution,material.Scree.restitution\n1,0.3,1\n"),
            at +
                ":1: material.Screes.normal_restitution: names no [[material]] "
                "(the project has \"Scree\"). Use a name, a number from 0, or * for all\n" +
                at + ":1: material.Scree.restitution: is no setting ([[material]] has no key restitution)");
  EXPECT_EQ(refusal("weight,material.Scree.normal_restitution\n1,0.3\n-2,0.3\n1,1.3\n"),
            at + ":3: weight is -2 (a weight is not negative)\n" + at +
                ":4: material.Scree.normal_restitution is 1.3; expected 0 to 1");
  EXPECT_EQ(refusal("weight,material.Scree.normal_restitution\n"),
            at + ": has no rows (each row is a set of parameters)");
  EXPECT_EQ(refusal("weight,material.Scree.normal_restitution\n0,0.3\n"),
            at + ": weight is 0 in all rows (sets are drawn by weight)");
  EXPECT_EQ(refusal("weight,score\n1,2\n"),
            at + ":1: has no column of a parameter (a column is named by the path of its setting). For example "
                 "material.Scree.normal_restitution");
  EXPECT_EQ(refusal("analysis.max_time_s\n100\n"),
            at + ":1: analysis.max_time_s cannot differ between rocks (all rocks of a run share it). Leave the column "
                 "out");
  EXPECT_EQ(refusal("material.Scree.normal_restitution,material.*.normal_restitution\n0.3,0.4\n"),
            at + ":1: material.Scree.normal_restitution and material.*.normal_restitution give the same number (it is "
                 "not clear which one applies). Leave one of them out");
  EXPECT_EQ(refusal(""), at + ": is empty (its first line must name the columns)");
}

TEST_F(BuildEnsembles, RefuseAllValuesThatAreNone) {
  EXPECT_EQ(refusal("weight,material.Scree.normal_restitution\n1,high\nnan,0.3\n1,\n1,inf\n"),
            at + ":2: material.Scree.normal_restitution is \"high\" (expected a finite number)\n" + at +
                ":3: weight is \"nan\" (expected a finite number)\n" + at +
                ":4: material.Scree.normal_restitution is empty (expected a finite number)\n" + at +
                ":5: material.Scree.normal_restitution is \"inf\" (expected a finite number)");
}

TEST_F(BuildEnsembles, RefuseMoreEnsemblesThanRocks) {
  EXPECT_EQ(refusal_of([&] { static_cast<void>(built(two_sets, "ensembles = 401\n")); }),
            "slope.toml: [sampling]: ensembles is 401 (seeder \"seeder 1\" has 400 rocks, and each ensemble needs "
            "one). Run more "
            "rocks, or fewer ensembles");
}

// What grows with the terrain or the releases is not copied for each ensemble.
TEST_F(BuildEnsembles, ShareWhatGrowsWithTheTerrain) {
  std::string text = scree;
  const std::string section = "section = [[0, 0], [10, -10], [100, -10]]\n";
  text.replace(text.find(section), section.size(), section + "[ground]\nsegments = [\"Scree\", \"Rock\"]\n");
  write("posterior.csv", two_sets);
  write("slope.toml", text + "[[material]]\nname = \"Rock\"\n[sampling]\nparameters = \"posterior.csv\"\n");
  const Reading reading = read_project(path("slope.toml"), {});
  const Model model = build_model(reading.project, warnings_);
  ASSERT_EQ(model.ensembles.size(), 50u);
  for (const Model& each : model.ensembles) {
    EXPECT_EQ(&*each.seeders.front().where, &*model.seeders.front().where);
    EXPECT_EQ(each.ground.material_of(1).index, 1u);
  }
}

TEST_F(BuildEnsembles, RefuseASampleOfOtherLaws) {
  const std::string sample =
      "weight,score,material.Scree.friction_angle_deg,fixed:analysis.scale_rn_by_velocity,fixed:analysis.gravity_m_s2,"
      "fixed:material.Ice.roughness_deg.mean,fixed:forest.Spruce.drag_kg_s\n";
  const std::string found = at + ":2: its study has ", why =
                                                           ", and slope.toml has true (its parameters were found with "
                                                           "that value). Give the project this value, or calibrate "
                                                           "with that of the project";
  EXPECT_EQ(refusal(sample + "1,0.2,30,FALSE,9.80665,3,400\n1,0.2,31,FALSE,9.80665,3,400\n"),
            found + "analysis.scale_rn_by_velocity = FALSE" + why);
  EXPECT_EQ(built(sample + "1,0.2,30,True,9.80665,3,400\n").ensembles.size(), 10u)
      << "it has no material Ice and no forest Spruce";
  EXPECT_EQ(refusal(sample + "1,0.2,30,true,9.80665,3,400\n1,0.2,30,false,9.80665,3,400\n"),
            at +
                ":3: fixed:analysis.scale_rn_by_velocity is false (the first row has true). Keep the sets of one study "
                "in one file");
  EXPECT_EQ(refusal("score,material.Scree.friction_angle_deg,fixed:analysis.wind\n0.2,30,5\n"),
            at + ":2: its study has analysis.wind = 5, and slope.toml has none (its parameters were found with that "
                 "value). Give the project this value, or calibrate with that of the project");
}

TEST_F(BuildEnsembles, RefuseASampleOfOtherForests) {
  const std::string section = "section = [[0, 0], [10, -10], [100, -10]]\n";
  const std::string wooded = replaced(replaced(scree, section, section + "width_m = 20\n"), "[1, 5]", "[1, 10, 5]") +
                             "[[forest]]\nname = \"Spruce\"\ndrag_kg_s = 300\nheight_m = 8\n"
                             "polygon = [[20, 0], [60, 0], [60, 20], [20, 20]]\n"
                             "[sampling]\nparameters = \"posterior.csv\"\nensembles = 10\n";
  write("slope.toml", wooded);
  const Reading reading = read_project(path("slope.toml"), {});
  const auto built_with = [&](const std::string& drag) {
    write("posterior.csv",
          "score,material.Scree.friction_angle_deg,fixed:forest.Spruce.drag_kg_s,fixed:forest.Beech.height_m\n0.2,30," +
              drag + ",12\n");
    return build_model(reading.project, warnings_).ensembles.size();
  };
  EXPECT_EQ(built_with("300"), 10u);
  EXPECT_EQ(refusal_of([&] { static_cast<void>(built_with("400")); }),
            "slope.toml:21: [sampling]: parameters posterior.csv:2: its study has forest.Spruce.drag_kg_s = 400, and "
            "slope.toml has 300.0 (its parameters were found "
            "with that value). Give the project this value, or calibrate with that of the project");

  Project set = reading.project;
  set.forests.front().drag_kg_s = 400;
  const std::vector<FixedSetting> fixed = fixed_settings(set, &reading.project, {});
  EXPECT_TRUE(std::ranges::any_of(
      fixed, [](const FixedSetting& each) { return each.path == "forest.Spruce.drag_kg_s" && each.value == "400.0"; }));
  EXPECT_TRUE(
      std::ranges::none_of(fixed, [](const FixedSetting& each) { return each.path == "forest.Spruce.height_m"; }));
}

// Sites of a study may have other laws. A project is that of its site, or of any whose laws it has.
TEST_F(BuildEnsembles, TakeTheLawsOfTheirSite) {
  const std::string sample =
      "score,material.Scree.friction_angle_deg,fixed:analysis.scale_rn_by_velocity@north,"
      "fixed:analysis.scale_rn_by_velocity@south\n0.2,30,false,";
  EXPECT_EQ(built(sample + "true\n").ensembles.size(), 10u);
  EXPECT_EQ(
      refusal(replaced(sample + "true\n", "friction_angle_deg", "friction_angle_deg@north")),
      at + ":2: its study has analysis.scale_rn_by_velocity = false at site \"north\", and slope.toml has true (its "
           "parameters were found with that value). Give the project this value, or calibrate with that of the "
           "project");
}

TEST_F(BuildEnsembles, RefuseAMissingFile) {
  write("slope.toml", scree + "[sampling]\nparameters = \"none.csv\"\n");
  const Reading reading = read_project(path("slope.toml"), {});
  EXPECT_THAT(refusal_of([&] { static_cast<void>(build_model(reading.project, warnings_)); }),
              ::testing::HasSubstr("there is no such file"));
}

}  // namespace
}  // namespace talus::project
