#include "talus/project/material_library.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <set>
#include <sstream>

#include "talus/project/echo.hpp"
#include "talus/project/read.hpp"

namespace talus::project {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

Project read(const std::string& materials) {
  return read_project_text("[terrain]\nsection = [[0, 0], [10, -10]]\n" + materials +
                               "[[seeder]]\nposition = [1, 5]\nmass_kg = 100\n",
                           "slope.toml")
      .project;
}

std::string refusal(const std::string& materials) {
  try {
    static_cast<void>(read(materials));
  } catch (const BadInput& bad) {
    return bad.what();
  }
  return "was read";
}

TEST(MaterialLibrary, EachHasAKeyAMeaningValuesAndASource) {
  std::set<std::string> keys;
  for (const LibraryMaterial& entry : material_library()) {
    EXPECT_TRUE(keys.insert(entry.key).second) << entry.key;
    EXPECT_FALSE(entry.meaning.empty()) << entry.key;
    EXPECT_THAT(entry.source, HasSubstr(", ")) << entry.key;
    EXPECT_FALSE(entry.checked.empty()) << entry.key;
    EXPECT_THAT(entry.given, Contains("normal_restitution")) << entry.key;
    EXPECT_THAT(entry.given, Contains("tangential_restitution")) << entry.key;
    // A rebound along the ground loses less than one off it, on every ground of the literature.
    EXPECT_LT(entry.material.normal_restitution.mean, entry.material.tangential_restitution.mean) << entry.key;
  }
  EXPECT_GE(keys.size(), 10U);
}

TEST(MaterialLibrary, AProjectNamesOneAndOverridesIt) {
  const Project project = read(R"(
[[material]]
friction_angle_deg = 34
name = "Scree"
normal_restitution = 0.31
like = "bedrock_and_boulders"
)");
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
  // What results tell of the project says all of it.
  const auto echoed = echo(project).at("material").at(0);
  EXPECT_EQ(echoed.at("like"), "bedrock_and_boulders");
  EXPECT_EQ(echoed.at("tangential_restitution").at("rel_min"), 0.02);
}

TEST(MaterialLibrary, WhatItDoesNotHaveIsRefused) {
  EXPECT_EQ(refusal("[[material]]\nname = \"Scree\"\nlike = \"talus_covr\"\n"),
            "slope.toml:5: material \"Scree\": like is \"talus_covr\" (the library has smooth_hard_surface, "
            "bedrock_and_boulders, talus_and_firm_soil, soft_soil, clean_hard_bedrock, asphalt, bedrock_outcrops, "
            "talus_cover, talus_with_vegetation and soft_soil_with_vegetation). Did you mean \"talus_cover\"?");
  EXPECT_EQ(refusal("[[material]]\nname = \"Scree\"\nlike = 3\n"),
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
      << "docs/materials.md does not say what materials.toml says; run this test with TALUS_RENEW_REFERENCE=1";
  for (const LibraryMaterial& entry : material_library()) EXPECT_THAT(text.str(), HasSubstr("| `" + entry.key + "` |"));
}

}  // namespace
}  // namespace talus::project
