#include "talus/terrain/bvh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "support/dice.hpp"

namespace talus::bvh_test {
namespace {

using testing_tools::Dice;

std::vector<Box> random_boxes(Dice& dice, std::size_t count) {
  std::vector<Box> boxes(count);
  for (Box& box : boxes) {
    const Vec3 middle = dice.in_cube(50);
    box.grow(middle);
    if (dice.chance(0.8)) box.grow(middle + dice.magnitude(1e-3, 5) * dice.in_cube(1));
  }
  return boxes;
}

std::set<std::uint32_t> numbers(const Bvh& bvh, std::uint32_t first, std::uint32_t last) {
  return {bvh.order().begin() + first, bvh.order().begin() + last};
}

bool overlap(const Box& a, const Vec3& low, const Vec3& high) {
  return a.low.is_at_most(high) && low.is_at_most(a.high);
}

TEST(Bvh, OrderIsAPermutation) {
  Dice dice(121);
  for (const std::size_t count : {1, 2, 3, 4, 5, 17, 1000}) {
    const Bvh bvh(random_boxes(dice, count));
    std::vector<std::uint32_t> order = bvh.order();
    std::sort(order.begin(), order.end());
    for (std::uint32_t i = 0; i < count; ++i) ASSERT_EQ(order[i], i);
  }
}

TEST(Bvh, EmptyMeetsNothing) {
  const Bvh bvh(std::span<const Box>{});
  int leaves = 0;
  double t_max = 10;
  bvh.visit_box(Vec3::all(-1e9), Vec3::all(1e9), [&](std::uint32_t, std::uint32_t) { ++leaves; });
  bvh.visit_flight({Vec3{}, unit_x, Vec3{}}, 1, t_max, [&](std::uint32_t, std::uint32_t, double&) { ++leaves; });
  EXPECT_EQ(leaves, 0);
}

TEST(Bvh, TheSameBoxesGiveTheSameTree) {
  Dice a(122), b(122);
  // Enough for more than one task, so that threads are used.
  const Bvh first(random_boxes(a, 60'000)), second(random_boxes(b, 60'000));
  EXPECT_EQ(first.order(), second.order());
  EXPECT_EQ(first.bytes(), second.bytes());
}

TEST(Bvh, ManyEqualBoxesMakeAShallowTree) {
  std::vector<Box> boxes(10'000);
  for (Box& box : boxes) box.grow(Vec3(1, 2, 3));
  const Bvh bvh(boxes);
  std::size_t met = 0;
  bvh.visit_box({1, 2, 3}, {1, 2, 3}, [&](std::uint32_t first, std::uint32_t last) { met += last - first; });
  EXPECT_EQ(met, boxes.size());
}

TEST(Bvh, VisitBoxMissesNothing) {
  Dice dice(123);
  const auto boxes = random_boxes(dice, 3000);
  const Bvh bvh(boxes);
  for (int i = 0; i < 300; ++i) {
    Box query;
    query.grow(dice.in_cube(60));
    query.grow(query.low + dice.magnitude(0.1, 60) * Vec3(dice.unit(), dice.unit(), dice.unit()));
    std::set<std::uint32_t> met;
    std::size_t visited = 0;
    bvh.visit_box(query.low, query.high, [&](std::uint32_t first, std::uint32_t last) {
      met.merge(numbers(bvh, first, last));
      visited += last - first;
    });
    ASSERT_EQ(met.size(), visited);  // none twice
    for (std::uint32_t k = 0; k < boxes.size(); ++k) {
      if (overlap(boxes[k], query.low, query.high)) {
        ASSERT_TRUE(met.contains(k));
      }
    }
  }
}

TEST(Bvh, VisitFlightMissesNothing) {
  Dice dice(124);
  const auto boxes = random_boxes(dice, 2000);
  const Bvh bvh(boxes);
  std::size_t visited = 0;
  for (int i = 0; i < 500; ++i) {
    Parabola path{dice.in_cube(60), dice.direction(), {0, 0, dice.chance(0.5) ? -9.81 : 0.0}};
    path.v *= dice.between(0, 30);
    if (dice.chance(0.1)) path.v.x() = 0;
    if (dice.chance(0.1)) path.v.y() = 0;
    const double pad = dice.between(0, 2), t_end = dice.between(0.1, 6);
    std::set<std::uint32_t> met;
    double t_max = t_end;
    bvh.visit_flight(path, pad, t_max,
                     [&](std::uint32_t first, std::uint32_t last, double&) { met.merge(numbers(bvh, first, last)); });
    visited += met.size();
    for (int k = 0; k <= 400; ++k) {
      const Vec3 q = path.at(t_end * k / 400);
      for (std::uint32_t b = 0; b < boxes.size(); ++b) {
        if (overlap(boxes[b], q - Vec3::all(0.999 * pad), q + Vec3::all(0.999 * pad))) {
          ASSERT_TRUE(met.contains(b));
        }
      }
    }
  }
  EXPECT_LT(visited, 500 * boxes.size() / 4);  // and most are skipped
}

// Boxes are visited in order of time, and those after a contact are skipped.
TEST(Bvh, VisitFlightStopsAtAContact) {
  std::vector<Box> boxes;
  for (int k = 0; k < 1000; ++k) {
    Box box;
    box.grow(Vec3(k, -1, -1));
    box.grow(Vec3(k + 0.5, 1, 1));
    boxes.push_back(box);
  }
  const Bvh bvh(boxes);
  double t_max = 1e6, previous = -1;
  int leaves = 0;
  bvh.visit_flight({{-10, 0, 0}, {1, 0, 0}, {0, 0, 0}}, 0, t_max, [&](std::uint32_t first, std::uint32_t, double& t) {
    const double x = boxes[bvh.order()[first]].low.x();
    EXPECT_GE(x, previous - 4);
    previous = x;
    if (++leaves == 3) t = x + 10 + 4;
  });
  EXPECT_LT(leaves, 8);
}

TEST(FlightSlabs, TheWindowOfABoxContainsEveryTimeNearIt) {
  Dice dice(129);
  int near = 0, far = 0;
  for (int i = 0; i < 2000; ++i) {
    Box box;
    box.grow(dice.in_cube(3));
    box.grow(dice.in_cube(3));
    const double pad = dice.magnitude(0.01, 1), t_max = 2;
    const Parabola path{dice.in_cube(6), dice.in_cube(8), {0, 0, dice.chance(0.9) ? -9.81 : 0.0}};
    const TimeWindow window = FlightSlabs(path).window(box, pad, t_max);
    if (window.is_empty()) ++far;
    for (int k = 0; k <= 200; ++k) {
      const double t = t_max * k / 200;
      const Vec3 q = path.at(t);
      const bool is_near = (box.low - Vec3::all(pad)).is_at_most(q) && q.is_at_most(box.high + Vec3::all(pad));
      if (!is_near) continue;
      ++near;
      ASSERT_GE(t, window.enter - 1e-12);
      ASSERT_LE(t, window.leave + 1e-12);
    }
  }
  EXPECT_GT(near, 1000);
  EXPECT_GT(far, 200);
}

TEST(Bvh, FromTheEndVisitsTheLastFirstAndMissesNothing) {
  Dice dice(125);
  const auto boxes = random_boxes(dice, 2000);
  const Bvh bvh(boxes);
  std::size_t visited = 0;
  for (int i = 0; i < 500; ++i) {
    Parabola path{dice.in_cube(60), dice.direction(), {0, 0, -9.81}};
    path.v *= dice.between(5, 30);
    path.p.z() = 60;
    const double t_end = dice.between(1, 6);
    // A box must be visited if the path is over it on plan, and not below it, until that time.
    const auto last_over = [&](const Box& box) {
      double last = -1;
      for (int k = 0; k <= 400; ++k) {
        const Vec3 q = path.at(t_end * k / 400);
        const bool is_over = q.x() >= box.low.x() && q.x() <= box.high.x() && q.y() >= box.low.y() &&
                             q.y() <= box.high.y() && q.z() > box.low.z();
        if (is_over) last = t_end * k / 400;
      }
      return last;
    };
    double expected = -1, last = -1;
    for (const Box& box : boxes) expected = std::max(expected, last_over(box));
    bvh.visit_under_from_the_end(path, last, t_end, 0, [&](std::uint32_t first, std::uint32_t end, double& t_from) {
      for (const std::uint32_t k : numbers(bvh, first, end)) {
        t_from = std::max(t_from, last_over(boxes[k]));
        ++visited;
      }
    });
    ASSERT_EQ(last, expected);
  }
  EXPECT_LT(visited, 500U * 40);  // boxes that the path passes before t_from are skipped
}

}  // namespace
}  // namespace talus::bvh_test
