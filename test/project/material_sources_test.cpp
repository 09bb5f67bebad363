#include "talus/project/material_sources.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "support/projects.hpp"
#include "talus/project/material_library.hpp"

namespace talus::project {
namespace {

using ::testing::HasSubstr;

std::vector<SourceOfValues> sources_in(const std::string& materials) {
  const std::string text =
      "[terrain]\nsection = [[0, 0], [10, -10], [20, -10]]\n[[seeder]]\ntype = \"point\"\nposition = [1, 0]\nmass_kg = "
      "1\n[ground]\ndefault = \"Slope\"\n" +
      materials;
  return sources_of_values(read_project_text(text, "slope.toml").project);
}

TEST(MaterialSources, AreThoseOfTheLibrary) {
  const LibraryMaterial& entry = *material_library().find("talus_cover");
  const auto found = sources_in("[[material]]\nname = \"Slope\"\nlike = \"talus_cover\"\n");
  ASSERT_FALSE(found.empty());
  std::size_t keys = 0;
  for (const SourceOfValues& each : found) {
    EXPECT_EQ(each.material, "Slope");
    EXPECT_EQ(each.like, "talus_cover");
    for (const std::string& key : each.keys)
      EXPECT_EQ(each.source, material_library().sources.at(entry.find(key)->source).text) << key;
    keys += each.keys.size();
  }
  EXPECT_EQ(keys, entry.given.size());
}

TEST(MaterialSources, LeaveOutValuesOfTheProject) {
  EXPECT_TRUE(sources_in("[[material]]\nname = \"Slope\"\nnormal_restitution = 0.3\n").empty());
  const auto found = sources_in("[[material]]\nname = \"Slope\"\nlike = \"talus_cover\"\nnormal_restitution = 0.123\n");
  for (const SourceOfValues& each : found)
    EXPECT_THAT(each.keys, ::testing::Not(::testing::Contains("normal_restitution")));
}

}  // namespace
}  // namespace talus::project
