// [design]: the exact text of errors, and the resulting plan.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "support/projects.hpp"
#include "talus/model/design_plan.hpp"

namespace talus::project {
namespace {

using testing::ElementsAre;
using testing_tools::model_of;
using testing_tools::problems_of_reading;

constexpr const char* ground_3d = R"([terrain]
section = [[0, 0], [30, -20], [60, -25]]
width_m = 80
[[material]]
name = "Rock"
[[seeder]]
position = [1, 40, 5]
mass_kg = 1000
)";
constexpr const char* lines_3d = R"([[collector]]
name = "Upper"
line = [[20, 0], [20, 80]]
height_m = 5
[[collector]]
name = "Road"
line = [[50, 10], [50, 35]]
height_m = 5
[[barrier]]
line = [[40, 0], [40, 80]]
height_m = 3
)";

/// Errors and warnings about a design on 3D ground.
std::string problems_of_design(const std::string& design, const std::string& lines = lines_3d) {
  return problems_of_reading(ground_3d + lines + design);
}

TEST(CheckDesign, TakesAllLinesByDefault) {
  EXPECT_EQ(problems_of_design("[design]\n"), "");
  EXPECT_EQ(problems_of_design("[design]\nlines = [\"Road\", \"barrier 1\"]\n"), "");
}

TEST(CheckDesign, RefusesToDesignWithoutALine) {
  EXPECT_EQ(problems_of_design("[design]\n", ""),
            "slope.toml:9: [design]: there is no line to design for (the project has no barrier and no collector). Add "
            "a [[collector]] with a line and a height_m");
}

TEST(CheckDesign, RefusesUnknownLines) {
  EXPECT_EQ(problems_of_design("[design]\nlines = [\"Uper\", \"Road\", \"Road\"]\nprotect = \"barrier 2\"\n"),
            "slope.toml:21: [design]: lines[0] is \"Uper\" (no barrier or collector has this name; the project has "
            "\"barrier 1\", \"Upper\", \"Road\"). Did you mean \"Upper\"?\n"
            "slope.toml:21: [design]: lines[2] is \"Road\" (it is listed twice). Leave it out\n"
            "slope.toml:22: [design]: protect is \"barrier 2\" (no barrier or collector has this name; the project has "
            "\"barrier 1\", \"Upper\", \"Road\"). Did you mean \"barrier 1\"?\n"
            "slope.toml:22: warning: [design]: protect is given, and there are barriers (rocks that a [[barrier]] "
            "stops never reach the protected line and are not counted). Make the candidates [[collector]]s");
  EXPECT_EQ(problems_of_design("[design]\nlines = []\n"),
            "slope.toml:21: [design]: lines is empty (without a line there is nothing to design for). Leave it out to "
            "take all barriers and collectors");
}

TEST(CheckDesign, RefusesNumbersOutOfRange) {
  EXPECT_EQ(problems_of_design("[design]\nsection_m = 0\ncatch_share = 95\nconfidence = 95\nheights_m = [2, -3]\n"
                               "risk_factor = 0.9\npercentiles = [101]\n"),
            "slope.toml:21: [design]: section_m is 0 (lines are divided into sections of this length; expected more "
            "than 0, up to 1e9)\n"
            "slope.toml:22: [design]: catch_share is 95 (a share cannot exceed 1; expected more than 0, up to 1). Did "
            "you mean 0.95?\n"
            "slope.toml:23: [design]: confidence is 95 (it is a probability; expected more than 0, less than 1). Did "
            "you mean 0.95?\n"
            "slope.toml:24: [design]: heights_m[1] is -3 (nothing could hit it; expected more than 0, up to 10000)\n"
            "slope.toml:25: [design]: risk_factor is 0.9 (a safety factor cannot be less than 1; expected 1 to 1e6)\n"
            "slope.toml:26: [design]: percentiles[0] is 101 (expected 0 to 100)");
  EXPECT_EQ(problems_of_design("[design]\nheights_m = []\nenergies_kJ = []\n"),
            "slope.toml:21: [design]: heights_m is empty (there would be no kit to choose from). Leave it out\n"
            "slope.toml:22: [design]: energies_kJ is empty (there would be no kit to choose from). Leave it out");
  EXPECT_EQ(problems_of_design("[design]\npercentiles = [95, 50, 95]\n"),
            "slope.toml:21: [design]: percentiles[2] is 95 (it is listed twice). Leave it out");
}

TEST(CheckDesign, RefusesTooManySections) {
  EXPECT_EQ(problems_of_design("[design]\nsection_m = 0.05\n"),
            "slope.toml:21: [design]: section_m is 0.05 (line \"barrier 1\", 80 m long, would have more than 1000 "
            "sections). Write 1 or more");
  EXPECT_EQ(problems_of_design("[design]\nlines = [\"Road\"]\nsection_m = 0.05\n"), "") << "25 m has 500";
}

TEST(CheckDesign, RefusesADesignBlockThatSpins) {
  EXPECT_EQ(problems_of_design("[design]\nblock_mass_kg = 2000\nenergy = \"total\"\n"),
            "slope.toml:21: [design]: block_mass_kg is given with energy = \"total\" (the design block has a mass and "
            "a velocity, but no spin). Set energy = \"translational\"");
}

TEST(CheckDesign, RefusesKitsWithoutTheRequiredServiceLevel) {
  EXPECT_EQ(problems_of_design("[design]\nenergy_level = \"SEL\"\nenergies_kJ = [100, 200]\n"),
            "slope.toml:22: [design]: energies_kJ has no value of 250 kJ or more (energy_level is \"SEL\", and kits of "
            "class 0 are not tested at that level)");
  EXPECT_EQ(problems_of_design("[design]\nenergy_level = \"SEL\"\nenergies_kJ = [100, 250]\n"), "");
}

TEST(CheckDesign, WarnsOfSettingsWithoutEffect) {
  EXPECT_EQ(problems_of_design("[design]\nstandard = \"none\"\nrisk_factor = 1.1\nenergy_level = \"SEL\"\n"),
            "slope.toml:22: warning: [design]: risk_factor has no effect (standard is \"none\")\n"
            "slope.toml:23: warning: [design]: energy_level has no effect (standard is \"none\")");
  const std::string in_2d = R"([terrain]
section = [[0, 0], [30, -20]]
[[material]]
name = "Rock"
[[seeder]]
position = [1, 5]
mass_kg = 1000
[[collector]]
line = 20
height_m = 5
[design]
section_m = 5
)";
  EXPECT_EQ(problems_of_reading(in_2d),
            "slope.toml:12: warning: [design]: section_m has no effect (in 2D a line is a point of the section)");
}

DesignPlan plan_of(const std::string& text) {
  const Project project = read_project_text(text, "slope.toml").project;
  return design_plan(*project.design, model_of(text));
}

TEST(DesignPlan, HasLinesBySectionsAndKitsInOrder) {
  const DesignPlan plan = plan_of(std::string(ground_3d) + lines_3d + R"([design]
lines = ["Road", "Upper"]
protect = "Road"
heights_m = [5, 2, 5]
energies_kJ = [8500, 100]
)");
  ASSERT_EQ(plan.lines.size(), 2u);
  EXPECT_EQ(plan.lines[0].name, "Road");
  EXPECT_EQ(plan.lines[0].barrier, plan.protect);
  EXPECT_DOUBLE_EQ(plan.lines[0].length, 25);
  EXPECT_EQ(plan.lines[0].sections, 3u);
  EXPECT_EQ(plan.lines[1].name, "Upper");
  EXPECT_EQ(plan.lines[1].sections, 8u) << "80 m are eight sections of 10 m and not nine";
  EXPECT_THAT(plan.heights, ElementsAre(2, 5));
  EXPECT_THAT(plan.energies, ElementsAre(100e3, 8500e3));
  EXPECT_EQ(plan.standard, "UNI 11211-4");
}

TEST(DesignPlan, ALineBeginsWhereItFirstStandsOnTheTerrain) {
  const DesignPlan plan =
      plan_of(std::string(ground_3d) +
              "[[collector]]\nname = \"Edge\"\nline = [[50, -35], [50, 20]]\nheight_m = 5\n[design]\n");
  ASSERT_EQ(plan.lines.size(), 1u);
  EXPECT_NEAR(plan.lines[0].start, 35, 1e-9);
  EXPECT_NEAR(plan.lines[0].length, 20, 1e-9);
  EXPECT_EQ(plan.lines[0].sections, 2u);
}

TEST(DesignPlan, OfTheStandardHasItsFactors) {
  const std::string project = std::string(ground_3d) + lines_3d + "[design]\n";
  const CheckFactors usual = plan_of(project).factors;
  EXPECT_EQ(usual.trajectory, 1.1);
  EXPECT_EQ(usual.topography, 1.1);
  EXPECT_EQ(usual.volume, 1.1);
  EXPECT_EQ(usual.density, 1);
  EXPECT_EQ(usual.risk, 1);
  EXPECT_EQ(usual.energy, 1.2);
  EXPECT_EQ(usual.clearance, 0.5);
  EXPECT_TRUE(usual.clears_half_the_block);
  EXPECT_EQ(usual.level, KitLevel::maximum);
  EXPECT_EQ(plan_of(project + "energy_level = \"SEL\"\n").factors.energy, 1);
  EXPECT_EQ(plan_of(project + "energy_level = \"SEL\"\nenergy_factor = 1.3\n").factors.energy, 1.3);
  EXPECT_THAT(plan_of(project + "energy_level = \"SEL\"\nenergies_kJ = [100, 500]\n").energies, ElementsAre(500e3));
  const DesignPlan without = plan_of(project + "standard = \"none\"\n");
  EXPECT_EQ(without.factors, CheckFactors{});
  EXPECT_EQ(without.standard, "");
}

}  // namespace
}  // namespace talus::project
