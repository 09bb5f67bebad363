#include "talus/barriers/barrier_check.hpp"

#include <gtest/gtest.h>

namespace talus::barrier_check_test {
namespace {

/// A survey of average quality, restitutions from literature, moderate consequences.
CheckFactors usual() {
  CheckFactors factors;
  factors.velocity = factors.height = 1.10 * 1.02;
  factors.mass = 1.05;
  factors.energy = 1.10;
  factors.capacity = 1.2;
  factors.elongation = 1.3;
  factors.clearance = 0.5;
  factors.clears_half_the_block = true;
  return factors;
}

TEST(BarrierCheck, AgreesWithAHandCalculation) {
  // 2 t at 20 m/s: 400 kJ. gamma_F = 1.1 x 1.02 = 1.122, v_d = 22.44 m/s, m_d = 2100 kg,
  // E_d = 0.5 x 2100 x 22.44^2 x 1.1 = 581 604.408 J, times 1.2 for MEL.
  const double energy = energy_to_check(usual(), 400e3, 450e3, 20);
  EXPECT_EQ(energy, 400e3);
  EXPECT_NEAR(needed_maximum_energy(usual(), energy), 697925.2896, 1e-6);
  EXPECT_EQ(needed_class(usual(), needed_maximum_energy(usual(), energy)), 3);
  // The centre, 3.45 m x 1.122 = 3.8709 m, and 0.5 m above, or the radius of a larger block: 3.8 m x 1.122 + 0.8 m.
  EXPECT_NEAR(needed_height(usual(), 3, 0.45), 4.3709, 1e-12);
  EXPECT_NEAR(needed_height(usual(), 3, 0.80), 5.0636, 1e-12);
  EXPECT_NEAR(*needed_clearance(usual(), 5), 6.5, 1e-12);
  EXPECT_NEAR(*most_elongation(usual(), 6.5), 5, 1e-12);
}

// Separate factors on energy and height, as in ONR 24810: neither touches the other.
TEST(BarrierCheck, MayHaveSeparateFactorsOnEnergyAndHeight) {
  CheckFactors factors;
  factors.energy = 1.25;
  EXPECT_EQ(needed_maximum_energy(factors, 400e3), 500e3);
  EXPECT_EQ(needed_height(factors, 3, 0.5), 4);
  factors.height = 1.5;
  EXPECT_EQ(needed_maximum_energy(factors, 400e3), 500e3);
  EXPECT_EQ(needed_height(factors, 3, 0.5), 6);
}

TEST(BarrierCheck, UsesTheDesignBlockIfGiven) {
  CheckFactors factors = usual();
  factors.block_mass = 3000;
  EXPECT_EQ(energy_to_check(factors, 400e3, 450e3, 20), 600e3);
  EXPECT_NEAR(radius_to_check(factors, 375, 0.5), 1.0, 1e-12) << "eight times the mass, of the same density";
  factors.block_mass.reset();
  EXPECT_EQ(radius_to_check(factors, 375, 0.5), 0.5);
  factors.takes_total_energy = true;
  EXPECT_EQ(energy_to_check(factors, 400e3, 450e3, 20), 450e3);
}

TEST(BarrierCheck, OfTheServiceLevelNeedsThreeTimesTheEnergyAsMEL) {
  CheckFactors factors = usual();
  factors.capacity = 1;
  const double once = needed_maximum_energy(factors, 100e3);
  factors.level = KitLevel::service;
  EXPECT_DOUBLE_EQ(needed_maximum_energy(factors, 100e3), 3 * once);
  EXPECT_EQ(needed_class(factors, 50e3), 1) << "kits of class 0 have no SEL";
  // SEL 330 and 660 kJ of the classes 3 and 5 are less than a third of their MEL.
  EXPECT_EQ(needed_class(factors, 3 * 330e3), 3);
  EXPECT_EQ(needed_class(factors, 3 * 331e3), 4);
  EXPECT_EQ(needed_class(factors, 3 * 661e3), 6);
  EXPECT_EQ(needed_class(factors, 3 * 1500e3), 7);
  EXPECT_EQ(needed_class(factors, 3 * 1501e3), 8);
  EXPECT_EQ(needed_class(usual(), 50e3), 0);
}

TEST(BarrierCheck, WithoutFactorsIsNeutral) { EXPECT_EQ(needed_maximum_energy({}, 123456.7), 123456.7); }

// A clearance that holds half the block is counted from its centre, so that the block counts once.
TEST(BarrierCheck, CountsTheBlockOnce) {
  CheckFactors from_top, from_centre;
  from_centre.clears_half_the_block = true;
  EXPECT_EQ(needed_height(from_top, 2.5, 0.75), 4) << "its top";
  EXPECT_EQ(needed_height(from_centre, 2.5, 0.75), 4);
  from_top.clearance = from_centre.clearance = 1;
  EXPECT_EQ(needed_height(from_top, 2.5, 0.75), 5) << "above the top";
  EXPECT_EQ(needed_height(from_centre, 2.5, 0.75), 4.25) << "above the centre";
}

TEST(KitClass, AgreesWithTheAssessmentDocument) {
  const double least[] = {100e3, 250e3, 500e3, 1000e3, 1500e3, 2000e3, 3000e3, 4500e3};
  EXPECT_EQ(needed_class({}, 0), 0);
  EXPECT_EQ(kit_class_of(99e3), std::nullopt);
  for (int k = 0; k < 8; ++k) {
    EXPECT_EQ(kit_class_of(least[k]), k);
    EXPECT_EQ(kit_class_of(least[k] + 1), k == 7 ? 8 : k) << "a kit has the highest class that it fulfils";
    EXPECT_EQ(needed_class({}, least[k]), k);
    EXPECT_EQ(needed_class({}, least[k] + 1), k + 1);
  }
  EXPECT_EQ(kit_class_of(1e9), 8);
  EXPECT_EQ(needed_class({}, 1e9), 8);
}

}  // namespace
}  // namespace talus::barrier_check_test
