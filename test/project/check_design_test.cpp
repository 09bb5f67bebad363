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

// All that ONR 24810 needs and that could not be read is missing: one message each, at once.
TEST(CheckDesign, RefusesAStandardWhoseValuesCouldNotBeRead) {
  EXPECT_EQ(
      problems_of_design("[design]\nstandard = \"ONR 24810\"\n"),
      "slope.toml:20: [design]: design_percentile is missing (ONR 24810 needs it, and has no value for it: the 95th "
      "or the 99th are used). Take it from the edition that binds you\n"
      "slope.toml:20: [design]: action_energy_factor is missing (ONR 24810 needs γ_E, and has no value for it: "
      "Its values for the consequence classes). Take it from the edition that binds you\n"
      "slope.toml:20: [design]: action_height_factor is missing (ONR 24810 needs γ_h, and has no value for it: "
      "Its values for the consequence classes). Take it from the edition that binds you\n"
      "slope.toml:20: [design]: energy_factor is missing (ONR 24810 needs γ_R, and has no value for it: Its "
      "values, and whether it depends on the consequence class). Take it from the edition that binds you");
  EXPECT_EQ(
      problems_of_design("[design]\nstandard = \"ONR 24810\"\ndesign_percentile = 99\naction_energy_factor = 1.1\n"
                         "action_height_factor = 1.2\nenergy_factor = 1\ntrajectory_factor = 1.1\n"),
      "slope.toml:26: warning: [design]: trajectory_factor has no effect (ONR 24810 has no such factor; it has "
      "action_energy_factor (γ_E), action_height_factor (γ_h), energy_factor (γ_R), elongation_factor (γ_D))");
}

TEST(CheckDesign, RefusesKitsThatCannotBe) {
  const std::string kits = R"([[kit]]
name = "Net"
heights_m = [2, 3, 3]
mel_kJ = 500
sel_kJ = 600
tested_height_m = 3
elongation_m = 4
cost_per_m = 900
[[kit]]
name = "Net"
heights_m = []
mel_kJ = 500
)";
  EXPECT_EQ(
      problems_of_design("[design]\nheights_m = [2]\n" + kits),
      "slope.toml:21: warning: [design]: heights_m has no effect (the project has [[kit]]s to choose from). Leave "
      "it out\n"
      "slope.toml:24: kit \"Net\": heights_m[2] is 3 (it is listed twice). Leave it out\n"
      "slope.toml:24: kit \"Net\": heights_m[0] is 2 (the kit was tested with 3 m, and what a lower one stops was "
      "not). Leave it out\n"
      "slope.toml:26: kit \"Net\": sel_kJ is 600 (the service energy level cannot exceed the maximum energy level, "
      "500)\n"
      "slope.toml:28: kit \"Net\": elongation_m is given without design.elongation_factor (UNI 11211-4 needs γ_D, "
      "and has no value for it: The check D_A ≥ D_d was read, the factor that turns the tested elongation into D_d "
      "was not, nor its symbol: give it from the edition that binds you). Take it from the edition that binds "
      "you\n"
      "slope.toml:28: warning: kit \"Net\": elongation_m has no effect (the distance to what is protected is not "
      "known). Give design.protect or design.clearance_m\n"
      "slope.toml:30: kit \"Net\": cost_per_m is missing (other kits have one, and prices compare with no index). "
      "Give all kits a price, or none\n"
      "slope.toml:31: two kits are named \"Net\" (the first begins in line 22). Give each its own name\n"
      "slope.toml:32: kit \"Net\": heights_m is empty (the kit could not be chosen)");
  EXPECT_EQ(problems_of_design("", std::string(lines_3d) + "[[kit]]\nname = \"A\"\nheights_m = [3]\nmel_kJ = 1\n"),
            "slope.toml:20: warning: [[kit]] has no effect (kits are chosen from by [design]). Add [design]");
}

TEST(CheckDesign, RefusesPairsBeyondMemory) {
  EXPECT_EQ(
      problems_of_design("[design]\nlines = [\"Road\"]\npairs = true\n"),
      "slope.toml:22: warning: [design]: pairs has no effect (there is only one line). Add another [[collector]]");
  std::string heights;
  for (int k = 1; k <= 200; ++k) heights += std::to_string(k) + ", ";
  EXPECT_EQ(problems_of_design("[design]\npairs = true\nheights_m = [" + heights + "]\n"),
            "slope.toml:21: [design]: pairs of 3 lines would need 9.8e+06 counts (200 heights and 8 energies can be "
            "combined in as many ways; expected at most 2e+06). Name fewer lines, or choose from fewer heights and "
            "energies");
}

DesignPlan plan_of(const std::string& text) {
  const Project project = read_project_text(text, "slope.toml").project;
  return design_plan(project, model_of(text));
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
  EXPECT_EQ(usual.velocity, 1.1 * 1.1);
  EXPECT_EQ(usual.height, 1.1 * 1.1);
  EXPECT_EQ(usual.mass, 1.1);
  EXPECT_EQ(usual.energy, 1);
  EXPECT_EQ(usual.capacity, 1.2);
  EXPECT_EQ(usual.elongation, std::nullopt) << "it could not be read";
  EXPECT_EQ(usual.clearance, 0.5);
  EXPECT_TRUE(usual.clears_half_the_block);
  EXPECT_EQ(usual.level, KitLevel::maximum);
  EXPECT_EQ(plan_of(project + "energy_level = \"SEL\"\n").factors.capacity, 1);
  EXPECT_EQ(plan_of(project + "energy_level = \"SEL\"\nenergy_factor = 1.3\n").factors.capacity, 1.3);
  EXPECT_THAT(plan_of(project + "energy_level = \"SEL\"\nenergies_kJ = [100, 500]\n").energies, ElementsAre(500e3));
  const DesignPlan with_elongation = plan_of(project + "elongation_factor = 1.3\n");
  EXPECT_EQ(with_elongation.factors.elongation, 1.3);
  EXPECT_EQ(with_elongation.applied.back().key, "elongation_factor");
  EXPECT_EQ(with_elongation.applied.size(), 7u);
  const DesignPlan austrian = plan_of(project +
                                      "standard = \"ONR 24810\"\ndesign_percentile = 99\naction_energy_factor = 1.1\n"
                                      "action_height_factor = 1.2\nenergy_factor = 1.05\n");
  EXPECT_EQ(austrian.design_percentile, 99);
  EXPECT_EQ(austrian.factors.velocity, 1);
  EXPECT_EQ(austrian.factors.mass, 1);
  EXPECT_EQ(austrian.factors.energy, 1.1);
  EXPECT_EQ(austrian.factors.height, 1.2);
  EXPECT_EQ(austrian.factors.capacity, 1.05);
  EXPECT_EQ(austrian.factors.clearance, 0);
  const DesignPlan without = plan_of(project + "standard = \"none\"\n");
  EXPECT_EQ(without.factors, CheckFactors{});
  EXPECT_EQ(without.standard, "");
}

TEST(DesignPlan, CountsByTheHeightsAndEnergiesOfItsKits) {
  const std::string project = std::string(ground_3d) + lines_3d + R"([[kit]]
name = "A"
heights_m = [4, 3]
mel_kJ = 1000
sel_kJ = 300
residual_height = "A"
[[kit]]
name = "B"
heights_m = [5]
mel_kJ = 500
residual_height = "C"
[design]
pairs = true
free_end_m = 4
clearance_m = 6
)";
  const DesignPlan plan = plan_of(project);
  EXPECT_THAT(plan.heights, ElementsAre(1.5, 2, 3, 4, 5));
  EXPECT_THAT(plan.energies, ElementsAre(500e3, 1000e3));
  ASSERT_EQ(plan.kits.size(), 2u);
  EXPECT_THAT(plan.kits[0].heights, ElementsAre(3, 4));
  EXPECT_EQ(plan.kits[0].residual_share, 0.5);
  EXPECT_EQ(plan.kits[1].residual_share, 0);
  EXPECT_EQ(plan.free_end, 4);
  EXPECT_EQ(plan.pairs.size(), 3u);
  EXPECT_EQ(plan.lines[0].least_clearance(), 6);
  const DesignPlan service = plan_of(project + "energy_level = \"SEL\"\n");
  EXPECT_THAT(service.energies, ElementsAre(500e3, 900e3)) << "three times the SEL, where it is known";
  EXPECT_EQ(service.kits[0].maximum_energy, 1000e3);
}

}  // namespace
}  // namespace talus::project
