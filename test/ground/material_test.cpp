#include "talus/ground/material.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/scenes.hpp"

namespace talus::material_test {
namespace {

using namespace testing_tools;

Material varying() {
  Material material;
  material.name = "varying";
  Distribution uniform;
  uniform.kind = DistributionKind::uniform;
  uniform.mean = 0.5;
  uniform.rel_min = uniform.rel_max = 0.4;
  const Sampler sampler(uniform, Bounds{0, 1});
  material.normal_restitution = material.tangential_restitution = sampler;
  material.friction_angle = material.dynamic_friction = material.rolling_friction = sampler;
  material.roughness = sampler;
  return material;
}

TEST(Ground, OneMaterialIsEverywhere) {
  const Ground ground = ground_of({});
  EXPECT_EQ(ground.material_of(0), MaterialId{0});
  EXPECT_EQ(ground.material_of(123456), MaterialId{0});
  EXPECT_EQ(ground[MaterialId{0}].name, "test");
}

TEST(Ground, MaterialsAreAssignedByTheNumbersOfTheTerrain) {
  Material a = material_of({}), b = material_of({});
  b.name = "other";
  const Ground ground({a, b}, {MaterialId{1}, MaterialId{0}, MaterialId{1}});
  EXPECT_EQ(ground[ground.material_of(0)].name, "other");
  EXPECT_EQ(ground[ground.material_of(1)].name, "test");
  EXPECT_EQ(ground.materials().size(), 2U);
}

TEST(Ground, CellsOfARasterNeedAByteEach) {
  Material a = material_of({}), b = material_of({});
  b.name = "other";
  const Ground ground({a, b}, std::vector<std::uint8_t>{1, 0, 1});
  EXPECT_EQ(ground.material_of(0), MaterialId{1});
  EXPECT_EQ(ground.material_of(1), MaterialId{0});
  EXPECT_EQ(ground.material_of(2), MaterialId{1});
  EXPECT_EQ(ground.bytes(), 3U);
}

TEST(Ground, OneMaterialEverywhereNeedsNoMemory) {
  const std::vector<Material> three(3, material_of({}));
  for (const Ground& ground : {Ground(three, std::vector<std::uint8_t>(1000, 2)), Ground(three, MaterialId{2})}) {
    EXPECT_EQ(ground.material_of(0), MaterialId{2});
    EXPECT_EQ(ground.material_of(999), MaterialId{2});
    EXPECT_EQ(ground.bytes(), 0U);
  }
}

TEST(GroundDraw, ConstantsNeedNoDraw) {
  Soil soil;
  const Material material = material_of(soil);
  const Draws draws(SamplingPlan{}, 7);
  const GroundDraw draw(draws, MaterialSampling::per_impact, MaterialId{0}, 4);
  EXPECT_EQ(draw.restitution(material)[0], soil.rn);
  EXPECT_EQ(draw.restitution(material)[1], soil.rt);
  EXPECT_EQ(draw.friction_angle(material), soil.phi);
  EXPECT_EQ(draw.dynamic_friction(material), soil.mu);
  EXPECT_EQ(draw.rolling_friction(material), soil.rolling);
  EXPECT_EQ(draw.tilt_at_impact(material, 4).ahead, 0);
}

TEST(GroundDraw, PerImpactEveryContactIsANewDraw) {
  const Material material = varying();
  const Draws draws(SamplingPlan{}, 7);
  const auto rn = [&](std::uint32_t contact) {
    return GroundDraw(draws, MaterialSampling::per_impact, MaterialId{0}, contact).restitution(material)[0];
  };
  EXPECT_NE(rn(0), rn(1));
  EXPECT_EQ(rn(1), rn(1));
}

TEST(GroundDraw, PerRockAMaterialIsTheSameAtEveryContact) {
  const Material material = varying();
  const Draws draws(SamplingPlan{}, 7), other_rock(SamplingPlan{}, 8);
  const auto draw = [&](const Draws& d, std::uint32_t id, std::uint32_t contact) {
    return GroundDraw(d, MaterialSampling::per_rock, MaterialId{id}, contact);
  };
  EXPECT_EQ(draw(draws, 0, 1).restitution(material), draw(draws, 0, 5).restitution(material));
  EXPECT_EQ(draw(draws, 0, 1).friction_angle(material), draw(draws, 0, 5).friction_angle(material));
  EXPECT_NE(draw(draws, 0, 1).restitution(material), draw(draws, 1, 1).restitution(material));
  EXPECT_NE(draw(draws, 0, 1).restitution(material), draw(other_rock, 0, 1).restitution(material));
  // Roughness is drawn at every contact.
  EXPECT_NE(draw(draws, 0, 1).tilt_at_impact(material, 1).ahead, draw(draws, 0, 5).tilt_at_impact(material, 5).ahead);
  EXPECT_NE(draw(draws, 0, 1).met_face(material, 1, 0.5, 0.5, true)->ahead,
            draw(draws, 0, 5).met_face(material, 5, 0.5, 0.5, true)->ahead);
}

// Ahead, angles have the given distribution; aside, its mixture with its mirror image, or rocks would drift to one
// side.
TEST(GroundDraw, RoughGroundIsSymmetricAside) {
  Material material;
  Distribution tilt;
  tilt.kind = DistributionKind::normal;
  tilt.mean = 0.1;
  tilt.std_dev = 0.02;
  material.roughness = Sampler(tilt, Bounds{});
  constexpr int rocks = 20'000;
  double ahead = 0, aside = 0, squares = 0, product = 0;
  for (std::uint64_t rock = 0; rock < rocks; ++rock) {
    const Draws draws(SamplingPlan{}, rock);
    const auto [x, y] = GroundDraw(draws, MaterialSampling::per_impact, MaterialId{0}, 3).tilt_at_impact(material, 3);
    ahead += x / rocks;
    aside += y / rocks;
    squares += y * y / rocks;
    product += (x - 0.1) * y / rocks;
  }
  const double error = 5 / std::sqrt(1.0 * rocks);
  EXPECT_NEAR(ahead, 0.1, 0.02 * error);
  EXPECT_NEAR(aside, 0, 0.102 * error);
  EXPECT_NEAR(squares, 0.1 * 0.1 + 0.02 * 0.02, 2 * 0.1 * 0.02 * error);
  EXPECT_NEAR(product, 0, 0.02 * 0.102 * error);
}

TEST(GroundDraw, PropertiesOfOneContactAreIndependent) {
  const Material material = varying();
  const Draws draws(SamplingPlan{}, 7);
  const GroundDraw draw(draws, MaterialSampling::per_impact, MaterialId{0}, 2);
  const auto [rn, rt] = draw.restitution(material);
  const double values[] = {rn, rt, draw.friction_angle(material), draw.dynamic_friction(material),
                           draw.rolling_friction(material)};
  for (std::size_t i = 0; i < 5; ++i) {
    for (std::size_t k = i + 1; k < 5; ++k) EXPECT_NE(values[i], values[k]);
  }
}

}  // namespace
}  // namespace talus::material_test
