#include "talus/project/decimal_comma.hpp"

#include <gtest/gtest.h>

namespace talus::project {
namespace {

TEST(DecimalComma, IsReplacedByAPoint) {
  EXPECT_EQ(with_decimal_point("0,8"), "0.8");
  EXPECT_EQ(with_decimal_point("-12,25"), "-12.25");
  EXPECT_EQ(with_decimal_point("0,125"), "0.125");
}

TEST(DecimalComma, MayBeAThousandsSeparator) {
  EXPECT_EQ(with_decimal_point("1,000"), "1.000 or 1000");
  EXPECT_EQ(with_decimal_point("-25,500"), "-25.500 or -25500");
}

TEST(DecimalComma, IsNotFoundInOtherTexts) {
  for (const char* text : {"", "8", "0.8", ",8", "8,", "1,2,3", "1, 2", "-,5", "a,5", "0,5m"}) {
    EXPECT_EQ(with_decimal_point(text), "") << text;
  }
}

TEST(DecimalComma, IsFoundInALine) {
  EXPECT_EQ(first_with_decimal_point("roughness_deg = 0,8"), "0.8");
  EXPECT_EQ(first_with_decimal_point("roughness_deg=0,8  # degrees"), "0.8");
  EXPECT_EQ(first_with_decimal_point("p = { std_dev = 0.1, mean = 0,8, rel_min = 0.1 }"), "0.8");
  EXPECT_EQ(first_with_decimal_point("p = { mean = 0,8 }"), "0.8");
  EXPECT_EQ(first_with_decimal_point("p = [0,8]"), "");
  EXPECT_EQ(first_with_decimal_point("p ="), "");
}

}  // namespace
}  // namespace talus::project
