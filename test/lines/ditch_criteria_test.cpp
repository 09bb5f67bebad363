// Published widths beside a ditch.

#include "talus/lines/ditch_criteria.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace talus {
namespace {

constexpr double degree = std::numbers::pi / 180;

TEST(DitchCriteria, GiveTheWidthOfTheModifiedRitchieCriterion) {
  const auto criteria = ditch_criteria({20, 75 * degree});
  ASSERT_EQ(criteria.size(), 3u);
  ASSERT_TRUE(criteria[0].width.has_value());
  EXPECT_DOUBLE_EQ(*criteria[0].width, 8.5);
  EXPECT_EQ(criteria[0].text,
            "8.5 m: catch benches of mines, W = 0.2 H + 4.5 m; for about 90 % of the rocks, less suffices on faces "
            "steeper than 65 degrees, as here");
  EXPECT_EQ(criteria[1].text,
            "within the tested range: look up its chart for 66 ft and 0.27H:1V, and compare the share retained; the "
            "values of the charts are not in Talus");
  EXPECT_FALSE(criteria[1].width.has_value());
  EXPECT_FALSE(criteria[2].width.has_value());
}

TEST(DitchCriteria, SayNothingOutsideOfTheTests) {
  for (const SlopeAbove& slope : {SlopeAbove{12.1, 70 * degree}, SlopeAbove{24.5, 70 * degree},
                                  SlopeAbove{20, 44 * degree}, SlopeAbove{20, 91 * degree}}) {
    EXPECT_FALSE(is_in_tested_range(slope));
    for (const DitchCriterion& criterion : ditch_criteria(slope)) EXPECT_FALSE(criterion.width.has_value());
    EXPECT_EQ(ditch_criteria(slope)[1].text,
              "outside of the chart: tested were slopes of 12.2 to 24.4 m (40 to 80 ft), from 1H:1V (45 degrees) to "
              "vertical");
  }
  for (const SlopeAbove& slope : {SlopeAbove{40 * 0.3048, 45 * degree}, SlopeAbove{80 * 0.3048, 90 * degree}})
    EXPECT_TRUE(is_in_tested_range(slope));
}

}  // namespace
}  // namespace talus
