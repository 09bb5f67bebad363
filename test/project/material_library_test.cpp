#include "talus/project/material_library.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <set>
#include <sstream>

#include "support/projects.hpp"
#include "talus/project/echo.hpp"

namespace talus::project {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using testing_tools::refusal_of_reading;

std::string project_with(const std::string& materials) {
  return "[terrain]\nsection = [[0, 0], [10, -10]]\n" + materials + "[[seeder]]\nposition = [1, 5]\nmass_kg = 100\n";
}

TEST(MaterialLibrary, EachEntryHasAKeyAMeaningValuesAndASource) {
  std::set<std::string> keys;
  for (const LibraryMaterial& entry : material_library()) {
    EXPECT_TRUE(keys.insert(entry.key).second) << entry.key;
    EXPECT_FALSE(entry.meaning.empty()) << entry.key;
    EXPECT_THAT(entry.source, HasSubstr(", ")) << entry.key;
    EXPECT_FALSE(entry.checked.empty()) << entry.key;
    EXPECT_THAT(entry.given, Contains("normal_restitution")) << entry.key;
    EXPECT_THAT(entry.given, Contains("tangential_restitution")) << entry.key;
    // On every ground of the literature, a rebound loses less velocity along the ground than normal to it.
    EXPECT_LT(entry.material.normal_restitution.mean, entry.material.tangential_restitution.mean) << entry.key;
  }
  EXPECT_GE(keys.size(), 10U);
}

TEST(MaterialLibrary, AProjectUsesAnEntryAndOverridesIt) {
  const Project project = read_project_text(project_with(R"(
[[material]]
friction_angle_deg = 34
name = "Scree"
normal_restitution = 0.31
like = "bedrock_and_boulders"
)"),
                                            "slope.toml")
                              .project;
  const Material& scree = project.materials.at(0);
  EXPECT_EQ(scree.name, "Scree");
  EXPECT_EQ(scree.like, "bedrock_and_boulders");
  EXPECT_EQ(scree.friction_angle_deg.mean, 34);
  EXPECT_EQ(scree.normal_restitution.mean, 0.31);
  EXPECT_EQ(scree.normal_restitution.kind, DistributionKind::none);
  EXPECT_EQ(scree.tangential_restitution.mean, 0.85);
  EXPECT_EQ(scree.tangential_restitution.kind, DistributionKind::uniform);
  EXPECT_EQ(scree.tangential_restitution.rel_max, 0.02);
  EXPECT_EQ(scree.rolling_friction.mean, Material{}.rolling_friction.mean);
  // The echo in the results has all values.
  const auto echoed = echo(project).at("material").at(0);
  EXPECT_EQ(echoed.at("like"), "bedrock_and_boulders");
  EXPECT_EQ(echoed.at("tangential_restitution").at("rel_min"), 0.02);
}

TEST(MaterialLibrary, UnknownKeysAreRefused) {
  EXPECT_EQ(refusal_of_reading(project_with("[[material]]\nname = \"Scree\"\nlike = \"talus_covr\"\n")),
            "slope.toml:5: material \"Scree\": like is \"talus_covr\" (the library has smooth_hard_surface, "
            "bedrock_and_boulders, talus_and_firm_soil, soft_soil, clean_hard_bedrock, asphalt, bedrock_outcrops, "
            "talus_cover, talus_with_vegetation and soft_soil_with_vegetation). Did you mean \"talus_cover\"?");
  EXPECT_EQ(refusal_of_reading(project_with("[[material]]\nname = \"Scree\"\nlike = 3\n")),
            "slope.toml:5: material \"Scree\": like is 3 (expected a text in quotes)");
}

TEST(MaterialLibrary, PropertiesInWords) {
  EXPECT_EQ(in_words(constant(0.35)), "0.35");
  EXPECT_EQ(in_words({0.35, DistributionKind::uniform, {}, 0.02, 0.03}), "0.33 to 0.38");
  EXPECT_EQ(in_words({0.35, DistributionKind::normal, 0.04, {}, {}}), "0.35 (normal, sd 0.04)");
}

TEST(MaterialsPage, IsNotStale) {
  const std::string file = TALUS_SOURCE_DIR "/docs/materials.md";
  if (std::getenv("TALUS_RENEW_REFERENCE") != nullptr) std::ofstream(file) << materials_page();
  std::ifstream in(file);
  std::ostringstream text;
  text << in.rdbuf();
  EXPECT_TRUE(text.str() == materials_page())
      << "docs/materials.md is out of date; run this test with TALUS_RENEW_REFERENCE=1";
  for (const LibraryMaterial& entry : material_library()) EXPECT_THAT(text.str(), HasSubstr("| `" + entry.key + "` |"));
}

}  // namespace
}  // namespace talus::project
