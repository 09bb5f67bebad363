// Legs along the ground in few parts: of slides with known motion.

#include "talus/store/ground_parts.hpp"

#include <gtest/gtest.h>

#include <functional>

namespace talus {
namespace {

std::vector<Motion> motions_of(const std::function<Motion(double)>& at, double duration, int count) {
  std::vector<Motion> motions;
  for (int k = 0; k <= count; ++k) motions.push_back(at(duration * k / count));
  return motions;
}

std::vector<std::size_t> parts_of(const std::vector<Motion>& motions) {
  std::vector<std::size_t> ends;
  divide_into_parts(motions, ends);
  return ends;
}

TEST(GroundParts, ConstantAccelerationIsOnePart) {
  const Vec3 v(3, -1, -2), a(0.5, 0.2, -0.3);
  const auto motions = motions_of(
      [&](double t) {
        return Motion{Vec3(t * v + 0.5 * t * t * a), v + t * a, Vec3(0, 1 + t, 0), 7 + t};
      },
      5, 500);
  EXPECT_EQ(parts_of(motions), std::vector<std::size_t>{500});
  const PathPiece part = ground_part(motions.front(), motions.back());
  EXPECT_LT((part.path.v - v).norm(), 1e-12);
  EXPECT_LT((part.path.a - a).norm(), 1e-12);
  EXPECT_EQ(part.velocity(0), v);
  EXPECT_EQ(part.velocity(part.duration), motions.back().velocity);
  EXPECT_LT((part.path.at(5) - motions.back().position).norm(), 1e-12);
}

TEST(GroundParts, ASlideInStepsKeepsItsEnds) {
  // Each step moves with the velocity of its end, so that places lie ahead of constant acceleration.
  std::vector<Motion> motions{{Vec3{}, Vec3(1, 0, 0), Vec3{}, 0}};
  for (int k = 1; k <= 1000; ++k) {
    Motion next = motions.back();
    next.velocity.x() += 0.03;
    next.position += 0.01 * next.velocity;
    next.time += 0.01;
    motions.push_back(next);
  }
  EXPECT_EQ(parts_of(motions), std::vector<std::size_t>{1000});
  const PathPiece part = ground_part(motions.front(), motions.back());
  EXPECT_LT((part.path.at(5) - motions[500].position).norm(), 1e-9);
}

TEST(GroundParts, ACurveHasFewParts) {
  // Round a circle of 10 m at 5 m/s.
  const auto circle = [](double t) {
    const double angle = 0.5 * t;
    return Motion{10 * Vec3(std::cos(angle), std::sin(angle), 0), 5 * Vec3(-std::sin(angle), std::cos(angle), 0),
                  Vec3{}, t};
  };
  const auto motions = motions_of(circle, 10, 1000);
  const auto ends = parts_of(motions);
  // The velocity turns by 5 rad; a part in which it turns by 28 mrad is within 1e-4 of it.
  EXPECT_GT(ends.size(), 5 / 0.0283);
  EXPECT_LT(ends.size(), 1.2 * 5 / 0.025);
  EXPECT_EQ(ends.back(), 1000U);
  EXPECT_TRUE(std::is_sorted(ends.begin(), ends.end()));
}

TEST(GroundParts, ABendEndsAPart) {
  const auto bend = [](double t) {
    const Vec3 before(4, 0, 0), after(3, 1, 0);
    return Motion{std::min(t, 1.0) * before + std::max(0.0, t - 1) * after, t <= 1 ? before : after, Vec3{}, t};
  };
  std::vector<Motion> motions = motions_of(bend, 2, 200);
  EXPECT_EQ(parts_of(motions), (std::vector<std::size_t>{100, 101, 200}));
}

TEST(GroundParts, MotionsAtTheSameTimeArePartsOfTheirOwn) {
  const std::vector<Motion> motions{{Vec3{}, Vec3(1, 0, 0), Vec3{}, 1},
                                    {Vec3{}, Vec3(0, 1, 0), Vec3{}, 1},
                                    {Vec3(0, 1, 0), Vec3(0, 1, 0), Vec3{}, 2}};
  EXPECT_EQ(parts_of(motions), (std::vector<std::size_t>{1, 2}));
  EXPECT_EQ(ground_part(motions[0], motions[1]).duration, 0);
}

}  // namespace
}  // namespace talus
