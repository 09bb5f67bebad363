#include "talus/verification/observed.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "talus/model/model.hpp"
#include "talus/project/read.hpp"

namespace talus::verification {
namespace {

Model model_of(std::string_view text) {
  project::Reading reading = project::read_project_text(text, "test.toml");
  return project::build_model(reading.project, reading.warnings);
}

// A rock that drops 4.9 m onto a level plane with no restitution.
constexpr std::string_view drop = R"(
[analysis]
gravity_m_s2 = 9.8
energy_datum_m = 0
[terrain]
section = [[100000, 0], [100020, 0]]
[[material]]
name = "Mud"
normal_restitution = 0
[[seeder]]
position = [100010, 4.9]
mass_kg = 2
)";

TEST(PathOf, HasTheRowsOfAReplayInUserCoordinates) {
  const std::vector<Event> path = path_of(model_of(drop), 0);
  ASSERT_GE(path.size(), 3u);
  EXPECT_DOUBLE_EQ(*value(PathQuantity::x, path[0], &path[1]), 100010);
  EXPECT_NEAR(*value(PathQuantity::time_to_next, path[0], &path[1]), 1, 1e-12);
  EXPECT_NEAR(*value(PathQuantity::vz, path[1], nullptr), -9.8, 1e-12);
  EXPECT_NEAR(*value(PathQuantity::potential_J, path[0], nullptr), 2 * 9.8 * 4.9, 1e-9);
  EXPECT_NEAR(*value(PathQuantity::kinetic_kJ, path[1], nullptr), 0.09604, 1e-9);
  EXPECT_NEAR(*value(PathQuantity::total_J, path[1], nullptr), *value(PathQuantity::total_J, path[0], nullptr), 1e-9);
  EXPECT_FALSE(value(PathQuantity::time_to_next, path.back(), nullptr));
}

TEST(PathOf, ShowsWhereARockTurnsBack) {
  // It slides up a frictionless slope of 45 degrees and returns.
  const Model model = model_of(R"(
[analysis]
rotation = false
sliding = "closed_form"
[terrain]
section = [[0, 0], [20, 20]]
[[material]]
name = "Ice"
normal_restitution = 0
tangential_restitution = 1
friction_angle_deg = 0
[[seeder]]
position = [5, 5.01]
mass_kg = 2
horizontal_velocity_m_s = 5
)");
  const std::vector<Event> path = path_of(model, 0);
  const auto turning =
      std::ranges::find_if(path, [](const Event& event) { return event.motion.velocity.norm() < 1e-9; });
  ASSERT_NE(turning, path.end());
  EXPECT_GT(turning->motion.position.x(), 5.2);
  EXPECT_LT(path.back().motion.position.x(), 5);
}

TEST(Observe, CollectsOneValuePerRockInOrder) {
  Model model = model_of(
      std::string(drop) +
      "rocks = 600\nhorizontal_velocity_m_s = { mean = 2, distribution = \"uniform\", rel_min = 1, rel_max = 1 }\n");
  const Observed observed = observe(model, Energies::watch);
  EXPECT_EQ(observed.rocks, 600u);
  ASSERT_EQ(observed.sample(SampleQuantity::end_x_m).size(), 600u);
  EXPECT_TRUE(observed.sample(SampleQuantity::barrier_height_m).empty());
  for (const std::uint64_t rock : {0u, 255u, 256u, 599u}) {
    EXPECT_EQ(observed.sample(SampleQuantity::end_x_m)[rock], path_of(model, rock).back().motion.position.x()) << rock;
    EXPECT_NEAR(observed.sample(SampleQuantity::runout_xy_m)[rock],
                observed.sample(SampleQuantity::end_x_m)[rock] - 100010, 1e-10);
  }
  EXPECT_LT(observed.max_energy_rise, 1e-12);
  std::uint64_t ended = 0;
  for (const std::uint64_t count : observed.ends) ended += count;
  EXPECT_EQ(ended, 600u);
}

TEST(PathQuantity, NamesGoBothWays) {
  for (const std::string_view word : path_quantity_names()) EXPECT_EQ(name(*path_quantity_of(word)), word);
  EXPECT_EQ(path_quantity_of("w"), std::nullopt);
  for (const std::string_view word : sample_quantity_names()) EXPECT_EQ(name(*sample_quantity_of(word)), word);
  EXPECT_EQ(sample_quantity_of("runout"), std::nullopt);
}

}  // namespace
}  // namespace talus::verification
