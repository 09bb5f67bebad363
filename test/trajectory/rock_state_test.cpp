// A rock's future is a function of its state: a run that goes on from a copy of the bytes ends where the rock does.

#include "talus/trajectory/rock_state.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cstring>
#include <optional>

#include "support/meshes.hpp"
#include "support/scenes.hpp"
#include "talus/core/stop.hpp"
#include "talus/trajectory/rock_run.hpp"

namespace talus::rock_state_test {
namespace {

using namespace testing_tools;
using RunOnMesh = RockRun<TriangleMesh>;

// To its end, or to the place where it notices the stop: after at most 64 flights and legs.
RunOnMesh::Pause advance(RunOnMesh& run, const StopScope* stop) {
  RunOnMesh::Pause pause = run.advance(stop);
  while (pause == RunOnMesh::Pause::gliding) {
    while (run.step_glide()) {
    }
    pause = run.advance(stop);
  }
  return pause;
}

RockState copy_of_bytes(const RockState& state) {
  RockState copy;
  std::memcpy(static_cast<void*>(&copy), &state, sizeof state);
  return copy;
}

TEST(RockState, ACopyOfItsBytesGoesOnAsTheRockDoes) {
  Dice dice(733);
  const std::atomic<bool> requested{true};
  std::size_t copies = 0;
  for (int number = 0; number < 300; ++number) {
    const TriangleMesh mesh = random_slope(dice, 16, 60, 0.7, 0.6).mesh();
    Laws laws;
    set_model(laws, number % 2 == 0 ? RockModel::rigid_sphere : RockModel::lumped_mass);
    Soil soil{.rn = 0.4, .rt = 0.85, .phi = 0.45, .mu = 0.6, .rolling = 0.05};
    if (number % 3 == 0) {
      soil.roughness = 0.1;
      soil.bump_spacing = 2;
    }
    const Ground ground = ground_of(soil);
    const Scene<TriangleMesh> scene{mesh, ground, {}, laws};
    Release release;
    release.rock = sphere_of_diameter(dice.between(0.4, 1.5), 2700);
    const double x = dice.between(5, 12), y = dice.between(10, 50);
    const auto z = mesh.elevation(x, y);
    if (!z) continue;
    release.motion.position = {x, y, *z + release.rock.radius * 1.5 + dice.between(0, 4)};
    release.motion.velocity = {dice.between(0, 3), dice.between(-1, 1), 0};
    const Draws draws(SamplingPlan{}, static_cast<std::uint64_t>(number));
    RockLog log{false};
    RunOnMesh whole(scene, release, draws, log);
    ASSERT_EQ(advance(whole, nullptr), RunOnMesh::Pause::ended);

    const StopScope stop(&requested);
    std::optional<RunOnMesh> run(std::in_place, scene, release, draws, log);
    while (advance(*run, &stop) == RunOnMesh::Pause::stopped) {
      const RockState copy = copy_of_bytes(run->state());
      run.emplace(scene, release, copy, draws, log);
      ++copies;
    }
    const Motion &end = run->outcome().end, &expected = whole.outcome().end;
    ASSERT_EQ(run->outcome().reason, whole.outcome().reason) << number;
    ASSERT_EQ(end.position, expected.position) << number;
    ASSERT_EQ(end.spin, expected.spin) << number;
    ASSERT_EQ(end.time, expected.time) << number;
  }
  EXPECT_GT(copies, 150U);
}

}  // namespace
}  // namespace talus::rock_state_test
