#include "talus/impact/roughness.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/dice.hpp"
#include "support/scenes.hpp"

namespace talus::roughness_test {
namespace {

using namespace testing_tools;

TEST(Roughness, TiltsByTheAngles) {
  const Vec3 ahead = tilted_normal(unit_z, unit_x, 0.2, 0);
  EXPECT_LT((ahead - Vec3(-std::sin(0.2), 0, std::cos(0.2))).norm(), 1e-15);
  const Vec3 aside = tilted_normal(unit_z, unit_x, 0, 0.2);
  EXPECT_LT((aside - Vec3(0, std::sin(0.2), std::cos(0.2))).norm(), 1e-15);
  EXPECT_EQ(tilted_normal(unit_z, unit_x, 0, 0), unit_z);
}

// A positive angle raises the ground against the rock.
TEST(Roughness, AheadRisesAgainstTheRock) {
  const Vec3 v(5, 0, -1);
  EXPECT_LT(v.dot(tilted_normal(unit_z, unit_x, 0.1, 0)), v.z());
  EXPECT_GT(v.dot(tilted_normal(unit_z, unit_x, -0.1, 0)), v.z());
}

TEST(Roughness, NeverTurnsTheGroundOver) {
  Dice dice(71);
  for (int i = 0; i < 100'000; ++i) {
    const Vec3 n = dice.direction(), heading = tangential(dice.direction(), n).normalized();
    const Vec3 tilted = tilted_normal(n, heading, dice.between(-100, 100), dice.between(-100, 100));
    ASSERT_GT(tilted.dot(n), 0);
    ASSERT_NEAR(tilted.norm(), 1, 1e-14);
  }
}

TEST(Roughness, KeptOutsideRemovesOnlyTheComponentIntoTheFacet) {
  EXPECT_EQ(kept_outside({1, 2, 3}, unit_z), Vec3(1, 2, 3));
  EXPECT_EQ(kept_outside({1, 2, -3}, unit_z), Vec3(1, 2, 0));
}

// A material with a normal roughness: standard deviation of the angle, ahead and aside, without correlation.
TEST(Roughness, AnglesHaveTheirStandardDeviation) {
  Soil soil;
  soil.roughness = 0.1;
  const Material material = material_of(soil);
  EXPECT_FALSE(material.roughness.is_smooth());
  const int count = 20'000;
  double sum[2] = {0, 0}, squares[2] = {0, 0}, product = 0;
  for (int i = 0; i < count; ++i) {
    const Draws draws(SamplingPlan{}, static_cast<std::uint64_t>(i));
    const auto [ahead, aside] =
        GroundDraw(draws, MaterialSampling::per_impact, MaterialId{0}, 3).tilt_at_impact(material, 3);
    const double tilt[] = {ahead, aside};
    for (std::size_t k = 0; k < 2; ++k) {
      sum[k] += tilt[k];
      squares[k] += tilt[k] * tilt[k];
    }
    product += tilt[0] * tilt[1];
  }
  for (const int k : {0, 1}) {
    // Four standard errors, of the mean and of the variance.
    EXPECT_LT(std::abs(sum[k] / count), 4 * 0.1 / std::sqrt(count));
    EXPECT_LT(std::abs(squares[k] / count - 0.01), 4 * 0.01 * std::sqrt(2.0 / count));
  }
  EXPECT_LT(std::abs(product / count), 4 * 0.01 / std::sqrt(count));
}

// Two heights of standard deviation s, a spacing d apart: the tangent of the angle has standard deviation sqrt(2) s/d.
TEST(Roughness, SpacingAndAmplitude) {
  Material material = material_of({});
  EXPECT_TRUE(material.roughness.is_smooth());
  material.roughness = RoughGround(Sampler(0.0), 2, 0.1);
  EXPECT_FALSE(material.roughness.is_smooth());
  const int count = 20'000;
  double squares = 0;
  for (int i = 0; i < count; ++i) {
    const Draws draws(SamplingPlan{}, static_cast<std::uint64_t>(i));
    const FaceTilt tilt = GroundDraw(draws, MaterialSampling::per_impact, MaterialId{0}, 0).tilt_at_impact(material, 0);
    squares += std::tan(tilt.ahead) * std::tan(tilt.ahead);
  }
  const double variance = 2 * 0.1 * 0.1 / 4;
  EXPECT_LT(std::abs(squares / count - variance), 4 * variance * std::sqrt(2.0 / count));
}

}  // namespace
}  // namespace talus::roughness_test
