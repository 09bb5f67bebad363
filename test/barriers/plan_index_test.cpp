#include "talus/barriers/plan_index.hpp"

#include <gtest/gtest.h>

#include "support/dice.hpp"

namespace talus::plan_index_test {
namespace {

using namespace testing_tools;

std::vector<PlanBounds> random_row(Dice& dice, std::size_t count) {
  std::vector<PlanBounds> row(count);
  Vec2 p(0, 0);
  for (PlanBounds& bounds : row) {
    bounds.grow(p);
    p += Vec2(dice.between(-1, 3), dice.between(-2, 2));
    bounds.grow(p);
  }
  return row;
}

TEST(PlanIndex, VisitsExactlyTheRectanglesThatMeetInOrder) {
  Dice dice(41);
  std::size_t met = 0;
  for (int k = 0; k < 500; ++k) {
    const auto row = random_row(dice, dice.below(40));
    const PlanIndex index(row);
    PlanBounds query;
    query.grow(Vec2(dice.between(-10, 60), dice.between(-20, 20)));
    query.grow(query.low + Vec2(dice.between(0, 30), dice.between(0, 20)));
    std::vector<std::size_t> expected, found;
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (row[i].meet(query)) expected.push_back(i);
    }
    index.visit(query, [&](std::size_t i) { found.push_back(i); });
    ASSERT_EQ(found, expected);
    met += found.size();
  }
  EXPECT_GT(met, 300U);
}

TEST(PlanIndex, FindsTheNearest) {
  Dice dice(42);
  for (int k = 0; k < 500; ++k) {
    const auto row = random_row(dice, 1 + dice.below(40));
    const Vec2 p(dice.between(-10, 60), dice.between(-20, 20));
    double expected = 1e300;
    for (const PlanBounds& bounds : row) expected = std::min(expected, bounds.distance(p));
    ASSERT_EQ(PlanIndex(row).distance(p, 1e300), expected);
    ASSERT_EQ(PlanIndex(row).distance(p, expected / 2), expected / 2);
  }
}

TEST(PlanIndex, WithoutRectanglesVisitsNone) {
  int visits = 0;
  PlanBounds everywhere;
  everywhere.grow(Vec2(-1e9, -1e9));
  everywhere.grow(Vec2(1e9, 1e9));
  PlanIndex().visit(everywhere, [&](std::size_t) { ++visits; });
  PlanIndex(std::vector<PlanBounds>{}).visit(everywhere, [&](std::size_t) { ++visits; });
  EXPECT_EQ(visits, 0);
}

}  // namespace
}  // namespace talus::plan_index_test
