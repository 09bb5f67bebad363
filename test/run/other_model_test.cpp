// What the other rock model says of a sample of a run's rocks.

#include "talus/run/other_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "support/projects.hpp"

namespace talus::project {
namespace {

using testing_tools::model_of;
using testing_tools::replaced;

/// Rough; a sphere keeps rolling where a point comes to rest. Both stop at last on level ground.
const std::string slope = R"([analysis]
model = "lumped_mass"

[terrain]
section = [[0, 0], [30, -30], [400, -100], [3000, -100]]

[[material]]
name = "Rock"
normal_restitution = 0.3
tangential_restitution = 0.7
friction_angle_deg = 34
rolling_friction = 0.05

[[seeder]]
position = [1, 1]
rocks = 2000
mass_kg = { mean = 900, distribution = "uniform", rel_min = 300, rel_max = 300 }
horizontal_velocity_m_s = { mean = 2, distribution = "uniform", rel_min = 1, rel_max = 1 }
)";

std::optional<ModelComparison> comparison_of(const std::string& text, int threads = 2) {
  return compare_models(read_project_text(text, "slope.toml").project, model_of(text), threads);
}

TEST(OtherModel, IsComparedForTheSameRocks) {
  const auto found = comparison_of(slope);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->rocks, 100u);
  EXPECT_EQ(found->other, RockModel::rigid_sphere);
  EXPECT_GT(found->by_other.runout.value, 2 * found->own.runout.value);
  const auto back = comparison_of(replaced(slope, "lumped_mass", "rigid_sphere"), 1);
  ASSERT_TRUE(back);
  EXPECT_EQ(back->other, RockModel::lumped_mass);
  EXPECT_EQ(back->own.runout, found->by_other.runout) << "with the bits of a project of that model";
  EXPECT_EQ(back->by_other.top, found->own.top);
}

TEST(OtherModel, IsWarnedOfWhereItDisagrees) {
  const auto found = comparison_of(slope);
  ASSERT_TRUE(found);
  Problems warnings;
  warn_of_other_model(*found, warnings);
  ASSERT_GE(warnings.list().size(), 1u);
  EXPECT_EQ(warnings.list().front().path, "analysis.model");
  EXPECT_NE(warnings.text().find("warning: [analysis]: model = \"rigid_sphere\" gives another 95th percentile of the "
                                 "runout on plan: "),
            std::string::npos)
      << warnings.text();
  ModelComparison same = *found;
  same.by_other = same.own;
  Problems none;
  warn_of_other_model(same, none);
  EXPECT_EQ(none.text(), "");
}

TEST(OtherModel, IsNotComparedWithValuesThatNobodyChose) {
  EXPECT_FALSE(comparison_of(replaced(slope, "rolling_friction = 0.05\n", "")));
  EXPECT_FALSE(comparison_of(replaced(slope, "rocks = 2000", "rocks = 1439"))) << "a sample of 71 rocks";
  EXPECT_TRUE(comparison_of(replaced(slope, "rocks = 2000", "rocks = 1440")));
}

TEST(OtherModel, DisagreesIfIntervalsAreApartAndTheFactorIsLarge) {
  const Estimate low{10, 9, 11}, near{21, 10.5, 30}, apart{21, 15, 30}, close{15, 12, 16}, open{30, 20, {}};
  EXPECT_FALSE(disagree(low, near));
  EXPECT_TRUE(disagree(low, apart));
  EXPECT_TRUE(disagree(apart, low));
  EXPECT_FALSE(disagree(low, close));
  EXPECT_TRUE(disagree(low, open)) << "only the ends that face each other count";
}

TEST(FairSample, HasOneRockOfEachStretch) {
  for (const std::uint64_t rocks : {7U, 100U, 1441U, 100'000U}) {
    const auto sample = fair_sample(rocks, 7, 5);
    ASSERT_EQ(sample.size(), 7u);
    EXPECT_TRUE(std::ranges::is_sorted(sample));
    for (std::size_t k = 0; k < 7; ++k) {
      EXPECT_GE(sample[k] + 1, rocks / 7 * k);
      EXPECT_LT(sample[k], rocks / 7 * (k + 1) + 7);
    }
    EXPECT_LT(sample.back(), rocks);
  }
  EXPECT_NE(fair_sample(100'000, 7, 5), fair_sample(100'000, 7, 6));
}

}  // namespace
}  // namespace talus::project
