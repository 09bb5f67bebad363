// Many rocks in forests and on soft ground, on rough slopes: runouts, and what must be true of every path.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "support/meshes.hpp"
#include "support/scenes.hpp"
#include "trajectory/forest_scenes.hpp"

namespace talus::drag_on_slopes_test {
namespace {

using namespace testing_tools;

constexpr double g = standard_gravity;

// A rough slope above a plain where every rock stops.
Shape slope_and_plain(Dice& dice) {
  return irregular_field(dice, 40, 12, 400, 60,
                         [&](double x, double) { return std::max(0.0, 70 - 0.7 * x) + dice.between(-0.4, 0.4); });
}

std::vector<double> runouts(const TriangleMesh& mesh, const Ground& ground, RockModel model,
                            std::uint64_t rocks = 150) {
  std::vector<double> list;
  Dice dice(6);
  for (std::uint64_t number = 0; number < rocks; ++number) {
    const double x = dice.between(3, 8), y = dice.between(10, 50);
    const Release release =
        launched(dice.magnitude(100, 3000), {x, y, *mesh.elevation(x, y) + 3}, {dice.between(0, 4), 0, 0});
    Laws laws;
    set_model(laws, model);
    const RockOutcome outcome = follow(mesh, ground, laws, release, {}, number).outcome;
    list.push_back((outcome.end.position - outcome.start.position).xy().norm());
  }
  std::sort(list.begin(), list.end());
  return list;
}

/// The percentiles, 5 % apart, in which the first of two sorted samples is larger by more than chance: the order
/// statistics two standard deviations of their number below it, and above that of the second, still are.
std::vector<std::size_t> larger_percentiles(const std::vector<double>& first, const std::vector<double>& second) {
  std::vector<std::size_t> found;
  const auto rocks = static_cast<double>(first.size());
  for (std::size_t percent = 5; percent < 100; percent += 5) {
    const double p = static_cast<double>(percent) / 100, chance = 2 * std::sqrt(rocks * p * (1 - p));
    const double last = rocks - 1;
    const auto low = static_cast<std::size_t>(std::max(0.0, rocks * p - chance));
    const auto high = static_cast<std::size_t>(std::min(last, rocks * p + chance));
    if (first[low] > second[high]) found.push_back(percent);
  }
  return found;
}

TEST(Forest, StopsRocksEarlierInEveryPercentile) {
  Dice dice(7);
  const TriangleMesh mesh = slope_and_plain(dice).mesh();
  const Soil soil{.rn = 0.35, .rt = 0.85, .phi = 0.5, .rolling = 0.3, .roughness = 0.05};
  constexpr std::uint64_t rocks = 500;
  for (const RockModel model : {RockModel::lumped_mass, RockModel::rigid_sphere}) {
    std::vector<std::vector<double>> by_density;
    for (const double drag : {0.0, 250.0, 500.0, 750.0}) {
      by_density.push_back(runouts(mesh, Ground(grown_over(soil, drag, 15)), model, rocks));
    }
    for (std::size_t k = 1; k < by_density.size(); ++k) {
      EXPECT_THAT(larger_percentiles(by_density[k], by_density[k - 1]), testing::IsEmpty()) << k;
      // The comparison can fail: it does in the wrong order.
      EXPECT_THAT(larger_percentiles(by_density[k - 1], by_density[k]), testing::Not(testing::IsEmpty())) << k;
    }
  }
}

TEST(SoftGround, StopsRocksEarlier) {
  Dice dice(8);
  const TriangleMesh mesh = slope_and_plain(dice).mesh();
  Material material = material_of({.rn = 0.2, .rt = 0.85, .phi = 0.45, .rolling = 0.2});
  for (const RockModel model : {RockModel::lumped_mass, RockModel::rigid_sphere}) {
    material.ground_drag = 0;
    const auto hard = runouts(mesh, Ground(material), model);
    material.ground_drag = 0.9;
    const auto soft = runouts(mesh, Ground(material), model);
    for (const std::size_t percent : {25U, 50U, 75U, 95U}) {
      const std::size_t at = percent * hard.size() / 100;
      EXPECT_LT(soft[at], hard[at]) << percent << " %";
    }
  }
}

// In any forest, with barriers: energy never rises, time never decreases, no rock is lost, and the pieces of a path
// join.
TEST(Forest, EveryPathIsConsistent) {
  Dice dice(9);
  std::size_t dragged = 0, hits = 0;
  for (int slope = 0; slope < 6; ++slope) {
    const TriangleMesh mesh = random_slope(dice, 20, 60, dice.between(0.3, 1), dice.between(0.2, 1)).mesh();
    std::vector<MaterialId> of_facet;
    for (std::size_t k = 0; k < mesh.facet_count(); ++k) of_facet.push_back({dice.chance(0.6) ? 1U : 0U});
    std::vector<Barrier> barriers(2);
    barriers[0].capacity = 40e3;
    barriers[0].restitution = Restitution{0.4, 0.8};
    barriers[0].set_panels(panels_over(mesh.draped({40, 0}, {40, 60}), 1.5, 0));
    barriers[1].is_collector = true;
    barriers[1].set_panels(panels_over(mesh.draped({30, 0}, {30, 60}), 4, 0));
    for (std::uint64_t number = 0; number < 150; ++number) {
      Laws laws;
      const RockModel model = dice.chance(0.5) ? RockModel::lumped_mass : RockModel::rigid_sphere;
      set_model(laws, model, dice.chance(0.5));
      laws.sliding = dice.chance(0.5) ? SlidingMethod::stepped : SlidingMethod::closed_form;
      const Soil soil{dice.between(0, 0.8), dice.between(0.1, 1), dice.between(0.1, 0.8), dice.between(0.1, 0.8), 0.1};
      Material open = material_of(soil), wood = grown_over(soil, dice.magnitude(10, 5000), dice.between(0.3, 20));
      wood.ground_drag = dice.chance(0.5) ? dice.magnitude(0.01, 30) : 0;
      const Ground ground(std::vector<Material>{open, wood}, of_facet);
      const double x = dice.between(5, 30), y = dice.between(10, 50);
      const Release release =
          launched(dice.magnitude(1, 1e4), {x, y, *mesh.elevation(x, y) + dice.between(1.5, 12)}, dice.in_cube(10));
      RockLog log(true, true);
      const Draws draws(SamplingPlan{}, number);
      const RockOutcome outcome = follow_rock(Scene<TriangleMesh>{mesh, ground, barriers, laws}, release, draws, log);
      const std::string label = "slope " + std::to_string(slope) + " rock " + std::to_string(number);
      ASSERT_NE(outcome.reason, EndReason::lost) << label;
      const double scale = 1e-10 * release.rock.mass * g * 100, slack = 64 * contact_slack * release.rock.mass * g;
      for (std::size_t k = 1; k < log.rows.size(); ++k) {
        const Motion &before = log.rows[k - 1].motion, &after = log.rows[k].motion;
        ASSERT_TRUE(is_finite(after)) << label;
        ASSERT_GE(after.time, before.time) << label;
        ASSERT_LE(total_energy(after, release.rock, laws.gravity),
                  total_energy(before, release.rock, laws.gravity) + scale + slack)
            << label << " row " << k;
      }
      const std::vector<PathPiece> pieces = every_piece(log);
      for (std::size_t k = 0; k < pieces.size(); ++k) {
        const PathPiece& piece = pieces[k];
        if (piece.drag.rate > 0) ++dragged;
        const bool is_last = k + 1 == pieces.size();
        const Motion& next = outcome.end;
        const Vec3 begins = is_last ? next.position : pieces[k + 1].path.p;
        // (A sphere that has sunk in slightly is lifted onto the ground.)
        ASSERT_LT((piece.path.at(piece.duration) - begins).norm(), piece.on_ground ? 1e-4 : 1e-9)
            << label << " piece " << k;
        ASSERT_NEAR(piece.time(piece.duration), is_last ? next.time : pieces[k + 1].start_time, 1e-9) << label;
      }
      // A rock meets a barrier once at a time; but after a rebound uphill it may return within the same step, and then
      // stops there.
      for (std::size_t k = 1; k < log.hits.size(); ++k) {
        const bool again = log.hits[k].barrier == log.hits[k - 1].barrier;
        const bool leans = std::abs(log.hits[k].motion.velocity.x()) < 1e-3 ||  // along the barrier, which is along y
                           log.hits[k].outcome == BarrierOutcome::stopped;
        ASSERT_FALSE(again && !leans && log.hits[k].motion.time - log.hits[k - 1].motion.time < 1e-7) << label;
      }
      hits += log.hits.size();
    }
  }
  EXPECT_GT(dragged, 5000U);
  EXPECT_GT(hits, 300U);
}

TEST(Forest, PathsAreReproducible) {
  Dice dice(10);
  const TriangleMesh mesh = random_slope(dice, 20, 60, 0.8, 0.8).mesh();
  const Ground trees(grown_over({.roughness = 0.1}, 400, 8));
  for (std::uint64_t number = 0; number < 20; ++number) {
    const double x = dice.between(10, 30), y = dice.between(10, 50);
    const Release release = launched(700, {x, y, *mesh.elevation(x, y) + 5}, dice.in_cube(6));
    const Followed once = follow(mesh, trees, {}, release, {}, number),
                   again = follow(mesh, trees, {}, release, {}, number);
    ASSERT_EQ(once.log.rows.size(), again.log.rows.size());
    EXPECT_EQ(once.outcome.end.position, again.outcome.end.position);
    EXPECT_EQ(once.outcome.end.time, again.outcome.end.time);
  }
}

}  // namespace
}  // namespace talus::drag_on_slopes_test
