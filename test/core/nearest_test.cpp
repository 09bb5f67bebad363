#include "talus/core/nearest.hpp"

#include <gtest/gtest.h>

#include <array>

namespace talus::nearest_test {
namespace {

constexpr std::array<std::string_view, 4> known{"gravity_m_s2", "max_steps", "max_time_s", "mass_kg"};

TEST(Nearest, DistanceCountsEdits) {
  EXPECT_EQ(edit_distance("", ""), 0u);
  EXPECT_EQ(edit_distance("", "abc"), 3u);
  EXPECT_EQ(edit_distance("abc", "abc"), 0u);
  EXPECT_EQ(edit_distance("abc", "abd"), 1u);   // replaced
  EXPECT_EQ(edit_distance("abc", "ab"), 1u);    // deleted
  EXPECT_EQ(edit_distance("abc", "abxc"), 1u);  // inserted
  EXPECT_EQ(edit_distance("abc", "acb"), 1u);   // swapped
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3u);
}

TEST(Nearest, DistanceIsSymmetric) {
  EXPECT_EQ(edit_distance("std_dev", "stddev"), edit_distance("stddev", "std_dev"));
  EXPECT_EQ(edit_distance("position", "points"), edit_distance("points", "position"));
}

TEST(Nearest, CapitalsAndDashesDoNotCount) {
  EXPECT_EQ(edit_distance("Max-Steps", "max_steps"), 0u);
  EXPECT_EQ(edit_distance("max steps", "max_steps"), 0u);
}

TEST(Nearest, FindsTheNearestOfSeveral) {
  EXPECT_EQ(nearest("max_step", known), "max_steps");
  EXPECT_EQ(nearest("max_times", known), "max_time_s");
}

TEST(Nearest, FindsAKeyWithoutItsUnit) {
  EXPECT_EQ(nearest("gravity", known), "gravity_m_s2");
  EXPECT_EQ(nearest("mass", known), "mass_kg");
}

TEST(Nearest, ReturnsNothingIfNoWordIsNear) {
  EXPECT_EQ(nearest("wind", known), std::nullopt);
  EXPECT_EQ(nearest("", known), std::nullopt);
  EXPECT_EQ(nearest("x", {}), std::nullopt);
}

}  // namespace
}  // namespace talus::nearest_test
