#include "talus/archive/foot_stretch.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace talus {
namespace {

using testing::ElementsAre;
using Point = std::array<double, 3>;

const std::vector<Point> foot{{0, 0, 0}, {30, 40, 5}, {30, 100, 0}};  // 50 m and 60 m on plan
const std::vector<double> stations{0, 50, 110};

TEST(FootStretch, IsCutAtStationsOnPlan) {
  EXPECT_THAT(stretch_of(foot, stations, 0, 25), ElementsAre(Point{0, 0, 0}, Point{15, 20, 2.5}));
  EXPECT_THAT(stretch_of(foot, stations, 25, 80),
              ElementsAre(Point{15, 20, 2.5}, Point{30, 40, 5}, Point{30, 70, 2.5}));
  EXPECT_THAT(stretch_of(foot, stations, 50, 110), ElementsAre(Point{30, 40, 5}, Point{30, 100, 0}));
  EXPECT_THAT(stretch_of(foot, stations, 0, 110), ElementsAre(foot[0], foot[1], foot[2]));
}

TEST(FootStretch, EndsAtTheEndOfTheLine) {
  EXPECT_THAT(stretch_of(foot, stations, 80, 1000), ElementsAre(Point{30, 70, 2.5}, Point{30, 100, 0}));
  EXPECT_THAT(stretch_of(foot, stations, 110, 120), ElementsAre(foot[1], foot[2]));
}

TEST(FootStretch, OfAPointIsThePoint) {
  EXPECT_THAT(stretch_of({{1, 2, 3}}, {0}, 0, 10), ElementsAre(Point{1, 2, 3}));
  EXPECT_TRUE(stretch_of({}, {}, 0, 10).empty());
}

TEST(AlongAFoot, TheStationOfAPlaceIsAtTheNearestPoint) {
  EXPECT_DOUBLE_EQ(station_of(foot, stations, 15, 20), 25);
  EXPECT_DOUBLE_EQ(station_of(foot, stations, 15 + 8, 20 - 6), 25);  // next to the line
  EXPECT_DOUBLE_EQ(station_of(foot, stations, 29, 70), 80);
  EXPECT_DOUBLE_EQ(station_of(foot, stations, -5, -5), 0);
  EXPECT_DOUBLE_EQ(station_of(foot, stations, 31, 500), 110);
  EXPECT_EQ(station_of({{1, 2, 3}}, {0}, 7, 8), 0);
}

TEST(AlongAFoot, StationsAreOnPlan) {
  EXPECT_EQ(stations_along(foot), stations);
  EXPECT_TRUE(stations_along({}).empty());
}

TEST(AlongAFoot, StationsStartWhereTheLineBeginsBeforeItsFoot) {
  const std::vector<double> later{20, 70, 130};
  EXPECT_THAT(stretch_of(foot, later, 0, 45), ElementsAre(Point{0, 0, 0}, Point{15, 20, 2.5}));
  EXPECT_DOUBLE_EQ(station_of(foot, later, 15, 20), 45);
  EXPECT_DOUBLE_EQ(station_of(foot, later, -5, -5), 20);
}

}  // namespace
}  // namespace talus
