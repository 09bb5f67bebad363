#include "talus/files/mistyped_column.hpp"

#include <gtest/gtest.h>

#include <array>

namespace talus {
namespace {

TEST(MistypedColumns, AreAWrongLetterOrTwoFromAKnownName) {
  constexpr std::array<std::string_view, 4> known{"release", "mass_kg", "velocity_m_s", "rock"};
  EXPECT_EQ(mistyped_column("relase", known), "release");
  EXPECT_EQ(mistyped_column("releaes", known), "release");  // exchanged letters
  EXPECT_EQ(mistyped_column("relaesed", known), "release");
  EXPECT_EQ(mistyped_column("mas_kg", known), "mass_kg");
  EXPECT_EQ(mistyped_column("velosity_m_s", known), "velocity_m_s");
  EXPECT_EQ(mistyped_column("release", known), std::nullopt);
  EXPECT_EQ(mistyped_column("relief", known), std::nullopt);
  // Short names, and names with another word or number.
  EXPECT_EQ(mistyped_column("block", known), std::nullopt);
  EXPECT_EQ(mistyped_column("rocks", known), std::nullopt);
  EXPECT_EQ(mistyped_column("release_a", known), std::nullopt);
  EXPECT_EQ(mistyped_column("release2", known), std::nullopt);
}

}  // namespace
}  // namespace talus
