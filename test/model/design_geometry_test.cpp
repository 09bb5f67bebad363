// Distances on plan between the lines of a design, against closed forms.

#include "talus/model/design_geometry.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "support/projects.hpp"
#include "talus/model/design_plan.hpp"

namespace talus::project {
namespace {

using testing_tools::model_of;

constexpr const char* ground = R"([terrain]
section = [[0, 0], [30, -20], [60, -25]]
width_m = 100
[[material]]
name = "Rock"
[[seeder]]
position = [1, 40, 5]
mass_kg = 1000
)";

DesignPlan plan_of(const std::string& more) {
  const std::string text = ground + more;
  return design_plan(read_project_text(text, "slope.toml").project, model_of(text));
}

std::string collector(const std::string& name, const std::string& line) {
  return "[[collector]]\nname = \"" + name + "\"\nline = " + line + "\nheight_m = 5\n";
}

// A line that runs away from the road: each section's nearest end is 10, 15, ... m away.
TEST(DesignGeometry, MeasuresTheClearanceOfEachSection) {
  const DesignPlan plan =
      plan_of(collector("Line", "[[40, 20], [20, 60]]") + collector("Road", "[[50, 0], [50, 100]]") +
              "[design]\nlines = [\"Line\"]\nprotect = \"Road\"\nsection_m = 11.180339887498949\n");
  ASSERT_EQ(plan.lines[0].clearances.size(), 4u);
  for (std::size_t s = 0; s < 4; ++s) EXPECT_NEAR(plan.lines[0].clearances[s], 10 + 5.0 * static_cast<double>(s), 1e-9);
  EXPECT_NEAR(*plan.lines[0].least_clearance(), 10, 1e-9);
}

TEST(DesignGeometry, MeasuresToTheEndOfAShortRoad) {
  const DesignPlan plan = plan_of(collector("Line", "[[20, 0], [20, 10]]") + collector("Road", "[[24, 13], [50, 90]]") +
                                  "[design]\nlines = [\"Line\"]\nprotect = \"Road\"\nsection_m = 10\n");
  EXPECT_NEAR(*plan.lines[0].least_clearance(), 5, 1e-9) << "3, 4, 5";
}

TEST(DesignGeometry, HasNoClearanceWhereLinesCross) {
  const DesignPlan plan =
      plan_of(collector("Line", "[[20, 50], [40, 50]]") + collector("Road", "[[30, 0], [30, 100]]") +
              "[design]\nlines = [\"Line\"]\nprotect = \"Road\"\nsection_m = 5\n");
  EXPECT_NEAR(plan.lines[0].clearances[0], 5, 1e-9);
  EXPECT_NEAR(plan.lines[0].clearances[1], 0, 1e-9);
}

TEST(DesignGeometry, TakesTheGivenClearanceEverywhere) {
  const DesignPlan plan = plan_of(collector("Line", "[[20, 0], [20, 30]]") + "[design]\nclearance_m = 7\n");
  EXPECT_EQ(plan.lines[0].clearances, std::vector<double>(3, 7));
}

TEST(DesignGeometry, IsUnknownWithoutSomethingToProtect) {
  EXPECT_TRUE(plan_of(collector("Line", "[[20, 0], [20, 30]]") + "[design]\n").lines[0].clearances.empty());
}

TEST(DesignGeometry, WorksInSection) {
  const std::string text = R"([terrain]
section = [[0, 0], [30, -20], [60, -25]]
[[material]]
name = "Rock"
[[seeder]]
position = [1, 5]
mass_kg = 1000
[[collector]]
name = "Line"
line = 20
height_m = 5
[[collector]]
name = "Road"
line = 32.5
height_m = 5
[design]
lines = ["Line"]
protect = "Road"
)";
  const DesignPlan plan = design_plan(read_project_text(text, "slope.toml").project, model_of(text));
  EXPECT_NEAR(*plan.lines[0].least_clearance(), 12.5, 1e-9);
}

DesignPair pair_of(const std::string& one, const std::string& other) {
  return plan_of(collector("One", one) + collector("Other", other) + "[design]\npairs = true\n").pairs.at(0);
}

TEST(DesignGeometry, SeesHowFarStaggeredLinesOverlap) {
  const DesignPair overlapping = pair_of("[[20, 0], [20, 50]]", "[[35, 44], [35, 90]]");
  EXPECT_NEAR(*overlapping.overlap, 6, 1e-9);
  EXPECT_NEAR(*overlapping.distance, 15, 1e-9);
  const DesignPair apart = pair_of("[[35, 54], [35, 90]]", "[[20, 0], [20, 50]]");
  EXPECT_NEAR(*apart.overlap, -4, 1e-9) << "a gap";
  EXPECT_NEAR(*apart.distance, 15, 1e-9);
  const DesignPair reversed = pair_of("[[20, 50], [20, 0]]", "[[35, 44], [35, 90]]");
  EXPECT_NEAR(*reversed.overlap, 6, 1e-9);
}

// The second line leaves at 45 degrees: in the middle of the overlap, 3 m from its beginning, it is 3 m further.
TEST(DesignGeometry, MeasuresTheDistanceInTheMiddleOfTheOverlap) {
  const DesignPair pair = pair_of("[[20, 0], [20, 50]]", "[[30, 44], [50, 64]]");
  EXPECT_NEAR(*pair.overlap, 6, 1e-9);
  EXPECT_NEAR(*pair.distance, 13, 1e-9);
}

TEST(DesignGeometry, AsksForNoOverlapOfALineThatCoversTheOther) {
  EXPECT_FALSE(pair_of("[[20, 10], [20, 50]]", "[[35, 0], [35, 90]]").overlap);
  EXPECT_FALSE(pair_of("[[20, 0], [20, 50]]", "[[35, 0], [35, 50]]").overlap);
}

TEST(DesignGeometry, JoinsThePanelsOfAStraightLine) {
  const DesignPlan plan = plan_of(collector("Bent", "[[10, 0], [50, 0], [50, 30]]") + "[design]\n");
  ASSERT_EQ(plan.lines[0].pieces.size(), 2u) << "the ground bends at x = 30 m, the line does not";
  EXPECT_NEAR(plan.lines[0].pieces[0].along_x, 1, 1e-12);
  EXPECT_NEAR(plan.lines[0].pieces[1].station, 40, 1e-9);
  EXPECT_NEAR(plan.lines[0].pieces[1].along_y, 1, 1e-12);
}

}  // namespace
}  // namespace talus::project
