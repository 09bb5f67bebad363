// Models from projects: the exact text of errors that only the terrain reveals, and the properties of the model.

#include "talus/model/model.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "support/projects.hpp"
#include "talus/campaign/simulate.hpp"
#include "talus/project/settings.hpp"
#include "talus/results/summary.hpp"

namespace talus::project {
namespace {

using testing_tools::model_of;
using testing_tools::problems_of_model;
using testing_tools::replaced;

const std::string flat_2d = R"(
[terrain]
section = [[0, 0], [10, -10], [20, -10]]
[[material]]
name = "Rock"
[[seeder]]
type = "point"
position = [1, 5]
mass_kg = 100
)";

const std::string square_3d = R"(
[terrain]
vertices = [[0,0,0],[10,0,0],[10,10,0],[0,10,0]]
triangles = [[0,1,2],[0,2,3]]
[[material]]
name = "Rock"
[[seeder]]
type = "point"
position = [5, 5, 5]
mass_kg = 100
)";

TEST(BuildModel, RefusesASeederOffTheSection) {
  EXPECT_EQ(problems_of_model(replaced(flat_2d, "[1, 5]", "[25, 5]")),
            "slope.toml:6: seeder \"seeder 1\": x = 25 is off the terrain (the section extends from x = 0 to 20)");
}

TEST(BuildModel, RefusesASeederOffTheMesh) {
  EXPECT_EQ(problems_of_model(replaced(square_3d, "[5, 5, 5]", "[5, 15, 5]")),
            "slope.toml:7: seeder \"seeder 1\": (5, 15) is off the terrain (on plan the terrain lies within x = 0 to "
            "10, y = 0 to 10)");
}

TEST(BuildModel, HintsThatRotationAppliesOnlyToTheTerrain) {
  EXPECT_EQ(
      problems_of_model(
          replaced(replaced(square_3d, "[terrain]", "[terrain]\nrotate_deg = 90"), "[5, 5, 5]", "[5, 9, 5]")),
      "slope.toml:8: seeder \"seeder 1\": (5, 9) is off the terrain (on plan the terrain lies within x = -10 to 0, y = "
      "0 to 10). terrain.rotate_deg rotates only the terrain, not the seeders");
}

TEST(BuildModel, RefusesABarrierOffTheTerrain) {
  EXPECT_EQ(problems_of_model(square_3d + "[[barrier]]\nname = \"Fence\"\nline = [[20, 0], [20, 10]]\nheight_m = 2\n"),
            "slope.toml:11: barrier \"Fence\": its line does not touch the terrain (a barrier stands on the ground)");
}

TEST(BuildModel, RefusesABarrierWithoutLength) {
  EXPECT_EQ(
      problems_of_model(square_3d + "[[barrier]]\nname = \"Fence\"\nline = [[5, 5], [5, 5.000001]]\nheight_m = 2\n"),
      "slope.toml:11: barrier \"Fence\": its line is 1e-06 m long (expected at least 1e-05 m)");
}

// In a longer step a rock could fall past the whole terrain.
TEST(BuildModel, LimitsTheTimestepByTheSizeOfTheTerrain) {
  const auto timestep_of = [](const std::string& seconds) {
    Problems warnings;
    return model_of(flat_2d + "[analysis]\nmax_timestep_s = " + seconds + "\n", warnings).laws.timestep;
  };
  EXPECT_EQ(timestep_of("0.01"), 0.01);
  EXPECT_DOUBLE_EQ(timestep_of("1e6"), std::sqrt(2 * std::hypot(20, 10) / standard_gravity));
}

const std::string varied_2d = replaced(
    flat_2d, "section = ", "section_std_dev_m = [[0.5, 0], [0, 0], [1, 0]]\nsection = ");  // certain from 1.5 to 17

TEST(BuildModel, RefusesASeederThatMayBeOffAVariedSection) {
  EXPECT_EQ(problems_of_model(replaced(varied_2d, "[1, 5]", "[1.5, 5]")), "");
  EXPECT_EQ(problems_of_model(varied_2d),
            "slope.toml:7: seeder \"seeder 1\": x = 1 may be off the terrain (if section_std_dev_m moves its ends by 3 "
            "standard deviations, the section extends from x = 1.5 to 17). Move it inwards, or reduce the standard "
            "deviations in x of the end vertices");
  const std::string line =
      replaced(varied_2d, "type = \"point\"\nposition = [1, 5]", "type = \"line\"\npoints = [[2, 5], [18, 5]]");
  EXPECT_NE(problems_of_model(line).find("x = 18 may be off the terrain"), std::string::npos)
      << problems_of_model(line);
}

TEST(BuildModel, RefusesABarrierThatMayBeOffAVariedSection) {
  const std::string good = replaced(varied_2d, "[1, 5]", "[2, 5]");
  EXPECT_EQ(problems_of_model(good + "[[barrier]]\nline = 17\nheight_m = 2\n"), "");
  EXPECT_EQ(problems_of_model(good + "[[barrier]]\nline = 17.5\nheight_m = 2\n"),
            "slope.toml:11: barrier \"barrier 1\": x = 17.5 may be off the terrain (if section_std_dev_m moves its "
            "ends by 3 standard deviations, the section extends from x = 1.5 to 17). Move it inwards, or reduce the "
            "standard deviations in x of the end vertices");
}

TEST(BuildModel, AcceptsAVaryingSectionWithAnOverhang) {
  const std::string overhang =
      replaced(replaced(flat_2d, "[[0, 0], [10, -10], [20, -10]]", "[[0, 0], [10, 0], [9.5, -2], [20, -10]]"),
               "section = ", "section_std_dev_m = [[0, 0], [0.1, 0], [0.1, 0], [0, 0]]\nsection = ");
  EXPECT_EQ(problems_of_model(overhang), "");
}

TEST(BuildModel, WarnsOfTheLengthOfABarrierOffTheTerrain) {
  Problems warnings;
  const std::string text = square_3d + "[[collector]]\nname = \"Edge\"\nline = [[-5, 5], [10, 5]]\nheight_m = 2\n";
  const Model model = model_of(text, warnings);
  EXPECT_EQ(warnings.text(),
            "slope.toml:11: warning: collector \"Edge\": 5 of 15 m of its line are off the terrain (its ends are cut "
            "there, and it crosses a gap in a straight line). Compare its line with the terrain's edge and holes");
  // Stations are measured from the first point of the line.
  const std::vector<Panel>& panels = model.barriers[0].panels();
  EXPECT_NEAR(panels.front().station, 5, 1e-9);
  EXPECT_NEAR(panels.back().station + panels.back().plan_length, 15, 1e-9);
}

TEST(BuildModel, MeasuresStationsAcrossAGapOfTheTerrain) {
  Problems warnings;
  const std::string two_squares =
      replaced(replaced(square_3d, "[0,10,0]]", "[0,10,0],[20,0,0],[30,0,0],[30,10,0],[20,10,0]]"), "[0,2,3]]",
               "[0,2,3],[4,5,6],[4,6,7]]");
  const std::string text = two_squares + "[[barrier]]\nline = [[1, 5], [15, 9], [29, 5]]\nheight_m = 2\n";
  const Model model = model_of(text, warnings);
  const double half = std::hypot(14, 4);  // 5 of 14 are in the gap
  EXPECT_NE(warnings.text().find("barrier \"barrier 1\": 10.4002 of 29.1204 m of its line are off the terrain"),
            std::string::npos)
      << warnings.text();
  const std::vector<Panel>& panels = model.barriers[0].panels();
  EXPECT_EQ(panels.front().station, 0);
  EXPECT_NEAR(panels.back().station + panels.back().plan_length, 2 * half, 1e-9);
  double station = 0;
  for (const Panel& panel : panels) {
    EXPECT_NEAR(panel.station, station, 1e-9);
    station += panel.plan_length;
  }
}

TEST(BuildModel, DoesNotWarnOfABarrierOnTheTerrain) {
  EXPECT_EQ(problems_of_model(square_3d + "[[barrier]]\nline = [[0, 0], [10, 10], [10, 0]]\nheight_m = 2\n"), "");
}

TEST(BuildModel, RefusesAListOfMaterialsOfTheWrongLength) {
  EXPECT_EQ(problems_of_model(replaced(square_3d, "[5, 5, 5]", "[5, 15, 5]") + "[ground]\ntriangles = [0, 0, 0]\n"),
            "slope.toml:12: [ground]: triangles has 3 entries (expected 2, one for each triangle of the terrain)")
      << "inline meshes are checked by the reader";
}

TEST(BuildModel, RefusesAMeshWithoutArea) {
  EXPECT_NE(problems_of_model(
                replaced(square_3d, "[[0,0,0],[10,0,0],[10,10,0],[0,10,0]]", "[[0,0,0],[10,0,0],[20,0,0],[30,0,0]]")),
            "");
}

TEST(BuildModel, LiftsAReleasePointBelowTheSurfaceAndCountsIt) {
  const Model model = model_of(replaced(flat_2d, "[1, 5]", "[1, -5]"));
  Simulator simulator(model);
  const RockRecord record = simulator.simulate(0, false);
  EXPECT_TRUE(record.was_lifted);
  EXPECT_NEAR(record.outcome.start.position.z(), -1, 1e-12);
  EXPECT_FALSE(Simulator(model_of(flat_2d)).simulate(0, false).was_lifted);
}

TEST(BuildModel, LiftsASphereUntilItFits) {
  const Model model =
      model_of(replaced(square_3d, "[5, 5, 5]", "[5, 5, 0.01]") + "[analysis]\nmodel = \"rigid_sphere\"\n");
  const RockRecord record = Simulator(model).simulate(0, false);
  EXPECT_TRUE(record.was_lifted);
  EXPECT_NEAR(record.outcome.start.position.z(), record.body.radius, 1e-9);
}

TEST(BuildModel, LowersASphereFromACeilingAndStopsOneWithoutRoom) {
  const std::string text = replaced(
      replaced(flat_2d, "[[0, 0], [10, -10], [20, -10]]", "[[0, 20], [10, 20], [4, 14.6], [2, 15], [2, 10], [30, 8]]") +
          "[analysis]\nmodel = \"rigid_sphere\"\n",
      "[1, 5]\nmass_kg = 100", "[4, 14.5]\nhorizontal_velocity_m_s = 1\ndiameter_m = 0.5");
  const RockRecord lowered = Simulator(model_of(text)).simulate(0, false);
  EXPECT_TRUE(lowered.was_lifted);
  EXPECT_NEAR(lowered.outcome.start.position.z(), 14.35, 1e-8);
  EXPECT_EQ(lowered.outcome.start.velocity.x(), 1);
  EXPECT_LT(lowered.outcome.end.position.z(), 11);

  const RockRecord caught = Simulator(model_of(replaced(text, "0.5", "5"))).simulate(0, false);
  EXPECT_TRUE(caught.was_lifted);
  EXPECT_EQ(caught.outcome.reason, EndReason::at_rest);
  EXPECT_EQ(caught.outcome.end.position, Vec3(4, 0, 14.5));
  EXPECT_EQ(caught.outcome.end.time, 0);
  EXPECT_EQ(caught.outcome.max_kinetic_energy, 0);
}

TEST(BuildModel, ReleasesRocksOnTheSurfaceAndAboveIt) {
  const Model model = model_of(replaced(flat_2d, "[1, 5]", "[5, \"surface\"]"));
  EXPECT_NEAR(Simulator(model).simulate(0, false).outcome.start.position.z(), -5, 1e-12);
  const Model above = model_of(replaced(square_3d, "position = [5, 5, 5]", "position = [5, 5]\nheight_above_m = 2"));
  EXPECT_NEAR(Simulator(above).simulate(0, false).outcome.start.position.z(), 2, 1e-12);
}

TEST(BuildModel, ReleasesRocksDownEitherSideOfARidge) {
  const Model ridge = model_of(R"(
[terrain]
section = [[-4, 0], [0, 3], [12, -2]]
[[material]]
name = "Rock"
[[seeder]]
name = "West"
position = [-1, 5]
mass_kg = 100
horizontal_velocity_m_s = 2
direction = "downslope"
[[seeder]]
name = "East"
position = [1, 5]
mass_kg = 100
speed_m_s = 13
direction = "downslope"
)");
  Simulator simulator(ridge);
  EXPECT_LT((simulator.simulate(0, false).outcome.start.velocity - Vec3(-2, 0, 0)).norm(), 1e-12);
  EXPECT_LT((simulator.simulate(1, false).outcome.start.velocity - Vec3(12, 0, -5)).norm(), 1e-12);
}

TEST(BuildModel, ReadsASectionFromRightToLeftWithItsMaterials) {
  const std::string two = R"(
[terrain]
section = [[0, 0], [10, -10], [20, -10]]
[[material]]
name = "A"
normal_restitution = 0.1
[[material]]
name = "B"
normal_restitution = 0.2
[ground]
segments = ["A", "B"]
[[seeder]]
type = "point"
position = [1, 5]
mass_kg = 100
)";
  const Model forwards = model_of(two);
  const Model backwards =
      model_of(replaced(replaced(two, "[[0, 0], [10, -10], [20, -10]]", "[[20, -10], [10, -10], [0, 0]]"),
                        "[\"A\", \"B\"]", "[\"B\", \"A\"]"));
  const Vec3 a = Simulator(forwards).simulate(0, false).outcome.end.position;
  const Vec3 b = Simulator(backwards).simulate(0, false).outcome.end.position;
  EXPECT_EQ(a, b);
}

TEST(BuildModel, NumbersTheSegmentsOfAnOverhangAsGiven) {
  const Model overhang = model_of(replaced(flat_2d, "[[0, 0], [10, -10], [20, -10]]", "[[0, 0], [10, -10], [0, -10]]"));
  EXPECT_TRUE(overhang.parts.of_source->empty()) << "in the given order";
}

TEST(BuildModel, GivesTheSameTrajectoriesFarFromTheOrigin) {
  const std::string far =
      replaced(replaced(square_3d, "[[0,0,0],[10,0,0],[10,10,0],[0,10,0]]",
                        "[[2600000,1200000,0],[2600010,1200000,0],[2600010,1200010,0],[2600000,1200010,0]]"),
               "[5, 5, 5]", "[2600005, 1200005, 5]");
  const std::string with_speed = "horizontal_velocity_m_s = 1.25\n";
  const Model near_model = model_of(square_3d + with_speed), far_model = model_of(far + with_speed);
  const auto end = [](const Model& model) {
    return model.frame.global_from_local(Simulator(model).simulate(0, false).outcome.end.position);
  };
  EXPECT_LT((end(far_model) - end(near_model) - Vec3(2600000, 1200000, 0)).norm(), 2e-9);
}

TEST(BuildModel, VariesTheSectionFromRockToRock) {
  const Model model =
      model_of(replaced(flat_2d, "section = ", "section_std_dev_m = [[0, 0], [0, 0.5], [0, 0.5]]\nsection = "));
  ASSERT_TRUE(model.varying);
  Simulator simulator(model);
  EXPECT_NE(simulator.simulate(0, false).outcome.end.position.z(),
            Simulator(model_of(flat_2d)).simulate(0, false).outcome.end.position.z());
}

/// The end points and maximum energies of some rocks.
std::vector<double> ends_of(const std::string& text) {
  const Model model = model_of(text);
  Simulator simulator(model);
  std::vector<double> ends;
  for (std::uint64_t rock = 0; rock < 20; ++rock) {
    const auto outcome = simulator.simulate(rock, false).outcome;
    for (const double x : {outcome.end.position.x(), outcome.end.position.z(), outcome.max_kinetic_energy})
      ends.push_back(x);
  }
  return ends;
}

TEST(BuildModel, SettingsOfOneRockModelAffectOnlyThatModel) {
  const std::map<std::string_view, std::string> others{
      {"rotation", "false"},        {"sliding", "\"closed_form\""},       {"friction_angle", "\"zero\""},
      {"friction_angle_deg", "5"},  {"tangential_crsp_damping", "false"}, {"rolling_resistance_in_impacts", "false"},
      {"dynamic_friction", "0.05"}, {"rolling_friction", "0.4"},
  };
  // Rough ground on which a rock slides, with a bend that it grazes.
  const std::string ground =
      replaced(replaced(replaced(flat_2d, "[10, -10], [20, -10]", "[10, -10], [12, -11.5], [20, -13], [60, -15]"),
                        "name = \"Rock\"", "name = \"Rock\"\nnormal_restitution = 0.4\nroughness_deg = 3"),
               "mass_kg = 100", "mass_kg = 100\nrocks = 20\nhorizontal_velocity_m_s = 2");
  std::size_t tried = 0;
  for (const Table& table : tables()) {
    for (const Setting& setting : table.settings) {
      const auto models = models_of(setting);
      if (models.empty() || models.front() == word(RockModel::rigid_body)) continue;  // those: shapes_test.cpp
      ++tried;
      ASSERT_TRUE(others.contains(setting.key)) << setting.key;
      const std::string line = std::string(setting.key) + " = " + others.at(setting.key) + "\n";
      for (const RockModel model : {RockModel::lumped_mass, RockModel::rigid_sphere}) {
        const std::string analysis = "[analysis]\nmodel = \"" + std::string(word(model)) + "\"\n";
        const auto project = [&](const std::string& more) {
          if (table.key == "analysis") return analysis + more + ground;
          return analysis + replaced(ground, "[[material]]\n", "[[material]]\n" + more);
        };
        const auto before = ends_of(project("")), after = ends_of(project(line));
        if (std::ranges::find(models, word(model)) != models.end()) {
          EXPECT_NE(before, after) << setting.key;
        } else {
          EXPECT_EQ(before, after) << setting.key;
        }
      }
    }
  }
  EXPECT_EQ(tried, others.size());
}

// A rough slope on which rocks of both models bounce, slide and roll.
const std::string rough_slope =
    replaced(replaced(replaced(flat_2d, "[10, -10], [20, -10]", "[10, -10], [12, -11.5], [20, -13], [60, -15]"),
                      "name = \"Rock\"", "name = \"Rock\"\nroughness_deg = 6\nroughness_spacing_m = 2"),
             "mass_kg = 100", "mass_kg = 100\nrocks = 20\nhorizontal_velocity_m_s = 5");

// `laws` is one word for five keys, each of which can still be given.
TEST(BuildModel, OneWordChoosesTheLaws) {
  const std::string spelled =
      "grazing_angle_deg = 0\nroughness_law = \"tilts\"\nscale_rn_by_velocity = false\n"
      "tangential_crsp_damping = false\nrolling_resistance_in_impacts = false\n";
  for (const std::string model : {"lumped_mass", "rigid_sphere"}) {
    const std::string head = "[analysis]\nmodel = \"" + model + "\"\n";
    const auto talus = ends_of(head + rough_slope), rocfall = ends_of(head + "laws = \"rocfall\"\n" + rough_slope);
    EXPECT_NE(talus, rocfall) << model;
    EXPECT_EQ(talus, ends_of(head + "laws = \"talus\"\n" + rough_slope)) << model;
    EXPECT_EQ(rocfall, ends_of(head + spelled + rough_slope)) << model;
    // In whatever order.
    EXPECT_NE(rocfall, ends_of(head + "scale_rn_by_velocity = true\nlaws = \"rocfall\"\n" + rough_slope)) << model;
    EXPECT_EQ(talus, ends_of(head + "laws = \"rocfall\"\ngrazing_angle_deg = 15\nroughness_law = \"faces\"\n" +
                             "scale_rn_by_velocity = true\ntangential_crsp_damping = true\n" +
                             "rolling_resistance_in_impacts = true\n" + rough_slope))
        << model;
  }
}

// Both models meet the same faces and bumps; with RocFall's laws, heights of the ground are for spheres alone.
TEST(BuildModel, RoughnessFromHeightsIsForBothModels) {
  const std::string heights = replaced(rough_slope, "roughness_deg = 6\nroughness_spacing_m = 2",
                                       "roughness_amplitude_m = 0.05\nroughness_spacing_m = 0.5");
  const std::string smooth = replaced(rough_slope, "roughness_deg = 6", "roughness_deg = 0");
  EXPECT_NE(ends_of(heights), ends_of(smooth));
  const std::string rocfall = "[analysis]\nlaws = \"rocfall\"\n";
  EXPECT_EQ(ends_of(rocfall + heights), ends_of(rocfall + smooth));
}

}  // namespace
}  // namespace talus::project
