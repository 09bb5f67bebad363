#include "talus/project/differences.hpp"

#include <gtest/gtest.h>

#include "talus/project/echo.hpp"
#include "talus/project/read.hpp"

namespace talus::project {
namespace {

using Json = nlohmann::ordered_json;

const std::string two_materials = R"(
name = "Two materials"
[terrain]
section = [[0, 0], [10, -5], [20, -5]]
[[material]]
name = "Rock"
normal_restitution = 0.5
tangential_restitution = 0.9
friction_angle_deg = 30
[[material]]
name = "Scree"
normal_restitution = 0.3
tangential_restitution = 0.8
friction_angle_deg = 30
[ground]
default = "Rock"
segments = ["Rock", "Scree"]
[[seeder]]
type = "point"
position = [0.5, 2]
rocks = 50
mass_kg = 1000
)";

Json echo_of(std::string project, const std::string& was = "", const std::string& is = "") {
  if (!was.empty()) project.replace(project.find(was), was.size(), is);
  return echo(read_project_text(project, "x.toml").project);
}

TEST(Differences, OfAProjectFromItselfAreEmpty) {
  EXPECT_TRUE(differences(echo_of(two_materials), echo_of(two_materials)).empty());
}

TEST(Differences, AreNamedLikeSettings) {
  const auto found = differences(echo_of(two_materials),
                                 echo_of(two_materials, "normal_restitution = 0.3", "normal_restitution = 0.35"));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].key, "material.Scree.normal_restitution.mean");
  EXPECT_EQ(found[0].here, 0.3);
  EXPECT_EQ(found[0].there, 0.35);
  // Applied on the command line, it makes the same change.
  const Reading set = read_project_text(two_materials, "x.toml", {.settings = {found[0].key + "=0.35"}});
  EXPECT_TRUE(
      differences(echo(set.project), echo_of(two_materials, "normal_restitution = 0.3", "normal_restitution = 0.35"))
          .empty());
}

TEST(Differences, OfANewMaterialAreItsSettings) {
  const std::string more =
      "[[material]]\nname = \"Grass\"\nnormal_restitution = 0.2\ntangential_restitution = 0.7\n"
      "friction_angle_deg = 30\n[[material]]\nname = \"Rock\"";
  const auto found = differences(echo_of(two_materials), echo_of(two_materials, "[[material]]\nname = \"Rock\"", more));
  ASSERT_FALSE(found.empty());
  for (const Difference& difference : found) {
    EXPECT_TRUE(difference.key.starts_with("material.Grass.")) << difference.key;
    EXPECT_TRUE(difference.here.is_null());
    EXPECT_FALSE(difference.there.is_null());
  }
}

TEST(Differences, OfAListAreTheWholeList) {
  const auto found = differences(echo_of(two_materials), echo_of(two_materials, "[20, -5]", "[25, -5]"));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].key, "terrain.section");
  EXPECT_EQ(found[0].there.dump(), "[[0.0,0.0],[10.0,-5.0],[25.0,-5.0]]");
}

// If two entries share a name, entries are identified by number.
TEST(Differences, OfEntriesWithTheSameNameAreByNumber) {
  const Json here = {{"seeder", {{{"name", "A"}, {"rocks", 1}}, {{"name", "A"}, {"rocks", 2}}}}};
  const Json there = {{"seeder", {{{"name", "A"}, {"rocks", 1}}, {{"name", "A"}, {"rocks", 3}}}}};
  const auto found = differences(here, there);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].key, "seeder.1.rocks");
}

}  // namespace
}  // namespace talus::project
