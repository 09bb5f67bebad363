// Which numbers a factor changes, and to what.

#include "talus/lines/what_if_factors.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "lines/read_what_if.hpp"
#include "support/projects.hpp"

namespace talus::what_if {
namespace {

using testing_tools::replaced;

constexpr const char* slope = R"([analysis]
model = "lumped_mass"
[terrain]
section = [[0, 0], [10, -10], [80, -12]]
[[material]]
name = "Rock"
normal_restitution = { mean = 0.96, distribution = "normal", std_dev = 0.04 }
tangential_restitution = 0.8
friction_angle_deg = 30
roughness_deg = { mean = 2, distribution = "normal", std_dev = 4, rel_min = 2, rel_max = 8 }
[[material]]
name = "Wood"
normal_restitution = 0.3
tangential_restitution = 0.9
friction_angle_deg = 35
forest = "medium"
forest_height_m = 5
[ground]
segments = ["Rock", "Wood"]
[[seeder]]
name = "Crest"
position = [1, 0]
diameter_m = 1.5
rocks = 50
)";

std::string listed(const std::vector<Variation>& variations) {
  std::string text;
  for (const Variation& each : variations) {
    text += std::string(factor_kinds[each.kind].key) + " " + step_text(each) + ": " + changes_text(each);
    if (!each.clipped.empty()) text += " (clipped: " + each.clipped + ")";
    text += "\n";
  }
  return text;
}

std::string refusal(const std::string& text, const FactorChoice& choice) {
  Problems warnings;
  try {
    static_cast<void>(variations_of(read(text), choice, "--step", warnings));
  } catch (const BadInput& bad) {
    return bad.problems().text();
  }
  return "";
}

TEST(Factors, AreThoseThatTheProjectHas) {
  Problems warnings;
  const auto variations = variations_of(read(slope), {}, "--step", warnings);
  EXPECT_EQ(warnings.text(), "");
  EXPECT_EQ(listed(variations),
            R"(normal_restitution -10 %: Rock {mean 0.96, std_dev 0.04} to {mean 0.864, std_dev 0.04}; Wood 0.3 to 0.27
normal_restitution +10 %: Rock {mean 0.96, std_dev 0.04} to {mean 1, std_dev 0.04}; Wood 0.3 to 0.33 (clipped: normal_restitution of Rock at 1)
tangential_restitution -10 %: Rock 0.8 to 0.72; Wood 0.9 to 0.81
tangential_restitution +10 %: Rock 0.8 to 0.88; Wood 0.9 to 0.99
friction_angle -10 %: Rock 30 to 27; Wood 35 to 31.5
friction_angle +10 %: Rock 30 to 33; Wood 35 to 38.5
roughness -25 %: Rock {mean 2, std_dev 4, rel_min 2, rel_max 8} to {mean 1.5, std_dev 3, rel_min 1.5, rel_max 6}
roughness +25 %: Rock {mean 2, std_dev 4, rel_min 2, rel_max 8} to {mean 2.5, std_dev 5, rel_min 2.5, rel_max 10}
forest_drag -25 %: Wood medium to 375
forest_drag +25 %: Wood medium to 625
mass -25 %: Crest 1.5 to 1.363
mass +25 %: Crest 1.5 to 1.616
)");
}

TEST(Factors, ClipWhatWouldLeaveItsRange) {
  Problems warnings;
  const auto variations = variations_of(
      read(slope), {.steps = std::vector<Step>{{"normal_restitution", 0.1}}, .material = "Rock"}, "--step", warnings);
  ASSERT_EQ(variations.size(), 2u);
  EXPECT_EQ(variations[0].clipped, "");
  EXPECT_EQ(variations[1].clipped, "normal_restitution of Rock at 1");
  EXPECT_EQ(variations[1].project.materials[0].normal_restitution.mean, 1);
  EXPECT_EQ(*variations[1].project.materials[0].normal_restitution.std_dev, 0.04);
  EXPECT_EQ(variations[1].project.materials[1].normal_restitution.mean, 0.3);
}

/// A word for the density of a forest becomes a drag, which is in the file instead of it.
TEST(Factors, ReplaceTheWordOfAForest) {
  Problems warnings;
  const auto variations =
      variations_of(read(slope), {.steps = std::vector<Step>{{"forest_drag", 0.2}}}, "--step", warnings);
  ASSERT_EQ(variations.size(), 2u);
  const Variation& more = variations[1];
  EXPECT_DOUBLE_EQ(*more.project.materials[1].forest_drag_kg_s, 600);
  EXPECT_EQ(more.project.materials[1].forest, Forest::none);
  ASSERT_EQ(more.changes.size(), 2u);
  EXPECT_EQ(path_of(more.changes[0]), "material.1.forest");
  EXPECT_EQ(*more.changes[0].before, "medium");
  EXPECT_FALSE(more.changes[0].after);
  EXPECT_EQ(path_of(more.changes[1]), "material.1.forest_drag_kg_s");
  EXPECT_FALSE(more.changes[1].before);
  EXPECT_DOUBLE_EQ(more.changes[1].after->get<double>(), 600);
}

TEST(Factors, MoveTheDragOfForestsOverTheGround) {
  const std::string wide = replaced(slope, "[terrain]\n", "[terrain]\nwidth_m = 40\n");
  const std::string text = replaced(wide, "position = [1, 0]", "position = [1, 0, 0]") +
                           "[[forest]]\nname = \"Spruce\"\ndensity = \"open\"\nheight_m = 9\n"
                           "polygon = [[0, -9], [40, -9], [40, 9]]\n";
  Problems warnings;
  const FactorChoice more{.steps = std::vector<Step>{{"forest_drag", 0.2}}};
  const auto variations = variations_of(read(text), more, "--step", warnings);
  ASSERT_EQ(variations.size(), 2u);
  EXPECT_EQ(changes_text(variations[1]), "Wood medium to 600; Spruce open to 300");
  EXPECT_DOUBLE_EQ(variations[1].project.forests[0].drag(), 300);
  EXPECT_EQ(path_of(variations[1].changes.back()), "forest.0.drag_kg_s");
  // Of one material alone the forests that lie over it are no part.
  const auto of_wood = variations_of(read(text), {.steps = more.steps, .material = "Wood"}, "--step", warnings);
  EXPECT_EQ(changes_text(of_wood[1]), "Wood medium to 600");
}

/// A step of the mass is one of the third power of a diameter; a distribution is scaled as a whole.
TEST(Factors, ScaleSizesAsMasses) {
  Problems warnings;
  const auto by_diameter = vary(read(slope), 7, 1.25, "");
  EXPECT_DOUBLE_EQ(std::pow(by_diameter.project.seeders[0].size->distribution.mean / 1.5, 3), 1.25);
  const auto by_mass =
      vary(read(testing_tools::replaced(
               slope, "diameter_m = 1.5",
               "mass_kg = { mean = 800, distribution = \"lognormal\", std_dev = 200, rel_max = 400 }")),
           7, 1.25, "");
  const Distribution& mass = by_mass.project.seeders[0].size->distribution;
  EXPECT_DOUBLE_EQ(mass.mean, 1000);
  EXPECT_DOUBLE_EQ(*mass.std_dev, 250);
  EXPECT_DOUBLE_EQ(*mass.rel_max, 500);
}

TEST(Factors, OfASphereHaveItsFriction) {
  Problems warnings;
  std::string keys;
  const std::string sphere = testing_tools::replaced(slope, "lumped_mass", "rigid_sphere");
  for (const Variation& each : variations_of(read(sphere), {}, "--step", warnings))
    if (each.factor > 1) keys += std::string(factor_kinds[each.kind].key) + " ";
  EXPECT_EQ(keys,
            "normal_restitution tangential_restitution dynamic_friction rolling_friction roughness forest_drag mass ");
}

TEST(Factors, RefuseWhatCannotBe) {
  EXPECT_EQ(refusal(slope, {.steps = std::vector<Step>{{"normal_restitutions", 0.1}}}),
            "--step: there is no factor \"normal_restitutions\" (expected normal_restitution, tangential_restitution, "
            "friction_angle, dynamic_friction, rolling_friction, roughness, forest_drag, mass). Did you mean "
            "normal_restitution?");
  EXPECT_EQ(refusal(slope, {.steps = std::vector<Step>{{"mass", 1}}}),
            "--step: the step of mass is 100 % (expected a share of the value, above 0 and below 100 %)");
  EXPECT_EQ(refusal(slope, {.steps = std::vector<Step>{{"mass", 0.1}, {"mass", 0.2}}}),
            "--step: mass is given twice (a factor has one step)");
  EXPECT_EQ(refusal(slope, {.steps = std::vector<Step>{{"rolling_friction", 0.1}}}),
            "--step: this project has no rolling_friction (it is not given, 0, from a file, or not of its rock model)");
  EXPECT_EQ(refusal(slope, {.steps = {}, .material = "Rok"}),
            "--step: there is no material \"Rok\" (the project has Rock, Wood). Did you mean \"Rock\"?");
}

}  // namespace
}  // namespace talus::what_if
