#include "talus/project/material_library.hpp"
#include "support/places.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <numbers>
#include <set>
#include <sstream>

#include "support/projects.hpp"
#include "talus/project/echo.hpp"

namespace talus::project {
namespace {

using ::testing::HasSubstr;
using testing_tools::refusal_of_reading;

std::string project_with(const std::string& materials) {
  return "[terrain]\nsection = [[0, 0], [10, -10]]\n" + materials + "[[seeder]]\nposition = [1, 5]\nmass_kg = 100\n";
}

/// The largest value that is drawn.
double largest(const Distribution& property) { return property.mean + property.rel_max.value_or(0); }

TEST(MaterialLibrary, EachEntryHasAKeyAMeaningValuesAndSources) {
  std::set<std::string> keys;
  for (const LibraryMaterial& entry : material_library().materials) {
    EXPECT_TRUE(keys.insert(entry.key).second) << entry.key;
    EXPECT_FALSE(entry.meaning.empty()) << entry.key;
    EXPECT_NE(entry.find("normal_restitution"), nullptr) << entry.key;
    EXPECT_NE(entry.find("tangential_restitution"), nullptr) << entry.key;
    for (const LibraryValue& value : entry.given) EXPECT_LT(value.source, material_library().sources.size());
    // On every ground of the literature, a rebound loses no less velocity normal to the ground than along it.
    EXPECT_LE(entry.material.normal_restitution.mean, entry.material.tangential_restitution.mean) << entry.key;
  }
  EXPECT_GE(keys.size(), 17U);
  for (const LibrarySource& source : material_library().sources) {
    EXPECT_THAT(source.text, HasSubstr(", "));
    EXPECT_FALSE(source.limits.empty()) << source.text;
    EXPECT_FALSE(source.checked.empty()) << source.text;
  }
}

TEST(MaterialLibrary, AValueHasASourceOfItsOwn) {
  const MaterialLibrary& library = material_library();
  const LibraryMaterial* talus = library.find("talus_cover");
  ASSERT_NE(talus, nullptr);
  const auto source_of = [&](std::string_view key) { return library.sources.at(talus->find(key)->source).text; };
  EXPECT_THAT(source_of("normal_restitution"), HasSubstr("Hoek"));
  EXPECT_THAT(source_of("rolling_friction"), HasSubstr("Kirkby and I. Statham"));
  EXPECT_THAT(source_of("roughness_deg"), HasSubstr("rough ground"));
  EXPECT_EQ(talus->find("friction_angle_deg"), nullptr);
  EXPECT_EQ(in_words(*talus, "friction_angle_deg"), "");
  EXPECT_EQ(library.find("talus_covr"), nullptr);
}

// A sphere skids where rolling needs more friction than there is; on the slope of its rolling friction it needs that
// friction itself.
TEST(MaterialLibrary, SpheresRollToRestInsteadOfSkidding) {
  for (const LibraryMaterial& entry : material_library().materials) {
    if (!entry.find("rolling_friction")) continue;
    EXPECT_GE(entry.material.dynamic_friction.mean, largest(entry.material.rolling_friction) - 1e-9) << entry.key;
    if (entry.find("dynamic_friction")) {
      EXPECT_NEAR(entry.material.dynamic_friction.mean, largest(entry.material.rolling_friction), 1e-9) << entry.key;
    }
  }
}

// STONE has one friction for points and spheres.
TEST(MaterialLibrary, PointsAndSpheresHaveTheSameFrictionWhereOneSourceGivesBoth) {
  int count = 0;
  for (const LibraryMaterial& entry : material_library().materials) {
    if (!entry.find("friction_angle_deg")) continue;
    ++count;
    const double radian = std::numbers::pi / 180;
    const Distribution& angle = entry.material.friction_angle_deg;
    EXPECT_EQ(entry.find("friction_angle_deg")->source, entry.find("rolling_friction")->source) << entry.key;
    EXPECT_NEAR(std::tan(angle.mean * radian), entry.material.rolling_friction.mean, 0.005) << entry.key;
    EXPECT_NEAR(std::tan(largest(angle) * radian), 1.1 * entry.material.rolling_friction.mean, 0.01) << entry.key;
  }
  EXPECT_EQ(count, 7);
}

// Kirkby and Statham: tan(phi0) with phi0 from 20.3 to 33.8 degrees; Evans and Hungr: no shadow angle below 27.5.
TEST(MaterialLibrary, TalusHasTheRollingFrictionOfScree) {
  const Distribution& friction = material_library().find("talus_cover")->material.rolling_friction;
  const double radian = std::numbers::pi / 180;
  EXPECT_NEAR(friction.mean - *friction.rel_min, std::tan(20.3 * radian), 0.005);
  EXPECT_NEAR(friction.mean + *friction.rel_max, std::tan(33.8 * radian), 0.005);
  EXPECT_NEAR(friction.mean, std::tan(27.5 * radian), 0.005);
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
  EXPECT_EQ(scree.rolling_friction.mean, 0.3);
  EXPECT_EQ(scree.dynamic_friction.mean, Material{}.dynamic_friction.mean);
  EXPECT_EQ(scree.roughness_deg.mean, 10);
  EXPECT_EQ(scree.roughness_spacing_m, 5);
  // The echo in the results has all values.
  const auto echoed = echo(project).at("material").at(0);
  EXPECT_EQ(echoed.at("like"), "bedrock_and_boulders");
  EXPECT_EQ(echoed.at("tangential_restitution").at("rel_min"), 0.02);
}

TEST(MaterialLibrary, UnknownKeysAreRefused) {
  EXPECT_EQ(
      refusal_of_reading(project_with("[[material]]\nname = \"Scree\"\nlike = \"talus_covr\"\n")),
      "slope.toml:5: material \"Scree\": like is \"talus_covr\" (the library has smooth_hard_surface, "
      "bedrock_and_boulders, talus_and_firm_soil, soft_soil, clean_hard_bedrock, asphalt, bedrock_outcrops, "
      "talus_cover, talus_with_vegetation, soft_soil_with_vegetation, carbonate_and_igneous_rock, "
      "schist_and_mixed_carbonate_rock, flysch_marl_and_tuff, weak_clastic_rock_and_evaporites, "
      "landslide_and_glacial_deposits, alluvium_and_colluvium and lakes_and_glaciers). Did you mean \"talus_cover\"?");
  EXPECT_EQ(refusal_of_reading(project_with("[[material]]\nname = \"Scree\"\nlike = 3\n")),
            "slope.toml:5: material \"Scree\": like is 3 (expected a text in quotes)");
}

TEST(MaterialLibrary, PropertiesInWords) {
  EXPECT_EQ(in_words(constant(0.35)), "0.35");
  EXPECT_EQ(in_words({0.35, DistributionKind::uniform, {}, 0.02, 0.03}), "0.33 to 0.38");
  EXPECT_EQ(in_words({0.35, DistributionKind::normal, 0.04, {}, {}}), "0.35 (normal, sd 0.04)");
}

TEST(MaterialsPage, IsNotStale) {
  const std::string file = talus::places::in_source("/docs/materials.md");
  if (std::getenv("TALUS_RENEW_REFERENCE") != nullptr) std::ofstream(file) << materials_page();
  std::ifstream in(file);
  std::ostringstream text;
  text << in.rdbuf();
  EXPECT_TRUE(text.str() == materials_page())
      << "docs/materials.md is out of date; run this test with TALUS_RENEW_REFERENCE=1";
  for (const LibraryMaterial& entry : material_library().materials)
    EXPECT_THAT(text.str(), HasSubstr("| `" + entry.key + "` |"));
}

}  // namespace
}  // namespace talus::project
