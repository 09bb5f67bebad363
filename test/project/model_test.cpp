// From a project to a model: what only the terrain shows, told with file, line, reason and hint.

#include "talus/project/model.hpp"

#include <gtest/gtest.h>

#include "talus/campaign/simulate.hpp"
#include "talus/project/read.hpp"
#include "talus/results/summary.hpp"

namespace talus::project {
namespace {

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

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

Model model_of(const std::string& text) {
  Problems warnings;
  return build_model(read_project_text(text, "slope.toml").project, warnings);
}

std::string complaint_of(const std::string& text) {
  try {
    (void)model_of(text);
  } catch (const BadInput& bad) {
    return bad.problems().text();
  }
  return "no complaint";
}

TEST(BuildModel, RefusesASeederOffTheSection) {
  EXPECT_EQ(complaint_of(replaced(flat_2d, "[1, 5]", "[25, 5]")),
            "slope.toml:6: seeder \"seeder 1\": x = 25 is off the terrain (the section goes from x = 0 to 20)");
}

TEST(BuildModel, RefusesASeederOffTheMesh) {
  EXPECT_EQ(
      complaint_of(replaced(square_3d, "[5, 5, 5]", "[5, 15, 5]")),
      "slope.toml:7: seeder \"seeder 1\": (5, 15) is off the terrain (on plan the terrain lies within x = 0 to 10, "
      "y = 0 to 10)");
}

TEST(BuildModel, HintsThatTurningTheTerrainTurnsNothingElse) {
  EXPECT_EQ(
      complaint_of(replaced(replaced(square_3d, "[terrain]", "[terrain]\nrotate_deg = 90"), "[5, 5, 5]", "[5, 9, 5]")),
      "slope.toml:8: seeder \"seeder 1\": (5, 9) is off the terrain (on plan the terrain lies within x = -10 to 0, "
      "y = 0 to 10). terrain.rotate_deg turns the terrain only, not the seeders");
}

TEST(BuildModel, RefusesABarrierOffTheTerrain) {
  EXPECT_EQ(complaint_of(square_3d + "[[barrier]]\nname = \"Fence\"\nline = [[20, 0], [20, 10]]\nheight_m = 2\n"),
            "slope.toml:11: barrier \"Fence\": its line does not touch the terrain (a barrier stands on the ground)");
}

TEST(BuildModel, LeavesAMaterialListOfTheWrongLengthToTheReader) {
  EXPECT_EQ(complaint_of(replaced(square_3d, "[5, 5, 5]", "[5, 15, 5]") + "[ground]\ntriangles = [0, 0, 0]\n"),
            "slope.toml:12: [ground]: triangles has 3 entries (expected 2, one for each triangle of the terrain)")
      << "inline meshes are checked by the reader";
}

TEST(BuildModel, RefusesAMeshWithoutArea) {
  EXPECT_NE(complaint_of(
                replaced(square_3d, "[[0,0,0],[10,0,0],[10,10,0],[0,10,0]]", "[[0,0,0],[10,0,0],[20,0,0],[30,0,0]]")),
            "no complaint");
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

TEST(BuildModel, PutsRocksOnTheSurfaceAndAboveIt) {
  const Model model = model_of(replaced(flat_2d, "[1, 5]", "[5, \"surface\"]"));
  EXPECT_NEAR(Simulator(model).simulate(0, false).outcome.start.position.z(), -5, 1e-12);
  const Model above = model_of(replaced(square_3d, "position = [5, 5, 5]", "position = [5, 5]\nheight_above_m = 2"));
  EXPECT_NEAR(Simulator(above).simulate(0, false).outcome.start.position.z(), 2, 1e-12);
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

TEST(BuildModel, MovesNothingWhenTheModelIsMovedFarAway) {
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

}  // namespace
}  // namespace talus::project
