#include "talus/model/drawn.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "talus/project/settings.hpp"

namespace talus::project {
namespace {

TEST(RandomProperties, AreTheSettingsDeclaredAsDistributions) {
  Project project;
  std::size_t random = 0;
  for (const char* const key : {"material", "seeder"}) {
    const Row row = table(key).add(project);
    for (const Setting& setting : table(key).settings) {
      const bool is_random = is_random_property(setting.slot(row));
      const auto what = drawn(setting.key, constant(1));
      EXPECT_EQ(what.has_value(), is_random) << key << "." << setting.key;
      if (!what || setting.key == "roughness_deg") continue;
      ++random;
      EXPECT_EQ(what->bounds.least, bounds(setting.range).least) << setting.key;
      EXPECT_EQ(what->bounds.most, bounds(setting.range).most) << setting.key;
    }
  }
  EXPECT_EQ(random, 13u);
}

TEST(RandomProperties, ThatAreNotDeclaredAreAnErrorOfTheProgram) {
  EXPECT_THROW(sampler_of("colour", constant(1)), std::logic_error);
  EXPECT_THROW(sampler_of("forest_height_m", constant(1)), std::logic_error);
}

// A plain number of the roughness is the standard deviation of the tilt.
TEST(RandomProperties, ARoughnessIsDrawnAboutZero) {
  const auto what = drawn("roughness_deg", constant(8));
  EXPECT_EQ(what->distribution.mean, 0);
  EXPECT_EQ(what->distribution.std_dev, 8);
  EXPECT_EQ(what->bounds.least, -90);
}

}  // namespace
}  // namespace talus::project
