// Glides: steps of a slide in coordinates on the facet, of one rock alone or of several in lanes.

#include "talus/sliding/glide.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <deque>

#include "support/dice.hpp"
#include "talus/sliding/drag.hpp"
#include "talus/sliding/stepped.hpp"

namespace talus::glide_test {
namespace {

using testing_tools::Dice;

constexpr GlideLaws laws{0.1, 600};
constexpr double timestep = 0.01;

/// A glide on a triangle of some metres, with the rock inside it.
Glide random_glide(Dice& dice) {
  Glide glide;
  const double direction = dice.between(0, 6.3);
  glide.speed = dice.magnitude(0.1, 20);
  glide.vx = glide.speed * std::cos(direction);
  glide.vy = glide.speed * std::sin(direction);
  glide.speed = std::sqrt(glide.vx * glide.vx + glide.vy * glide.vy);
  glide.time = dice.between(0, 30);
  glide.timestep = timestep;
  glide.gain = timestep * dice.between(0.1, 9);
  glide.braking = timestep * dice.between(0, 9);
  if (dice.chance(0.5)) glide.kept = dice.between(0.8, 1);
  for (std::size_t k = 0; k < 3; ++k) {
    const double inward = 2.1 * static_cast<double>(k) + dice.between(-0.5, 0.5);
    glide.sides[k] = {dice.magnitude(0.01, 5), std::cos(inward), std::sin(inward)};
  }
  if (dice.chance(0.2)) glide.squared_way = dice.between(0, 1);
  return glide;
}

std::array<std::uint64_t, 6> bits_of(const Glide& glide) {
  const double numbers[] = {glide.x, glide.y, glide.vx, glide.vy, glide.speed, glide.time};
  std::array<std::uint64_t, 6> bits{};
  for (std::size_t k = 0; k < 6; ++k) bits[k] = std::bit_cast<std::uint64_t>(numbers[k]);
  return bits;
}

TEST(Glide, StepsLikeASlide) {
  Dice dice(1);
  int steps = 0;
  for (int k = 0; k < 2000; ++k) {
    Glide glide = random_glide(dice);
    const Vec3 velocity(glide.vx, glide.vy, 0);
    const Footing footing{{glide.gain / timestep, 0, 0}, glide.braking / timestep};
    const double rate = -std::log(glide.kept) / timestep,
                 undragged = glide.kept < 1 ? share_with_drag(rate * timestep) : 1;
    const Footing full{footing.pull / undragged, footing.normal_acceleration / undragged};
    const Leg leg = stepped_leg({glide.x, glide.y, 0}, velocity, Vec3{},
                                glide.kept < 1 ? dragged(full, velocity, rate, timestep, 1) : full, 1, timestep);
    if (!try_step(laws, glide)) continue;
    ++steps;
    EXPECT_EQ(leg.duration, timestep);
    const Vec3 end = leg.path.at(leg.duration);
    EXPECT_NEAR(glide.x, end.x(), 1e-14);
    EXPECT_NEAR(glide.y, end.y(), 1e-14);
    EXPECT_NEAR(glide.vx, leg.end_velocity.x(), 1e-13);
    EXPECT_NEAR(glide.vy, leg.end_velocity.y(), 1e-13);
    EXPECT_NEAR(glide.speed, leg.end_velocity.norm(), 1e-13);
  }
  EXPECT_GT(steps, 1000);
}

// Down the line of fall the recurrence has a closed form: v = v0 + k (gain - braking), x = dt (k v0 + k (k + 1) / 2
// (gain - braking)).
TEST(Glide, FollowsTheClosedFormDownTheLineOfFall) {
  Glide glide;
  glide.timestep = timestep;
  glide.vx = glide.speed = 2;
  glide.gain = 0.05;
  glide.braking = 0.03;
  glide.sides[0] = {100, -1, 0};
  int k = 0;
  while (try_step(laws, glide)) {
    ++k;
    EXPECT_NEAR(glide.vx, 2 + k * 0.02, 1e-11);
    EXPECT_NEAR(glide.x, 0.01 * (2 * k + 0.02 * k * (k + 1) / 2), 1e-10);
    EXPECT_EQ(glide.vy, 0);
  }
  EXPECT_EQ(k, 904);  // the last step before x = 100: 0.01 (2 k + 0.01 k (k + 1)) = 100 at k = 904.99
}

// With drag v = c/k + (v0 - c/k) e^(-k t), exact at the end of every step for any timestep; a step moves the rock with
// the velocity at its end.
TEST(Glide, HasTheExactVelocityOfADraggedSlide) {
  for (const double rate : {0.05, 0.7, 9.0}) {
    constexpr double net = 1.2, friction = 3;
    const double share = share_with_drag(rate * timestep);
    Glide glide;
    glide.timestep = timestep;
    glide.vx = glide.speed = 6;
    glide.kept = 1 - share * rate * timestep;
    glide.gain = share * timestep * (net + friction);
    glide.braking = share * timestep * friction;
    double x = 0;
    for (int k = 1; k <= 400 && try_step(laws, glide); ++k) {
      const double exact = net / rate + (6 - net / rate) * std::exp(-rate * k * timestep);
      x += timestep * exact;
      ASSERT_NEAR(glide.vx, exact, 1e-11);
      ASSERT_NEAR(glide.x, x, 1e-10);
    }
    EXPECT_NEAR(glide.time, 4, 1e-9) << rate;
  }
}

TEST(Glide, EndsBeforeItsLimits) {
  const auto steps_of = [](Glide glide) {
    int steps = 0;
    while (try_step(laws, glide)) ++steps;
    return steps;
  };
  Glide plain;
  plain.timestep = timestep;
  plain.vx = plain.speed = 1;
  plain.gain = plain.braking = 0.05;  // at constant speed: 1 cm per step
  plain.sides[0] = {0.0951, -1, 0};
  EXPECT_EQ(steps_of(plain), 9);
  Glide short_way = plain;
  short_way.squared_way = 0.0451 * 0.0451;
  EXPECT_EQ(steps_of(short_way), 4);
  Glide late = plain;
  late.time = 600 - 0.0351;
  EXPECT_EQ(steps_of(late), 3);
  Glide braked = plain;
  braked.gain = 0;
  braked.braking = 0.2;  // 1, 0.8, 0.6, 0.4, 0.2: the next step would stop it
  EXPECT_EQ(steps_of(braked), 4);
}

// Glides of any length, started whenever a lane is free, have the same bits and steps as alone.
TEST(GlideLanes, GiveTheSameBitsAsEachGlideAlone) {
  Dice dice(2);
  std::deque<Glide> glides;
  std::deque<std::vector<GlideStep>> traces;
  GlideLanes lanes(laws);
  std::vector<std::size_t> ended;
  constexpr std::size_t count = 3000;
  std::deque<Glide> starts;
  while (ended.size() < count) {
    while (glides.size() < count && !lanes.is_full() && (lanes.is_empty() || dice.chance(0.9))) {
      glides.push_back(random_glide(dice));
      starts.push_back(glides.back());
      traces.emplace_back();
      const bool is_traced = glides.size() % 3 != 0;
      lanes.add(glides.back(), is_traced ? &traces.back() : nullptr, glides.size() - 1);
    }
    lanes.run(nullptr, [&](std::size_t name) { ended.push_back(name); });
  }
  EXPECT_TRUE(lanes.is_empty());
  std::sort(ended.begin(), ended.end());
  std::size_t steps = 0;
  for (std::size_t k = 0; k < count; ++k) {
    ASSERT_EQ(ended[k], k);
    Glide alone = starts[k];
    std::size_t number = 0;
    while (try_step(laws, alone)) {
      if (k % 3 != 2) {
        ASSERT_LT(number, traces[k].size());
        ASSERT_EQ(traces[k][number].x, alone.x);
        ASSERT_EQ(traces[k][number].vy, alone.vy);
      }
      ++number;
    }
    ASSERT_EQ(traces[k].size(), k % 3 != 2 ? number : 0U);
    ASSERT_EQ(bits_of(glides[k]), bits_of(alone)) << k;
    steps += number;
  }
  EXPECT_GT(steps, 30'000U);
}

}  // namespace
}  // namespace talus::glide_test
